// Compares the gap between the nodes with sums over rectangles, for quadrilaterals and for triangles that make the same
// rectangles.

#include "contact/prepare/gap_between_nodes.hpp"

#include "bodies/halfspace/halfspace.hpp"
#include "contact/operators/dense_operators.hpp"
#include "contact/solution.hpp"
#include "support/frames.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

constexpr int cells = 9;  // more than 64 rectangles: displacements come in several chunks

double gap(double x, double y) {
  return 0.1 + 0.03 * x - 0.02 * y + 0.05 * x * x - 0.04 * x * y + 0.07 * y * y;
}

class GapBetweenNodes : public ::testing::TestWithParam<ElementType> {
 protected:
  void SetUp() override {
    x_ = frames::uniform_lines(-1.2, 1.5, cells);
    y_ = frames::uniform_lines(-0.8, 1.1, cells);
    s_.prepared = on_;
    on_->problem.op = std::make_shared<DenseOperators>();
    on_->frame = build_frame(frames::rectangle(GetParam(), x_, y_), Axes{});
    take_frame(on_->problem, on_->frame);
    const Frame& f = on_->frame;
    for (std::size_t k = 0; k < f.x.size(); ++k) on_->problem.gap.push_back(gap(f.x[k], f.y[k]));
    s_.iterate.resize(f.nodes());
    on_->compliance = make_halfspace_compliance(f, {1, 0.4, 0.2}, 1e-6, 1);
    frames::Random random(4);
    for (auto& component : s_.iterate.lambda)
      for (double& value : component) value = random();
    for (std::size_t k = 0; k < f.x.size(); ++k) rate_.push_back(2 + random());
  }
  double rate_at(double x, double y) const {
    for (std::size_t k = 0; k < rate_.size(); ++k)
      if (std::hypot(on_->frame.x[k] - x, on_->frame.y[k] - y) < 1e-9) return rate_[k];
    ADD_FAILURE() << "no node at " << x << ", " << y;
    return 0;
  }
  /// Returns two thirds of the mean rate, times area, times the gap less the displacement in the middle.
  double expected() const {
    std::vector<double> t(3 * on_->problem.gap.size());
    for (std::size_t k = 0; k < on_->problem.gap.size(); ++k)
      for (std::size_t c = 0; c < 3; ++c) t[3 * k + c] = s_.iterate.lambda[c][k];
    double sum = 0;
    for (std::size_t i = 0; i < cells; ++i)
      for (std::size_t j = 0; j < cells; ++j) {
        const double mean = 0.25 * (rate_at(x_[i], y_[j]) + rate_at(x_[i + 1], y_[j]) + rate_at(x_[i], y_[j + 1]) +
                                    rate_at(x_[i + 1], y_[j + 1]));
        const double x = 0.5 * (x_[i] + x_[i + 1]), y = 0.5 * (y_[j] + y_[j + 1]);
        double u[3];
        on_->compliance->apply({{&x, 1}, {&y, 1}}, t.data(), u);
        const double area = (x_[i + 1] - x_[i]) * (y_[j + 1] - y_[j]);
        sum += 2.0 / 3 * mean * area * (gap(x, y) - u[2]);
      }
    return sum;
  }

  std::vector<double> x_, y_, rate_;
  std::shared_ptr<Prepared> on_ = std::make_shared<Prepared>();
  Solution s_;
};

TEST_P(GapBetweenNodes, is_summed_over_rectangles) {
  const double reference = expected(), found = gap_force(s_, rate_);
  std::printf("%d corners: %.9g, expected %.9g (bound 1e-5)\n", corner_count(GetParam()), found, reference);
  EXPECT_NEAR(found, reference, 1e-5 * std::abs(reference));
}

TEST_P(GapBetweenNodes, cells_without_rate_have_no_share) {
  // The sum takes all but the rectangles at the corner of the first lines.
  for (std::size_t k = 0; k < rate_.size(); ++k)
    if (on_->frame.x[k] > x_[0] + 1e-9 || on_->frame.y[k] > y_[0] + 1e-9) rate_[k] = 0;
  for (auto& component : s_.iterate.lambda) std::fill(component.begin(), component.end(), 0.0);
  const double found = gap_force(s_, rate_), area = (x_[1] - x_[0]) * (y_[1] - y_[0]);
  const double x = 0.5 * (x_[0] + x_[1]), y = 0.5 * (y_[0] + y_[1]);
  const double one = 2.0 / 3 * 0.25 * rate_at(x_[0], y_[0]) * area * gap(x, y);
  if (GetParam() == ElementType::quad4)
    EXPECT_NEAR(found, one, 1e-12);
  else
    EXPECT_GT(found, 0.5 * one);  // its triangles at this corner, by themselves or in a pair
}

INSTANTIATE_TEST_SUITE_P(types, GapBetweenNodes, ::testing::Values(ElementType::tri3, ElementType::quad4),
                         [](const auto& info) { return info.param == ElementType::tri3 ? "tri3" : "quad4"; });

}  // namespace
}  // namespace rollcon
