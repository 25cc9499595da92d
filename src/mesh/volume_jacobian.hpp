#pragma once
/// Finds volume elements that are turned inside out, flat or folded.

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/vec3.hpp"
#include "mesh/volume_mesh.hpp"

namespace rollcon {

/// Throws check_volume's Error(err_mesh) for the shapes of elements: two nodes at one place, no volume, turned inside
/// out, Jacobian not positive everywhere. It looks at the nodes, the points of the stiffness's rule and a lattice with
/// spacing of a quarter of quadratic elements and half of linear ones. Slender elements are allowed. Returns for each
/// node the distance to the nearest other node of its elements.
std::vector<double> check_shapes(std::span<const Vec3> node, const VolumeElements& volume, std::int32_t index_base);

}  // namespace rollcon
