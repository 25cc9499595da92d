#pragma once
/// Slip that no traction changes: given node by node, by velocities of the bodies beyond creepages and spin, and by
/// displacements given elsewhere.

#include "contact/prepare/preparation.hpp"

namespace rollcon {

/// poses: of bodies with a surface. Also finds the creepages that follow from velocities.
void read_slip(Preparation& preparation, const Scene& scene, const Preparation::Poses& poses);

}  // namespace rollcon
