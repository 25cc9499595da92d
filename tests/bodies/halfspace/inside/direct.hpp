#pragma once
/// Computes an independent reference for what is inside a half-space: the formulas of Boussinesq and Cerruti in K. L.
/// Johnson's Contact Mechanics ((3.18), (3.75), in x, y, z and R), summed over nested Gauss rules that are cut until
/// every part is far from the observer. It has nothing in common with the library but the shape functions.

#include <array>
#include <vector>

#include "mesh/frame.hpp"

namespace rollcon::inside {

/// Holds xx, yy, zz, xy, xz, yz of the stress and x, y, z of the displacement.
using Values = std::array<double, 9>;

struct Solid {
  double shear, poisson;
};

/// Returns the values of forces f at the origin of the surface, at a point of the body z >= 0.
Values point_force(const Solid& solid, const std::array<double, 3>& f, double x, double y, double z);

/// Takes traction[3 * node + j], z into the body, with z > 0.
Values direct(const Frame& frame, const std::vector<double>& traction, const Solid& solid, double x, double y,
              double z);

/// Has the library compute these values, point by point in one call.
std::vector<Values> from_library(const Frame& frame, const std::vector<double>& traction, const Solid& solid,
                                 const std::vector<std::array<double, 3>>& points, double accuracy);

/// Returns random tractions between -1 and 1.
std::vector<double> random_load(const Frame& frame, std::uint32_t seed);

/// Returns the largest difference of the stresses.
double stress_difference(const Values& a, const Values& b);
/// Returns the largest difference of the displacements.
double motion_difference(const Values& a, const Values& b);

}  // namespace rollcon::inside
