/// Adds the delayed displacements of half-spaces that creep to those of elastic ones, at any points of any frame.
/// Delayed displacements are integrals of the elastic displacement along lines upstream.

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "bodies/halfspace/halfspace.hpp"
#include "bodies/halfspace/halfspace_kernel.hpp"
#include "bodies/halfspace/lag_rule.hpp"
#include "linalg/dense.hpp"
#include "support/index.hpp"
#include "support/interrupt.hpp"

namespace rollcon {
namespace {

using namespace halfspace;

/// Lists distances upstream of a point, and the weight that the displacement there has for each body.
struct Upstream {
  std::vector<double> distance;
  std::vector<std::vector<double>> weight;  ///< by body
};

class LaggingHalfspace final : public Compliance {
 public:
  LaggingHalfspace(const Frame& frame, HalfspaceConstants c, std::vector<LaggingBody> bodies, double tolerance,
                   int threads)
      : frame_(frame),
        body_(std::move(bodies)),
        kernel_(make_lagging_kernel(c, body_)),
        at_once_(make_halfspace_compliance(frame, c, tolerance, threads)) {
    for (const LaggingBody& body : body_)
      lagging_.push_back(make_halfspace_compliance(frame, body.c, tolerance, threads));
  }

  std::int64_t nodes() const override { return at_once_->nodes(); }
  bool couples() const override { return kernel_->couples(); }
  std::shared_ptr<const TranslationKernel> translation() const override { return kernel_; }
  bool follow_frame() override {
    bool followed = at_once_->follow_frame();
    for (const auto& body : lagging_) followed = body->follow_frame() && followed;
    return followed;
  }
  bool expand(Points points, ExpandedCompliance& out) const override {
    add_direct(*this, points, out);
    return true;
  }
  std::string description() const override { return "half-spaces that creep: displacements lag in rolling"; }
  void set_threads(int threads) override {
    at_once_->set_threads(threads);
    for (const auto& body : lagging_) body->set_threads(threads);
  }
  std::int64_t kernel_evaluations() const override {
    std::int64_t sum = at_once_->kernel_evaluations();
    for (const auto& body : lagging_) sum += body->kernel_evaluations();
    return sum;
  }
  std::size_t bytes() const override {
    std::size_t sum = sizeof *this + at_once_->bytes();
    for (const auto& body : lagging_) sum += body->bytes();
    return sum;
  }

  void block(Points points, const ComplianceBlock& out) const override {
    at_once_->block(points, out);
    for_each(points, [&](std::size_t p, const Points& ahead, const Upstream& up) {
      for (std::size_t b = 0; b < body_.size(); ++b) {
        const BlockBuffer rows(out, ahead.size(), nodes());
        lagging_[b]->block(ahead, rows.block());
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t q = 0; out.a[i][j] != nullptr && q < ahead.size(); ++q)
              axpy(up.weight[b][q], rows.row(i, j, q), out.a[i][j] + static_cast<std::ptrdiff_t>(p) * out.stride,
                   nodes());
      }
    });
  }

  void apply(Points points, const double* traction, double* displacement) const override {
    at_once_->apply(points, traction, displacement);
    std::vector<double> u;
    for_each(points, [&](std::size_t p, const Points& ahead, const Upstream& up) {
      u.resize(3 * ahead.size());
      for (std::size_t b = 0; b < body_.size(); ++b) {
        lagging_[b]->apply(ahead, traction, u.data());
        for (std::size_t q = 0; q < ahead.size(); ++q) axpy(up.weight[b][q], u.data() + 3 * q, displacement + 3 * p, 3);
      }
    });
  }

 private:
  template <class Work>
  void for_each(Points points, const Work& work) const {
    std::vector<double> x, y;
    for (std::size_t p = 0; p < points.size(); ++p) {
      check_interrupt();
      const Upstream up = upstream(points.x[p]);
      x = up.distance;
      for (double& d : x) d += points.x[p];
      y.assign(x.size(), points.y[p]);
      work(p, Points{x, y}, up);
    }
  }

  /// Divides the line upstream of x into panels: as long as elements over the frame, longer and longer beyond it.
  Upstream upstream(double x) const {
    constexpr double forgotten = 40;
    constexpr int points = 6, far_points = 8;
    constexpr std::size_t most_panels = 5000;
    double longest = 0;
    for (const LaggingBody& body : body_)
      for (const Lag& lag : body.lag) longest = std::max(longest, lag.length);
    const auto [low, high] = std::minmax_element(frame_.x.begin(), frame_.x.end());
    double area = 0;
    for (const double a : frame_.cell_area) area += a;
    const double size = std::max(std::sqrt(area / static_cast<double>(frame_.elements())), 1e-3 * (*high - *low));
    Upstream up;
    up.weight.resize(body_.size());
    double begin = std::max(0.0, *low - size - x);
    if (begin > 0) add_panel(0, begin, far_points, up);
    for (std::size_t k = 0; k < most_panels && begin < forgotten * longest; ++k) {
      const double beyond = x + begin - *high;
      const double length = beyond > size ? std::max(size, beyond) : size;
      add_panel(begin, length, beyond > size ? far_points : points, up);
      begin += length;
    }
    return up;
  }
  void add_panel(double begin, double length, int points, Upstream& up) const {
    std::vector<double> weight(at(points));
    for (const double t : lag_points(points)) up.distance.push_back(begin + t * length);
    for (std::size_t b = 0; b < body_.size(); ++b) {
      std::vector<double>& all = up.weight[b];
      all.resize(up.distance.size(), 0.0);
      for (const Lag& lag : body_[b].lag) {
        lag_weights(length / lag.length, weight);
        if (lag.slope) weigh_slopes(length, weight);
        const double left = lag.ratio * std::exp(-begin / lag.length);
        for (std::size_t q = 0; q < weight.size(); ++q) all[all.size() - weight.size() + q] += left * weight[q];
      }
    }
  }

  const Frame& frame_;
  std::vector<LaggingBody> body_;
  std::shared_ptr<const TranslationKernel> kernel_;
  std::unique_ptr<Compliance> at_once_;
  std::vector<std::unique_ptr<Compliance>> lagging_;
};

}  // namespace

std::unique_ptr<Compliance> make_lagging_compliance(const Frame& frame, HalfspaceConstants c,
                                                    std::vector<LaggingBody> bodies, double tolerance, int threads) {
  if (bodies.empty()) return make_halfspace_compliance(frame, c, tolerance, threads);
  return std::make_unique<LaggingHalfspace>(frame, c, std::move(bodies), tolerance, threads);
}

}  // namespace rollcon
