#include "bodies/layer/layered_compliance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bodies/model/translation.hpp"
#include "geometry/surface_search.hpp"
#include "mesh/shape.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

double hat(double x, double h, Hat which) {
  if (which == Hat::before && x > 0) return 0;
  if (which == Hat::after && x < 0) return 0;
  return std::max(0.0, 1 - std::abs(x) / h);
}

// Values of hats are 1 and 0 at nodes, whatever rounding of offsets says.
double rounded(double value) {
  constexpr double rounding = 1e-12;
  return std::abs(value) < rounding ? 0 : std::abs(value - 1) < rounding ? 1 : value;
}

class LayeredRows final : public LatticeRows {
 public:
  LayeredRows(std::unique_ptr<LatticeRows> bodies, double flexibility, const LatticeHat& source, double shift_x,
              double shift_y)
      : bodies_(std::move(bodies)), flexibility_(flexibility), source_(source), shift_x_(shift_x), shift_y_(shift_y) {}

  void row(std::int64_t j, std::int64_t first, std::int64_t count, double* const (&u)[3][3]) const override {
    bodies_->row(j, first, count, u);
    const double across = hat(shift_y_ + static_cast<double>(j) * source_.dy, source_.dy, source_.y);
    if (!(across > 0)) return;
    for (std::int64_t m = 0; m < count; ++m) {
      const double along = hat(shift_x_ + static_cast<double>(first + m) * source_.dx, source_.dx, source_.x);
      const double own = flexibility_ * rounded(along * across);
      for (int t = 0; t < 2; ++t)
        if (u[t][t] != nullptr) u[t][t][m] += own;
    }
  }

 private:
  std::unique_ptr<LatticeRows> bodies_;
  double flexibility_;
  LatticeHat source_;
  double shift_x_, shift_y_;
};

class LayeredKernel final : public TranslationKernel {
 public:
  LayeredKernel(std::shared_ptr<const TranslationKernel> bodies, double flexibility)
      : bodies_(std::move(bodies)), flexibility_(flexibility) {}
  bool couples() const override { return bodies_->couples(); }
  bool shears() const override { return bodies_->shears(); }
  bool turns() const override { return bodies_->turns(); }
  std::unique_ptr<LatticeRows> on_lattice(const LatticeHat& source, double shift_x, double shift_y,
                                          OffsetReach reach) const override {
    return std::make_unique<LayeredRows>(bodies_->on_lattice(source, shift_x, shift_y, reach), flexibility_, source,
                                         shift_x, shift_y);
  }
  std::complex<double> delay(double k1) const override { return bodies_->delay(k1); }
  Softness softness(double k) const override {
    Softness s = bodies_->softness(k);
    s.along += flexibility_;
    s.across += flexibility_;
    return s;
  }

 private:
  std::shared_ptr<const TranslationKernel> bodies_;
  double flexibility_;
};

class LayeredCompliance final : public Compliance {
 public:
  LayeredCompliance(const Frame& frame, std::unique_ptr<Compliance> bodies, double flexibility)
      : bodies_(std::move(bodies)), frame_(frame), search_(search_on(frame)), flexibility_(flexibility) {}

  std::int64_t nodes() const override { return bodies_->nodes(); }
  bool couples() const override { return bodies_->couples(); }
  void block(Points points, const ComplianceBlock& out) const override {
    bodies_->block(points, out);
    at_nodes(points, [&](std::size_t p, std::int32_t node, double value) {
      for (int t = 0; t < 2; ++t)
        if (out.a[t][t] != nullptr)
          out.a[t][t][static_cast<std::ptrdiff_t>(p) * out.stride + node] += flexibility_ * value;
    });
  }
  void apply(Points points, const double* traction, double* displacement) const override {
    bodies_->apply(points, traction, displacement);
    at_nodes(points, [&](std::size_t p, std::int32_t node, double value) {
      for (std::size_t t = 0; t < 2; ++t) displacement[3 * p + t] += flexibility_ * value * traction[3 * at(node) + t];
    });
  }
  /// A layer does not grow with the frame as bodies do, which operators of placed frames count on.
  bool follow_frame() override {
    search_ = search_on(frame_);
    return bodies_->follow_frame() && frame_.strips;
  }
  bool offset(Points points, double* u) const override { return bodies_->offset(points, u); }
  bool resolves_frame() const override { return bodies_->resolves_frame(); }
  std::shared_ptr<const TranslationKernel> translation() const override {
    auto kernel = bodies_->translation();
    if (!kernel) return nullptr;
    return std::make_shared<LayeredKernel>(std::move(kernel), flexibility_);
  }
  void find_meshes(std::array<MeshOnFrame, 2>& found) const override { bodies_->find_meshes(found); }
  std::string description() const override { return bodies_->description(); }
  void set_threads(int threads) override { bodies_->set_threads(threads); }
  std::int64_t kernel_evaluations() const override { return bodies_->kernel_evaluations(); }
  std::size_t bytes() const override { return bodies_->bytes(); }

 private:
  static std::unique_ptr<SurfaceSearch> search_on(const Frame& frame) {
    return std::make_unique<SurfaceSearch>(frame.mesh, std::span<const std::int64_t>{});
  }
  /// Calls f(point, node, shape function there); points beside the frame have none.
  template <class F>
  void at_nodes(Points points, F f) const {
    const Axes& axes = frame_.axes;
    Shape shape;
    for (std::size_t p = 0; p < points.size(); ++p) {
      const Vec3 point = axes.origin + points.x[p] * axes.t1 + points.y[p] * axes.t2;
      const auto found = search_->along(point, axes.n, axes.n);
      if (!found) continue;
      const auto nodes = frame_.mesh.element(found->element);
      evaluate_shape(frame_.mesh.type[at(found->element)], found->xi, found->eta, shape);
      for (std::size_t i = 0; i < nodes.size(); ++i)
        if (const double value = rounded(shape.value[i]); value != 0) f(p, nodes[i], value);
    }
  }

  std::unique_ptr<Compliance> bodies_;
  const Frame& frame_;
  std::unique_ptr<SurfaceSearch> search_;
  double flexibility_;
};

}  // namespace

std::unique_ptr<Compliance> make_layered(const Frame& frame, std::unique_ptr<Compliance> bodies, double flexibility) {
  return std::make_unique<LayeredCompliance>(frame, std::move(bodies), flexibility);
}

}  // namespace rollcon
