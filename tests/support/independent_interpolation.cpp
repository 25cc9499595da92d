/// Fields between nodes, by the elements' shape functions.

#include <algorithm>
#include <cmath>

#include "mesh/shape.hpp"
#include "support/independent_schemes.hpp"

namespace rollcon::laws {
namespace {

/// Shape functions of the element at (x, y); false: the point is beside it.
bool evaluate_at(const SurfaceMesh& mesh, const Plane& at, std::int64_t e, double x, double y, Shape& shape) {
  constexpr double tolerance = 1e-9;
  const auto node = mesh.element(e);
  const ElementType type = mesh.type[static_cast<std::size_t>(e)];
  double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
  for (const std::int32_t k : node) {
    const double p[2] = {at.x[static_cast<std::size_t>(k)], at.y[static_cast<std::size_t>(k)]};
    for (std::size_t c = 0; c < 2; ++c) low[c] = std::min(low[c], p[c]), high[c] = std::max(high[c], p[c]);
  }
  const double size = std::max(high[0] - low[0], high[1] - low[1]);
  // Curved sides bulge a little.
  if (x < low[0] - 0.2 * size || x > high[0] + 0.2 * size || y < low[1] - 0.2 * size || y > high[1] + 0.2 * size)
    return false;
  const bool triangle = corner_count(type) == 3;
  double xi = triangle ? 1.0 / 3 : 0, eta = xi;
  double miss = INFINITY;
  for (int i = 0; i < 30 && miss > 1e-13 * size; ++i) {
    evaluate_shape(type, xi, eta, shape);
    double rx = x, ry = y, x1 = 0, x2 = 0, y1 = 0, y2 = 0;
    for (std::size_t j = 0; j < node.size(); ++j) {
      const auto k = static_cast<std::size_t>(node[j]);
      rx -= shape.value[j] * at.x[k], ry -= shape.value[j] * at.y[k];
      x1 += shape.d_xi[j] * at.x[k], x2 += shape.d_eta[j] * at.x[k];
      y1 += shape.d_xi[j] * at.y[k], y2 += shape.d_eta[j] * at.y[k];
    }
    miss = std::hypot(rx, ry);
    const double det = x1 * y2 - x2 * y1;
    if (!(std::abs(det) > 0)) return false;
    xi += (rx * y2 - ry * x2) / det;
    eta += (ry * x1 - rx * y1) / det;
    if (!(std::abs(xi) < 3 && std::abs(eta) < 3)) return false;
  }
  evaluate_shape(type, xi, eta, shape);
  if (triangle) return xi >= -tolerance && eta >= -tolerance && xi + eta <= 1 + tolerance;
  return std::max(std::abs(xi), std::abs(eta)) <= 1 + tolerance;
}

}  // namespace

std::array<double, 2> tractions_at(const SurfaceMesh& mesh, const Plane& at, double x, double y,
                                   const std::vector<double>& traction) {
  Shape shape;
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    if (!evaluate_at(mesh, at, e, x, y, shape)) continue;
    std::array<double, 2> sum{};
    const auto node = mesh.element(e);
    for (std::size_t j = 0; j < node.size(); ++j)
      for (std::size_t c = 0; c < 2; ++c)
        sum[c] += shape.value[j] * traction[3 * static_cast<std::size_t>(node[j]) + c];
    return sum;
  }
  return {};
}

}  // namespace rollcon::laws
