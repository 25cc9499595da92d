#include "mesh/quadratic_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "support/frames.hpp"

namespace rollcon {
namespace {

struct Cloud {
  std::vector<double> x, y;
};

Cloud cloud(int n, double width, double height, std::uint32_t seed) {
  frames::Random random(seed);
  Cloud c;
  for (int k = 0; k < n; ++k) {
    c.x.push_back(3e3 + width * random());
    c.y.push_back(-20 + height * random());
  }
  return c;
}

// The clouds are slender and far from the origin, too.
TEST(quadratic_fit, a_quadratic_field_is_found_again) {
  double worst = 0, worst_curvature = 0;
  for (std::uint32_t seed = 1; seed <= 50; ++seed) {
    frames::Random random(seed + 100);
    const double width = std::pow(10, 2 * random()), height = std::pow(10, 2 * random());
    const Cloud c = cloud(6 + static_cast<int>(seed % 9) + 3, width, height, seed);
    const double f[6] = {random(), random(), random(), random(), random(), random()};
    const auto field = [&](double x, double y) {
      const double u = (x - 3e3) / width, v = (y + 20) / height;
      return f[0] + f[1] * u + f[2] * v + f[3] * u * u + f[4] * u * v + f[5] * v * v;
    };
    std::vector<double> value;
    for (std::size_t k = 0; k < c.x.size(); ++k) value.push_back(field(c.x[k], c.y[k]));
    const auto fit = fit_quadratic(3e3, -20, c.x, c.y, value);
    ASSERT_TRUE(fit);
    const double x = 3e3 + 0.3 * width, y = -20 - 0.4 * height;
    worst = std::max(worst, std::abs((*fit)(x, y) - field(x, y)));
    const auto weight = curvature_weights(c.x, c.y);
    ASSERT_EQ(weight.size(), c.x.size());
    double found[3] = {};
    for (std::size_t k = 0; k < weight.size(); ++k)
      for (std::size_t d = 0; d < 3; ++d) found[d] += weight[k][d] * value[k];
    worst_curvature =
        std::max({worst_curvature, std::abs(found[0] * width * width - 2 * f[3]),
                  std::abs(found[1] * width * height - f[4]), std::abs(found[2] * height * height - 2 * f[5])});
  }
  std::printf("value off by %.1e (bound 1e-8), curvatures by %.1e (bound 1e-7)\n", worst, worst_curvature);
  EXPECT_LE(worst, 1e-8);
  EXPECT_LE(worst_curvature, 1e-7);
}

TEST(quadratic_fit, points_that_do_not_determine_it) {
  const std::vector<double> line{0, 1, 2, 3, 4, 5, 6}, same(7, 2.0);
  EXPECT_FALSE(fit_quadratic(3, 2, line, same, line));
  EXPECT_FALSE(fit_quadratic(3, 3, line, line, line));
  EXPECT_TRUE(curvature_weights(line, same).empty());
  EXPECT_TRUE(curvature_weights(line, line).empty());
  const std::vector<double> x{0, 1, 2, 0, 1, 2}, y{0, 0, 0, 1, 1, 1};  // two lines of three
  EXPECT_TRUE(curvature_weights(x, y).empty());
  const std::vector<double> few_x{0, 1, 0, 1, 2}, few_y{0, 0, 1, 1, 3};
  EXPECT_TRUE(curvature_weights(few_x, few_y).empty());
}

}  // namespace
}  // namespace rollcon
