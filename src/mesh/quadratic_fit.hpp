#pragma once
/// Fits quadratic polynomials by least squares to values at points of a plane.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace rollcon {

/// Is c[0] + c[1] u + c[2] v + c[3] u u + c[4] u v + c[5] v v with u = (x - x0) / rx, v = (y - y0) / ry.
struct Quadratic {
  static constexpr std::size_t terms = 6;
  double x0 = 0, y0 = 0, rx = 1, ry = 1;
  std::array<double, terms> c{};

  std::array<double, terms> monomials(double x, double y) const;
  double operator()(double x, double y) const;
};

/// Fits value[k] at (x[k], y[k]), about (x0, y0); none if the points do not determine it.
std::optional<Quadratic> fit_quadratic(double x0, double y0, std::span<const double> x, std::span<const double> y,
                                       std::span<const double> value);

/// Returns the weights of the values at these points in the second derivatives xx, xy and yy of that polynomial; empty
/// if the points do not determine it.
std::vector<std::array<double, 3>> curvature_weights(std::span<const double> x, std::span<const double> y);

}  // namespace rollcon
