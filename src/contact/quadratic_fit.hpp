#pragma once
/// The quadratic polynomial next to values at some nodes of a frame.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/frame.hpp"

namespace rollcon {

/// Least squares in the coordinates of the frame's plane, around a point.
class QuadraticFit {
 public:
  /// value[k] at each of the nodes. False: they do not determine such a polynomial.
  bool fit(const Frame& frame, std::span<const std::int32_t> nodes, double x, double y,
           const std::vector<double>& value);
  double at(double x, double y) const;
  /// Second derivative along (dx, dy), times the square of its length.
  double curvature(double dx, double dy) const;

 private:
  static constexpr std::size_t terms = 6;
  using Coefficients = std::array<double, terms>;
  Coefficients monomials(double x, double y) const;
  static bool solve(std::array<std::array<double, terms + 1>, terms>& a, Coefficients& c);

  double x_ = 0, y_ = 0, rx_ = 1, ry_ = 1;  ///< origin and scales
  Coefficients c_{};
};

}  // namespace rollcon
