/// Tests heights between the points of a grid.

#include "geometry/height_grid.hpp"

#include "support/testing.hpp"

namespace rollcon {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();

template <class Height>
HeightGrid sampled(const GridPlace& on, const Height& height) {
  std::vector<double> value;
  for (std::int64_t j = 0; j < on.ny; ++j)
    for (std::int64_t i = 0; i < on.nx; ++i)
      value.push_back(
          height(on.x_least + (on.x_greatest - on.x_least) * static_cast<double>(i) / static_cast<double>(on.nx - 1),
                 on.y_least + (on.y_greatest - on.y_least) * static_cast<double>(j) / static_cast<double>(on.ny - 1)));
  return {on, value.data()};
}

template <class Height>
double worst(const GridPlace& on, const Height& height) {
  const HeightGrid grid = sampled(on, height);
  double error = 0;
  for (int k = 0; k < 2000; ++k) {
    const double x = on.x_least + (on.x_greatest - on.x_least) * std::fmod(0.618034 * k, 1.0),
                 y = on.y_least + (on.y_greatest - on.y_least) * std::fmod(0.754878 * k, 1.0);
    error = std::max(error, std::abs(grid(x, y) - height(x, y)));
  }
  return error;
}

TEST(height_grid, cubic_polynomials_are_met) {
  const auto cubic = [](double x, double y) { return (1 - x + 2 * x * x * x) * (2 + y - 3 * y * y * y) + x * x * y; };
  expect_error("5 x 9 points", worst({5, 9, -1, 2, -1, 1}, cubic), 1e-12);
  const auto quadratic = [](double x, double y) { return x * x - 3 * x * y + y * y; };
  expect_error("3 x 3 points, quadratic", worst({3, 3, -1, 2, -1, 1}, quadratic), 1e-13);
  const auto linear = [](double x, double y) { return 2 - x + y * x; };
  expect_error("2 x 2 points, bilinear", worst({2, 2, -1, 2, -1, 1}, linear), 1e-14);
}

TEST(height_grid, smooth_heights_converge_at_fourth_order) {
  const auto wave = [](double x, double y) { return std::sin(2 * x + 0.3) * std::cos(1.5 * y); };
  const double coarse = worst({21, 21, -2, 2, -2, 2}, wave), fine = worst({41, 41, -2, 2, -2, 2}, wave);
  expect_order("a wave", observed_order(coarse, fine, 2, 1), 3.7);
}

TEST(height_grid, ends_where_there_is_no_height) {
  const auto half = [](double x, double y) { return x > 0.5 ? none : x * x + y; };
  const HeightGrid grid = sampled({9, 5, -2, 2, -1, 1}, half);
  expect_error("beside the end", grid(0.4, 0.3) - 0.46, 1e-14);
  EXPECT_TRUE(std::isfinite(grid(0.5, 0.3)));
  EXPECT_EQ(grid(0.51, 0.3), none);
  EXPECT_EQ(grid(2.1, 0), none);
  EXPECT_TRUE(grid.ends_at(0.5, 0.3));
  EXPECT_FALSE(grid.ends_at(0.4, 0.3));
  EXPECT_FALSE(grid.ends_at(-2, 0.3));  // the end of the grid, not of the surface
}

// The height and its slopes do not jump where cells meet.
TEST(height_grid, slopes_are_continuous) {
  const HeightGrid grid = sampled({7, 7, 0, 6, 0, 6}, [](double x, double y) { return std::cos(7 * x) * y * y * y; });
  constexpr double step = 1e-6;
  for (const double y : {0.4, 2.7, 5.9}) {
    const double before = (grid(3, y) - grid(3 - step, y)) / step, after = (grid(3 + step, y) - grid(3, y)) / step;
    expect_error("slope at y = " + std::to_string(y), (after - before) / (1 + std::abs(after)), 3e-5);
  }
}

}  // namespace
}  // namespace rollcon
