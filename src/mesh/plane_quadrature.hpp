#pragma once
/// Integrates over a frame's projection on the plane of its axes.

#include <cstddef>
#include <cstdint>
#include <span>

#include "mesh/frame.hpp"
#include "mesh/quadrature.hpp"
#include "mesh/shape.hpp"

namespace rollcon {

/// Calls f(nodes, shape, x, y, area) at the points of a rule of this degree on every element, with `area` the weight
/// times the Jacobian of the projection, a polynomial.
template <class F>
void integrate_projection(const Frame& frame, int degree, F f) {
  const PlaneRule triangle = triangle_rule(degree), square = square_rule(degree);
  Shape shape;
  for (std::int64_t e = 0; e < frame.elements(); ++e) {
    const ElementType type = frame.mesh.type[static_cast<std::size_t>(e)];
    const std::span<const std::int32_t> nodes = frame.mesh.element(e);
    const PlaneRule& rule = corner_count(type) == 3 ? triangle : square;
    const auto first = static_cast<std::size_t>(nodes[0]);
    const double x0 = frame.x[first], y0 = frame.y[first];
    for (std::size_t q = 0; q < rule.size(); ++q) {
      evaluate_shape(type, rule.xi[q], rule.eta[q], shape);
      double x = 0, y = 0, x_xi = 0, x_eta = 0, y_xi = 0, y_eta = 0;
      for (std::size_t k = 0; k < nodes.size(); ++k) {
        const auto i = static_cast<std::size_t>(nodes[k]);
        x += shape.value[k] * frame.x[i];
        y += shape.value[k] * frame.y[i];
        const double dx = frame.x[i] - x0, dy = frame.y[i] - y0;  // relative, so that far frames lose no digits
        x_xi += shape.d_xi[k] * dx;
        x_eta += shape.d_eta[k] * dx;
        y_xi += shape.d_xi[k] * dy;
        y_eta += shape.d_eta[k] * dy;
      }
      f(nodes, shape, x, y, rule.w[q] * (x_xi * y_eta - x_eta * y_xi));
    }
  }
}

}  // namespace rollcon
