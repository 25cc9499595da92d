/// Tests integrals of points that differ by rounding alone, at the corners of slender elements and on the nodes of
/// grids, where rules change: slip divides their difference by a short step.

#include "bodies/halfspace/halfspace.hpp"
#include "support/frames.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

// Returns lines whose spacing grows threefold from the middle on, to both sides.
std::vector<double> graded() {
  std::vector<double> half{0}, lines;
  for (double step = 1; half.size() < 10; step *= 3) half.push_back(half.back() + step);
  for (std::size_t i = half.size() - 1; i > 0; --i) lines.push_back(-half[i] / half.back());
  for (const double x : half) lines.push_back(x / half.back());
  return lines;
}

/// Compares at points neither of whose coordinates is below the least: a quarter of them with 0.
void expect_the_same_integrals(double least) {
  constexpr double bound = 1e-9;
  for (const ElementType type : {ElementType::tri3, ElementType::quad4})
    for (const bool even : {false, true}) {
      const std::vector<double> lines = even ? frames::uniform_lines(-1, 1, 10) : graded();
      const Frame frame = build_frame(frames::rectangle(type, lines, lines), Axes{});
      const auto compliance = make_halfspace_compliance(frame, {0.7, 0.3, 0}, 1e-6, 1);
      std::vector<double> traction(3 * frame.x.size());
      for (std::size_t i = 0; i < traction.size(); ++i)
        traction[i] = -std::sqrt(std::max(0.0, 1 - std::pow(frame.x[i / 3], 2) - std::pow(frame.y[i / 3], 2)));
      double worst = 0;
      for (const double x : lines)
        for (const double y : lines) {
          if (std::min(x, y) < least) continue;
          double at[3], beside[3];
          compliance->apply({{&x, 1}, {&y, 1}}, traction.data(), at);
          for (const double far : {-2.0, 2.0}) {
            const double px = std::nextafter(x, far), py = std::nextafter(y, far);
            compliance->apply({{&px, 1}, {&py, 1}}, traction.data(), beside);
            for (std::size_t c = 0; c < 3; ++c) worst = std::max(worst, std::abs(beside[c] / at[c] - 1));
          }
        }
      std::printf("%d corners, %s grid: apart by %.1e (bound %.0e)\n", corner_count(type), even ? "even" : "graded",
                  worst, bound);
      EXPECT_LT(worst, bound);
    }
}

TEST(neighbouring_points, have_the_same_integrals) {
  expect_the_same_integrals(0);
}
TEST(neighbouring_points_long, have_the_same_integrals) {
  expect_the_same_integrals(-1);
}

}  // namespace
}  // namespace rollcon
