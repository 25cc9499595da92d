#pragma once
/// Reads slip that no traction changes: given node by node, by velocities of the bodies beyond creepages and spin, and
/// by displacements given elsewhere.

#include "contact/prepare/preparation.hpp"

namespace rollcon {

/// Reads the scene's slip, and finds creepages that follow from velocities. poses: revisions for bodies with a surface.
void read_slip(Preparation& preparation, const Scene& scene, const Preparation::Poses& poses);

}  // namespace rollcon
