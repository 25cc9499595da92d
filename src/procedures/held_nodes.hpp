#pragma once
/// Finds nodes of the frame that the bodies' supports keep from moving, where the monolithic equations would be
/// singular.

#include "bodies/model/expanded_compliance.hpp"
#include "mesh/frame.hpp"

namespace rollcon {

/// Throws err_state for a node held along its normal, err_unsupported for one held along a tangent (a plane of
/// symmetry), which the condensed form can treat.
void refuse_held_nodes(const ExpandedCompliance& expanded, const Frame& frame);

}  // namespace rollcon
