// Tests spaces of fewer tractions: what is spread, gathered and picked, node by node.

#include "contact/operators/traction_space.hpp"

#include "support/frames.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

Frame example_frame() {
  const std::vector<double> lines = frames::uniform_lines(-1.3, 1.3, 8);
  return build_frame(frames::perturb(frames::rectangle(ElementType::quad4, lines, lines), 0.15, 3), Axes{});
}

TEST(traction_space, of_loaded_nodes_leaves_the_others_without_traction) {
  const Frame frame = example_frame();
  frames::Random random(11);
  std::vector<double> normal, field;
  for (std::int64_t k = 0; k < frame.nodes(); ++k) {
    const double r = random();
    normal.push_back(r < -0.2 ? r : r > 0.8 ? r : 0.0);
    field.push_back(random());
  }
  const TractionSpace space = loaded_space(frame, normal);
  const std::vector<double> picked = pick(space, field), gathered = gather(space, field);
  const std::vector<double> spread_again = spread(space, picked);
  std::size_t i = 0;
  for (std::size_t k = 0; k < field.size(); ++k) {
    const bool loaded = normal[k] < 0;
    EXPECT_EQ(spread_again[k], loaded ? field[k] : 0.0) << "node " << k;
    if (!loaded) continue;
    ASSERT_LT(i, space.node.size());
    EXPECT_EQ(space.node[i], static_cast<std::int32_t>(k));
    EXPECT_EQ(picked[i], field[k]);
    EXPECT_EQ(gathered[i], field[k]);
    EXPECT_EQ(space.frame.x[i], frame.x[k]);
    EXPECT_EQ(space.frame.y[i], frame.y[k]);
    ++i;
  }
  EXPECT_EQ(space.node.size(), i);
  EXPECT_GT(i, 0u);
}

// Interpolation over the coarse triangles is exact for linear fields, and gathering is its transpose.
TEST(traction_space, of_a_coarse_frame_keeps_linear_fields) {
  const Frame frame = example_frame();
  const TractionSpace space = coarse_space(frame);
  ASSERT_LT(space.node.size(), static_cast<std::size_t>(frame.nodes()) / 2);
  std::vector<double> linear, other;
  frames::Random random(12);
  for (std::size_t k = 0; k < frame.x.size(); ++k) {
    linear.push_back(2 + 3 * frame.x[k] - 5 * frame.y[k]);
    other.push_back(random());
  }
  const std::vector<double> coarse = pick(space, linear), fine = spread(space, coarse);
  double error = 0;
  for (std::size_t k = 0; k < fine.size(); ++k) error = std::max(error, std::abs(fine[k] - linear[k]));
  const std::vector<double> gathered = gather(space, other);
  double one = 0, two = 0;
  for (std::size_t k = 0; k < fine.size(); ++k) one += fine[k] * other[k];
  for (std::size_t i = 0; i < coarse.size(); ++i) two += coarse[i] * gathered[i];
  std::printf("%zu of %zu nodes: linear field off by %.1e (bound 1e-12), transpose by %.1e\n", space.node.size(),
              fine.size(), error, std::abs(one - two));
  EXPECT_LE(error, 1e-12);
  EXPECT_NEAR(one, two, 1e-12);
}

}  // namespace
}  // namespace rollcon
