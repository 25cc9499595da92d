#pragma once
/// Finds different nodes of a mesh at one place.

#include <cstdint>
#include <span>

#include "mesh/vec3.hpp"

namespace rollcon {

/// Fails when two nodes are closer than 1e-6 of the distance to the other nodes of their elements, rounding of the
/// coordinates allowed for. That distance is given by node in `nearest`, infinite for nodes of no element, which are
/// not looked at. The text `where` is that of Tally::fail_if_any.
void check_coinciding_nodes(std::span<const Vec3> node, std::span<const double> nearest, std::int32_t index_base,
                            const char* where);

}  // namespace rollcon
