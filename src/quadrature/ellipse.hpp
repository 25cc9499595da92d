#pragma once
/// Where an integrand stops being analytic: Bernstein's ellipses.

#include "mesh/vec3.hpp"

namespace rollcon::quadrature {

/// Half the sum of the distances of the foci -1 and 1 from the complex root nearest to [-1, 1] of X(z).X(z), X the
/// parabola through three points at z = -1, 0, 1. At least 1.
double ellipse_axis(const Vec3& first, const Vec3& middle, const Vec3& last);

/// log of the parameter rho of the ellipse with this half-axis; positive.
double log_rho(double axis);

}  // namespace rollcon::quadrature
