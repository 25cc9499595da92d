#pragma once
/// Finds where an integrand stops being analytic, by Bernstein's ellipses.

#include "mesh/vec3.hpp"

namespace rollcon::quadrature {

/// Returns half the sum of the distances of the foci -1 and 1 from the complex root nearest to [-1, 1] of X(z).X(z), X
/// the parabola through three points at z = -1, 0, 1. It is at least 1.
double ellipse_axis(const Vec3& first, const Vec3& middle, const Vec3& last);

/// Returns the logarithm of the parameter rho of the ellipse with this half-axis; it is positive.
double log_rho(double axis);

}  // namespace rollcon::quadrature
