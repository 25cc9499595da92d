#pragma once
/// Nodes of the frame that the bodies' supports keep from moving: the monolithic equations would be
/// singular there.

#include "mesh/frame.hpp"
#include "procedures/monolithic_bodies.hpp"

namespace rollcon {

/// Throws err_state for a node held along its normal, err_unsupported for one held along a tangent
/// (a plane of symmetry), which the condensed form can treat.
void refuse_held_nodes(const MonolithicBodies& bodies, const Frame& frame);

}  // namespace rollcon
