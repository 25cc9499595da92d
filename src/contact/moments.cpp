#include "contact/moments.hpp"

#include "mesh/quadrature.hpp"
#include "mesh/shape.hpp"
#include "mesh/surface_quadrature.hpp"

namespace rollcon {
namespace {

void curved_moments(const Frame& frame, std::vector<double>& mx, std::vector<double>& my,
                    std::vector<double>& mz) {
  mz.assign(static_cast<std::size_t>(frame.nodes()), 0.0);
  const Axes& axes = frame.axes;
  integrate_surface(frame.mesh, [&](std::int64_t e, const Shape& shape, const Vec3& x,
                                    double area) {
    const Vec3 r = x - axes.origin;
    const double a = area * dot(r, axes.t1), b = area * dot(r, axes.t2), c = area * dot(r, axes.n);
    const auto nodes = frame.mesh.element(e);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const auto k = static_cast<std::size_t>(nodes[i]);
      mx[k] += shape.value[i] * a;
      my[k] += shape.value[i] * b;
      mz[k] += shape.value[i] * c;
    }
  });
}

}  // namespace

void moment_weights(const Frame& frame, std::vector<double>& mx, std::vector<double>& my,
                    std::vector<double>& mz) {
  constexpr int degree = 7;  // N x J of a quad9: 2 + 2 + 3 in each variable
  const PlaneRule triangle = triangle_rule(degree), square = square_rule(degree);
  mx.assign(static_cast<std::size_t>(frame.nodes()), 0.0);
  my.assign(static_cast<std::size_t>(frame.nodes()), 0.0);
  mz.clear();
  if (frame.curved()) return curved_moments(frame, mx, my, mz);
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
