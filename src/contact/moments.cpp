#include "contact/moments.hpp"

#include "mesh/quadrature.hpp"
#include "mesh/shape.hpp"

namespace rollcon {

void moment_weights(const Frame& frame, std::vector<double>& mx, std::vector<double>& my) {
  constexpr int degree = 7;  // N x J of a quad9: 2 + 2 + 3 in each variable
  const PlaneRule triangle = triangle_rule(degree), square = square_rule(degree);
  mx.assign(static_cast<std::size_t>(frame.nodes()), 0.0);
  my.assign(static_cast<std::size_t>(frame.nodes()), 0.0);
  Shape shape;
  for (std::int64_t e = 0; e < frame.elements(); ++e) {
    const ElementType type = frame.mesh.type[static_cast<std::size_t>(e)];
    const auto nodes = frame.mesh.element(e);
    const PlaneRule& rule = corner_count(type) == 3 ? triangle : square;
    for (std::size_t q = 0; q < rule.size(); ++q) {
      evaluate_shape(type, rule.xi[q], rule.eta[q], shape);
      double x = 0, y = 0, x_xi = 0, x_eta = 0, y_xi = 0, y_eta = 0;
      for (std::size_t k = 0; k < nodes.size(); ++k) {
        const auto i = static_cast<std::size_t>(nodes[k]);
        x += shape.value[k] * frame.x[i];
        y += shape.value[k] * frame.y[i];
        x_xi += shape.d_xi[k] * frame.x[i];
        x_eta += shape.d_eta[k] * frame.x[i];
        y_xi += shape.d_xi[k] * frame.y[i];
        y_eta += shape.d_eta[k] * frame.y[i];
      }
      const double area = rule.w[q] * (x_xi * y_eta - x_eta * y_xi);
      for (std::size_t k = 0; k < nodes.size(); ++k) {
        const auto i = static_cast<std::size_t>(nodes[k]);
        mx[i] += area * shape.value[k] * x;
        my[i] += area * shape.value[k] * y;
      }
    }
  }
}

}  // namespace rollcon
