// Compares slices of points below a lattice by FFT with the same points one by one.

#include "bodies/halfspace/inside/direct.hpp"
#include "bodies/halfspace/interior_grid.hpp"
#include "linalg/fft.hpp"
#include "support/frames.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using inside::Solid;
using inside::Values;

constexpr Solid solid{2, 0.3};
constexpr double dx = 0.1, dy = 0.17, angle = 0.4;
constexpr int nx = 20, ny = 16;

/// Makes a turned grid.
Frame turned() {
  const std::vector<double> x = frames::uniform_lines(0, nx * dx, nx), y = frames::uniform_lines(0, ny * dy, ny);
  return build_frame(frames::rotate(frames::rectangle(ElementType::quad4, x, y), angle), Axes{});
}

std::vector<double> random_inside(const Frame& frame) {
  std::vector<double> t = inside::random_load(frame, 2);
  for (std::size_t k = 0; k < frame.x.size(); ++k)
    if (frame.rim[k]) t[3 * k] = t[3 * k + 1] = t[3 * k + 2] = 0;
  return t;
}

/// Returns places 2 .. 19 by 1 .. 16 of the grid, moved by a fraction of a cell, some of them beyond the load.
std::vector<std::array<double, 3>> slice_at(double shift_x, double shift_y, double z) {
  std::vector<std::array<double, 3>> points;
  for (int j = 1; j <= 17; ++j)
    for (int i = 2; i <= 21; ++i) {
      const double x = (i + shift_x) * dx, y = (j + shift_y) * dy;
      points.push_back({std::cos(angle) * x - std::sin(angle) * y, std::sin(angle) * x + std::cos(angle) * y, z});
    }
  return points;
}

/// Returns the error over the accuracy asked for.
double error_of_slice(const Frame& frame, double shift_x, double shift_y, double z, double accuracy) {
  const std::vector<double> t = random_inside(frame);
  const auto points = slice_at(shift_x, shift_y, z);
  std::vector<double> xyz, stress(6 * points.size()), u(3 * points.size());
  for (const auto& p : points) xyz.insert(xyz.end(), p.begin(), p.end());
  const std::optional<Lattice> lattice = find_lattice(frame);
  const InteriorGrid grid(*lattice, t.data(), {solid.shear, solid.poisson}, accuracy);
  EXPECT_TRUE(grid.usable());
  const std::vector<InteriorSlice> slices = grid.slices(std::ssize(points), xyz.data());
  EXPECT_EQ(slices.size(), 1U);
  if (slices.size() != 1) return 1e300;
  EXPECT_EQ(slices[0].point.size(), points.size());
  grid.evaluate(slices[0], stress.data(), u.data());
  const std::vector<Values> values = inside::from_library(frame, t, solid, points, accuracy / 10);
  double worst = 0;
  for (std::size_t p = 0; p < points.size(); ++p)
    for (std::size_t c = 0; c < 9; ++c)
      worst = std::max(worst, std::abs((c < 6 ? stress[6 * p + c] : u[3 * p + c - 6]) - values[p][c]));
  return worst / accuracy;
}

TEST(inside_slices, agree_with_points_one_by_one) {
  if (!has_fft()) GTEST_SKIP() << "built without FFTW";
  const Frame frame = turned();
  double worst = 0;
  for (const auto& [shift_x, shift_y, accuracy] :
       {std::tuple{0.0, 0.0, 1e-5}, {0.5, 0.5, 1e-5}, {0.3, 0.0, 1e-7}, {0.7, 0.9, 1e-4}})
    for (const double z : {0.0, 0.1, 0.25, 1.0})
      worst = std::max(worst, error_of_slice(frame, shift_x, shift_y, z, accuracy));
  expect_error("slices of points: error over the accuracy asked for", worst, 0.55);
}

TEST(inside_slices, points_off_the_grid_and_few_points_are_left) {
  if (!has_fft()) GTEST_SKIP() << "built without FFTW";
  const Frame frame = turned();
  const std::optional<Lattice> lattice = find_lattice(frame);
  std::vector<double> t = random_inside(frame);
  const InteriorGrid grid(*lattice, t.data(), {solid.shear, solid.poisson}, 1e-5);
  std::vector<double> xyz;
  for (const auto& p : slice_at(0.25, 0.5, 0.3)) xyz.insert(xyz.end(), p.begin(), p.end());
  xyz[3 * 7] += 1e-4 * dx;  // off its place
  xyz[3 * 9 + 2] = 0.31;    // at another depth
  xyz.insert(xyz.end(), {1e9, 0, 0.3});
  const std::vector<InteriorSlice> slices = grid.slices(std::ssize(xyz) / 3, xyz.data());
  ASSERT_EQ(slices.size(), 1U);
  EXPECT_EQ(slices[0].point.size(), xyz.size() / 3 - 3);
  EXPECT_EQ(std::count(slices[0].point.begin(), slices[0].point.end(), 7), 0);
  EXPECT_TRUE(grid.slices(100, xyz.data()).empty()) << "so few are faster one by one";
  // The hat under load lacks cells.
  for (std::size_t k = 0; k < frame.x.size(); ++k)
    if (frame.rim[k]) t[3 * k] = 1;
  EXPECT_FALSE(InteriorGrid(*lattice, t.data(), {solid.shear, solid.poisson}, 1e-5).usable());
}

}  // namespace
}  // namespace rollcon
