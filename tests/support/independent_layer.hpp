#pragma once
/// Interpolates tractions between the nodes of a frame, for a layer between the bodies: by the shape functions of the
/// element over the point, none beside the frame.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "mesh/shape.hpp"
#include "support/independent_schemes.hpp"

namespace rollcon::laws {

class TractionsBetween {
 public:
  TractionsBetween(const SurfaceMesh& mesh, const Plane& at) : mesh_(mesh), at_(at) {}

  /// Returns the two tangential components of three for each node.
  std::array<double, 2> operator()(const std::vector<double>& traction, double x, double y) const {
    for (std::int64_t e = 0; e < mesh_.elements(); ++e) {
      const auto shape = over(e, x, y);
      if (!shape) continue;
      const auto nodes = mesh_.element(e);
      std::array<double, 2> q{};
      for (std::size_t i = 0; i < nodes.size(); ++i)
        for (std::size_t c = 0; c < 2; ++c) q[c] += shape->value[i] * traction[3 * at(nodes[i]) + c];
      return q;
    }
    return {};
  }

 private:
  static std::size_t at(std::int64_t k) { return static_cast<std::size_t>(k); }

  /// Finds the point in an element by Newton's method from the middle.
  std::optional<Shape> over(std::int64_t e, double x, double y) const {
    const auto nodes = mesh_.element(e);
    const ElementType type = mesh_.type[at(e)];
    const bool triangle = corner_count(type) == 3;
    double xi = triangle ? 1.0 / 3 : 0, eta = xi, low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (const auto k : nodes)
      for (int c = 0; c < 2; ++c) {
        const double v = c == 0 ? at_.x[at(k)] : at_.y[at(k)];
        low[c] = std::min(low[c], v), high[c] = std::max(high[c], v);
      }
    const double wide = high[0] - low[0], tall = high[1] - low[1];
    if (x < low[0] - wide || x > high[0] + wide || y < low[1] - tall || y > high[1] + tall) return std::nullopt;
    Shape shape;
    for (int step = 0; step < 30; ++step) {
      evaluate_shape(type, xi, eta, shape);
      double f[2] = {-x, -y}, j[2][2] = {};
      for (std::size_t i = 0; i < nodes.size(); ++i)
        for (int c = 0; c < 2; ++c) {
          const double v = c == 0 ? at_.x[at(nodes[i])] : at_.y[at(nodes[i])];
          f[c] += shape.value[i] * v;
          j[c][0] += shape.d_xi[i] * v;
          j[c][1] += shape.d_eta[i] * v;
        }
      const double area = j[0][0] * j[1][1] - j[0][1] * j[1][0];
      const double by_xi = (f[0] * j[1][1] - f[1] * j[0][1]) / area, by_eta = (j[0][0] * f[1] - j[1][0] * f[0]) / area;
      xi -= by_xi;
      eta -= by_eta;
      if (!(std::abs(xi) < 3 && std::abs(eta) < 3)) return std::nullopt;
      if (std::abs(by_xi) + std::abs(by_eta) < 1e-14) break;
    }
    constexpr double rounding = 1e-9;
    const double outside = triangle ? std::max({-xi, -eta, xi + eta - 1}) : std::max(std::abs(xi), std::abs(eta)) - 1;
    if (!(outside <= rounding)) return std::nullopt;
    evaluate_shape(type, xi, eta, shape);
    return shape;
  }

  const SurfaceMesh& mesh_;
  const Plane& at_;
};

}  // namespace rollcon::laws
