#include "contact/problem/moments.hpp"

#include "mesh/plane_quadrature.hpp"
#include "mesh/surface_quadrature.hpp"

namespace rollcon {
namespace {

void curved_moments(const Frame& frame, std::vector<double>& mx, std::vector<double>& my, std::vector<double>& mz) {
  mz.assign(static_cast<std::size_t>(frame.nodes()), 0.0);
  const Axes& axes = frame.axes;
  integrate_surface(frame.mesh, [&](std::int64_t e, const Shape& shape, const Vec3& x, double area) {
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

void moment_weights(const Frame& frame, std::vector<double>& mx, std::vector<double>& my, std::vector<double>& mz) {
  constexpr int degree = 7;  // N x J of a quad9: 2 + 2 + 3 in each variable
  mx.assign(static_cast<std::size_t>(frame.nodes()), 0.0);
  my.assign(static_cast<std::size_t>(frame.nodes()), 0.0);
  mz.clear();
  if (frame.curved()) return curved_moments(frame, mx, my, mz);
  integrate_projection(frame, degree, [&](auto nodes, const Shape& shape, double x, double y, double area) {
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const auto i = static_cast<std::size_t>(nodes[k]);
      mx[i] += area * shape.value[k] * x;
      my[i] += area * shape.value[k] * y;
    }
  });
}

}  // namespace rollcon
