#pragma once
/// How many points a rule needs: the error of Gauss's rules for the kernels 1/r, from the Bernstein
/// ellipse on which the kernel stays analytic.
///
/// On a straight segment of half-length a, seen by an observer at distances r1, r2 from its ends,
/// the kernel is singular on the ellipse of parameter rho = s + sqrt(s^2 - 1), s = (r1 + r2)/(2a).
/// A rule exact to degree d, on a kernel times a polynomial of degree p, is off by about
/// C rho^-(d + 1 - p) relative to area/distance. C is calibrated by the sweep in
/// tests/bodies/halfspace/rule_selection_test.cpp.

#include <algorithm>
#include <cmath>
#include <complex>

#include "quadrature/cell.hpp"

namespace rollcon::halfspace {

using namespace quadrature;

inline constexpr double rule_constant = 6;
/// Share of the tolerance given to one element; the rest is for the sum at a node.
inline constexpr double element_share = 0.1;

/// rho of a segment with half-length a and an observer at distances r1, r2 from its ends.
inline double ellipse_parameter(double r1, double r2, double a) {
  const double s = std::max(1.0, (r1 + r2) / (2 * a));
  return s + std::sqrt(s * s - 1);
}

/// rho of a line that runs through three points, quadratic in z from -1 to 1, given relative to the
/// observer. With points as complex numbers r^2 = X(z) conj(X(conj(z))): the kernel is singular at
/// the roots of X(z) = middle + b z + c z^2.
inline double ellipse_parameter(Vec2 first, Vec2 middle, Vec2 last) {
  using Complex = std::complex<double>;
  const Complex x0(middle.x, middle.y);
  const Complex b(0.5 * (last.x - first.x), 0.5 * (last.y - first.y));
  const Complex c(0.5 * (last.x + first.x) - middle.x, 0.5 * (last.y + first.y) - middle.y);
  auto rho = [](Complex z) { return ellipse_parameter(std::abs(z - 1.0), std::abs(z + 1.0), 1); };
  if (std::norm(c) < 1e-20 * std::norm(b)) return rho(-x0 / b);
  Complex q = std::sqrt(b * b - 4.0 * x0 * c);
  if (std::real(std::conj(b) * q) < 0) q = -q;
  q += b;
  return std::min(rho(-2.0 * x0 / q), rho(-0.5 * q / c));
}

/// Smallest degree of exactness with C rho^-(d + 1 - p) <= tolerance; rho > 1.
inline double needed_degree(double rho, int p, double tolerance) {
  const double needed = std::log(rule_constant / tolerance) / std::log(rho);
  return p - 1 + std::max(1.0, needed);
}

/// Points of a Gauss rule on a line of the same accuracy (degree 2n - 1).
inline double needed_points(double rho, int p, double tolerance) {
  return std::ceil(0.5 * (needed_degree(rho, p, tolerance) + 1));
}

}  // namespace rollcon::halfspace
