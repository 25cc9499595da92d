/// Tests Hertz's ellipse from curvatures, load and approach.

#include "framing/hertz.hpp"

#include "support/closed_forms.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using std::numbers::pi;

// Returns a gap of principal curvatures `least` and `largest`, the first along the direction `angle`.
QuadraticGap turned(double least, double largest, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {least * c * c + largest * s * s, least * s * s + largest * c * c, 2 * (least - largest) * c * s};
}

TEST(hertz, agrees_with_the_closed_form_of_the_tests) {
  const double modulus = 1.1e5;
  double worst = 0;
  for (const double ratio : {1.0, 1 + 1e-12, 1 + 1e-6, 1.1, 2.0, 5.0, 50.0, 1e3, 1e5})
    for (const double angle : {0.0, 0.4, pi / 2, 2.0}) {
      const auto expected = closed_forms::hertz_from_load(1e-3, 1e-3 * ratio, modulus, 1e4);
      const HertzContact h = hertz_by_load(turned(1e-3, 1e-3 * ratio, angle), modulus, 1e4);
      worst = std::max({worst, relative(h.larger, expected.a), relative(h.smaller, expected.b),
                        relative(h.pressure, expected.p0), relative(h.approach, expected.approach)});
      if (ratio > 1.01) worst = std::max(worst, std::abs(std::sin(h.angle - angle)));
      const HertzContact back = hertz_by_approach(turned(1e-3, 1e-3 * ratio, angle), modulus, h.approach);
      worst = std::max({worst, relative(back.larger, h.larger), relative(back.load, h.load)});
    }
  expect_error("Hertz, ratios of curvatures 1 to 1e5, turned", worst, 1e-10);
}

// The published ellipse has all digits shown.
TEST(hertz, published_ellipse_of_ratio_50) {
  const HertzContact h = hertz_by_load({0.0005, 0.025, 0}, 113888.8889, 1e4);
  EXPECT_NEAR(h.larger, 6.23462653, 1e-8);
  EXPECT_NEAR(h.smaller, 0.51648999, 1e-8);
  EXPECT_NEAR(h.pressure, 1482.7537, 1e-4);
  EXPECT_NEAR(h.approach, 0.026104332, 1e-9);
}

TEST(hertz, only_gaps_that_grow_in_all_directions_have_an_ellipse) {
  EXPECT_TRUE(has_ellipse({1, 1, 0}));
  EXPECT_TRUE(has_ellipse({1, 1, 1.99}));
  for (const QuadraticGap& gap : {QuadraticGap{1, 0, 0}, {0, 0, 0}, {1, -1, 0}, {-1, -1, 0}, {1, 1, 2}, {1, 1, 3}})
    EXPECT_FALSE(has_ellipse(gap)) << gap.a << ' ' << gap.b << ' ' << gap.c;
}

}  // namespace
}  // namespace rollcon
