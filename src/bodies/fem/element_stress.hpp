#pragma once
/// Stresses of one finite element under displacements of its nodes: those that its stiffness balances.

#include <array>
#include <span>
#include <vector>

#include "bodies/fem/element_stiffness.hpp"

namespace rollcon::fem {

/// Points of the stiffness's rule.
int stress_points(VolumeType type, Hex8 hex8);

/// stress[6 * q + c] (11, 22, 33, 12, 13, 23; E = 1) and place[3 * q + c] at the points; either may be null.
/// u[3 * node + c]. Returns the element's volume.
double element_stress(VolumeType type, std::span<const Vec3> x, double poisson, Hex8 hex8, const double* u,
                      double* stress, double* place);

/// node x point: from values at the points to those at the nodes of the function nearest to them of those that the
/// element's corners have (linear, or linear in each direction). Where quadratic elements are most accurate this
/// function meets their stresses.
const std::vector<double>& to_nodes(VolumeType type, Hex8 hex8);

}  // namespace rollcon::fem
