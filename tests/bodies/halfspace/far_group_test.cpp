// Compares groups of elements seen from afar, their scale and their choice of rules, with the formulas.

#include "bodies/halfspace/far_field.hpp"
#include "support/frames.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using halfspace::FarGroup;
using quadrature::CellShape;
using quadrature::MapKind;

/// Makes rectangles of different sizes, far from the origin.
FarGroup group_off_the_origin() {
  const double x[] = {3, 3.5, 4.4, 6}, y[] = {-7, -6.2, -5};
  const Frame frame = build_frame(frames::rectangle(ElementType::quad4, x, y), Axes{});
  std::vector<std::int64_t> all(static_cast<std::size_t>(frame.mesh.elements()));
  std::iota(all.begin(), all.end(), 0);
  return {frame, all, ElementType::quad4, MapKind::affine};
}

double distance2(const CellShape& s, double px, double py) {
  return (px - s.centre[0]) * (px - s.centre[0]) + (py - s.centre[1]) * (py - s.centre[1]);
}

TEST(FarGroup, scale_is_the_largest_area_over_distance) {
  const FarGroup group = group_off_the_origin();
  frames::Random random(3);
  double error = 0;
  for (int k = 0; k < 200; ++k) {
    const double px = 4.5 + 6 * random(), py = -6 + 6 * random();
    double expected = 0;
    for (std::int64_t e = 0; e < group.size(); ++e) {
      const CellShape& s = group.shape(e).shape;
      expected = std::max(expected, s.area / std::sqrt(distance2(s, px, py) + s.half_length * s.half_length));
    }
    error = std::max(error, std::abs(group.scale(px, py) / expected - 1));
  }
  std::printf("scale of 200 observers: error %.1e (bound 1e-14)\n", error);
  EXPECT_LE(error, 1e-14);
}

// Rules of n = 2, 3, ... points in each direction are exact to degree 2n - 1; m loses that of shape function times
// Jacobian, 1 for rectangles.
TEST(FarGroup, the_first_rule_within_the_tolerance_is_taken) {
  const FarGroup group = group_off_the_origin();
  frames::Random random(5);
  std::vector<std::uint8_t> level(static_cast<std::size_t>(group.size()));
  std::vector<int> taken(static_cast<std::size_t>(group.levels()) + 1, 0);
  for (int k = 0; k < 2000; ++k) {
    const double reach = std::pow(10.0, 0.5 + 0.9 * random());
    const double px = 4.5 + reach * random(), py = -6 + reach * random();
    const double tolerance = std::pow(10.0, -5 + 4 * random());
    group.select(px, py, tolerance, level.data());
    for (std::int64_t e = 0; e < group.size(); ++e) {
      const CellShape& s = group.shape(e).shape;
      const double d = std::sqrt(distance2(s, px, py)), a = s.half_length;
      int expected = d < 2.5 * a ? group.levels() : 0;
      bool close_call = std::abs(d / (2.5 * a) - 1) < 1e-12;
      while (expected < group.levels()) {
        const int m = 2 * (expected + 2) - 1;
        const double share = halfspace::far_constant * s.area / d * std::pow(a / (1.9 * d), m) / tolerance;
        close_call = close_call || std::abs(share - 1) < 1e-10;
        if (share <= 1) break;
        ++expected;
      }
      if (close_call) continue;
      ASSERT_EQ(level[static_cast<std::size_t>(e)], expected)
          << "element " << e << " at " << d / a << " half-lengths, tolerance " << tolerance;
      ++taken[static_cast<std::size_t>(expected)];
    }
  }
  for (const int count : taken) EXPECT_GT(count, 0);  // near elements, and every rule
}

}  // namespace
}  // namespace rollcon
