#pragma once
/// Independent reference for what is inside a half-space: the formulas of Boussinesq and Cerruti as K. L. Johnson,
/// Contact Mechanics, has them ((3.18), (3.75), in x, y, z and R), summed over nested Gauss rules that are cut until
/// every part is far from the observer. Shares nothing with the library but the shape functions.

#include <array>
#include <vector>

#include "mesh/frame.hpp"

namespace rollcon::inside {

/// xx, yy, zz, xy, xz, yz of the stress; x, y, z of the displacement.
using Values = std::array<double, 9>;

struct Solid {
  double shear, poisson;
};

/// Of forces f at the origin of the surface, at a point of the body z >= 0.
Values point_force(const Solid& solid, const std::array<double, 3>& f, double x, double y, double z);

/// traction[3 * node + j], z into the body. z > 0.
Values direct(const Frame& frame, const std::vector<double>& traction, const Solid& solid, double x, double y,
              double z);

/// The same from the library, point by point in one call.
std::vector<Values> from_library(const Frame& frame, const std::vector<double>& traction, const Solid& solid,
                                 const std::vector<std::array<double, 3>>& points, double accuracy);

/// Random ones between -1 and 1.
std::vector<double> random_load(const Frame& frame, std::uint32_t seed);

/// Largest difference of the stresses.
double stress_difference(const Values& a, const Values& b);
/// Largest difference of the displacements.
double motion_difference(const Values& a, const Values& b);

}  // namespace rollcon::inside
