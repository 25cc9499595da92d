#pragma once
/// Computes the stresses of one finite element under displacements of its nodes that its stiffness balances.

#include <array>
#include <span>
#include <vector>

#include "bodies/fem/element_stiffness.hpp"

namespace rollcon::fem {

/// Returns the number of points of the stiffness's rule.
int stress_points(VolumeType type, Hex8 hex8);

/// Computes stress[6 * q + c] (11, 22, 33, 12, 13, 23; E = 1) and place[3 * q + c] at the points under displacements
/// u[3 * node + c]; either result may be null. Returns the element's volume.
double element_stress(VolumeType type, std::span<const Vec3> x, double poisson, Hex8 hex8, const double* u,
                      double* stress, double* place);

/// Returns the matrix, node x point, that takes values at the points to the nodal values of the function nearest to
/// them that is linear, or linear in each direction, as the corners' shape functions are. Where quadratic elements are
/// most accurate this function meets their stresses.
const std::vector<double>& to_nodes(VolumeType type, Hex8 hex8);

}  // namespace rollcon::fem
