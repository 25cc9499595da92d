#include "contact/problem/moments.hpp"

#include <cmath>
#include <utility>

#include "mesh/plane_quadrature.hpp"
#include "mesh/surface_quadrature.hpp"

namespace rollcon {
namespace {

/// Sums by node, with the terms' magnitudes: what rounding leaves of a sum that vanishes is no moment arm. With it a
/// contact of one node at the origin would answer a moment of zero by a spin beyond all measure.
class NodeSums {
 public:
  explicit NodeSums(std::int64_t nodes)
      : sum_(static_cast<std::size_t>(nodes), 0.0), magnitude_(static_cast<std::size_t>(nodes), 0.0) {}
  void add(std::size_t node, double term) {
    sum_[node] += term;
    magnitude_[node] += std::abs(term);
  }
  std::vector<double> take() {
    constexpr double rounding = 1e-12;
    for (std::size_t k = 0; k < sum_.size(); ++k)
      if (std::abs(sum_[k]) <= rounding * magnitude_[k]) sum_[k] = 0;
    return std::move(sum_);
  }

 private:
  std::vector<double> sum_, magnitude_;
};

void curved_moments(const Frame& frame, NodeSums& mx, NodeSums& my, NodeSums& mz) {
  const Axes& axes = frame.axes;
  integrate_surface(frame.mesh, [&](std::int64_t e, const Shape& shape, const Vec3& x, double area) {
    const Vec3 r = x - axes.origin;
    const double a = area * dot(r, axes.t1), b = area * dot(r, axes.t2), c = area * dot(r, axes.n);
    const auto nodes = frame.mesh.element(e);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const auto k = static_cast<std::size_t>(nodes[i]);
      mx.add(k, shape.value[i] * a);
      my.add(k, shape.value[i] * b);
      mz.add(k, shape.value[i] * c);
    }
  });
}

}  // namespace

void moment_weights(const Frame& frame, std::vector<double>& mx, std::vector<double>& my, std::vector<double>& mz) {
  constexpr int degree = 7;  // N x J of a quad9: 2 + 2 + 3 in each variable
  NodeSums x_sums(frame.nodes()), y_sums(frame.nodes());
  mz.assign(static_cast<std::size_t>(frame.nodes()), 0.0);
  if (frame.curved()) {
    NodeSums z_sums(frame.nodes());
    curved_moments(frame, x_sums, y_sums, z_sums);
    mz = z_sums.take();
  } else {
    integrate_projection(frame, degree, [&](auto nodes, const Shape& shape, double x, double y, double area) {
      for (std::size_t k = 0; k < nodes.size(); ++k) {
        const auto i = static_cast<std::size_t>(nodes[k]);
        x_sums.add(i, area * shape.value[k] * x);
        y_sums.add(i, area * shape.value[k] * y);
      }
    });
    const double rounding = 1e-12 * std::sqrt(frame.area);
    for (std::size_t k = 0; k < mz.size(); ++k)
      if (std::abs(frame.z[k]) > rounding) mz[k] = frame.weight[k] * frame.z[k];
  }
  mx = x_sums.take();
  my = y_sums.take();
}

}  // namespace rollcon
