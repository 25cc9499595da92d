/// Tests with a small table what must hold whatever its size.

#include "tables/creep_table.hpp"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <vector>

#include "support/error.hpp"
#include "support/testing.hpp"
#include "tables/rolling_sampler.hpp"
#include "tables/small_table.hpp"
#include "tables/spline_basis.hpp"

namespace rollcon {
namespace {

using small_tables::Answer;

TableGrid small_grid() {
  return small_tables::grid(8);
}

const std::vector<double>& samples() {
  static const std::vector<double> all = small_tables::solve(small_grid());
  return all;
}

const CreepTable& table() {
  static const CreepTable made = CreepTable::fit(small_grid(), samples());
  return made;
}

TableInput draw(frames::Random& random) {
  const double size = std::pow(10, random.between(-3, 2));
  TableInput in{8e4, random.between(0.28, 0.3), 0.3, 6, 5, 5e4, 0, 0, 0};
  small_tables::draw_creepages(random, size, in);
  return in;
}

Answer ask(const TableInput& in) {
  return small_tables::ask(table(), in);
}

TEST(creep_table, derivatives_are_those_of_its_forces) {
  frames::Random random(7);
  const auto draw_one = [&] { return draw(random); };
  const double worst = small_tables::worst_derivative(table(), draw_one, 1e-3, {{1, {0.28, 0.3}}});
  // The error comes from the curvature over the steps, and from single precision.
  expect_error("change of a force beside its derivative, over mu Fn", worst, 5e-7);
}

// Forces are linear in Poisson's ratio between the table's values, except for the bend at friction's limit.
TEST(creep_table, derivatives_by_poisson_are_one_from_end_to_end) {
  frames::Random random(8);
  double worst = 0;
  int compared = 0;
  for (int n = 0; n < 300; ++n) {
    TableInput in = draw(random);
    const double bound = in.friction * in.load;
    const auto at = [&](double poisson) {
      in.poisson = poisson;
      return ask(in);
    };
    const Answer first = at(0.28), middle = at(0.2863), last = at(0.3), below = at(0.25);
    if (std::hypot(first.force[0], first.force[1]) > 0.99 * bound) continue;
    ++compared;
    for (int i = 0; i < 3; ++i) {
      const double unit = bound * (i == 2 ? std::sqrt(in.a * in.b) : 1);
      const double change = last.force[i] - first.force[i];
      for (const Answer* a : {&first, &middle, &last, &below})
        worst = std::max(worst, std::abs(0.02 * a->by[i][1] - change) / unit);
    }
  }
  EXPECT_GT(compared, 100);
  expect_error("change over the table's Poisson's ratios beside its derivatives, over mu Fn", worst, 1e-12);
}

TEST(creep_table, friction_bounds_forces_and_symmetries_are_exact) {
  frames::Random random(11);
  for (int n = 0; n < 20000; ++n) {
    const TableInput in = draw(random);
    double f[3], g[3];
    table().evaluate(in, 0, f, nullptr);
    ASSERT_LE(std::hypot(f[0], f[1]), in.friction * in.load * (1 + 1e-12));
    TableInput other = in;  // mirrored across the rolling direction
    other.lateral = -in.lateral;
    other.spin = -in.spin;
    table().evaluate(other, 0, g, nullptr);
    ASSERT_EQ(f[0], g[0]);
    ASSERT_EQ(f[1], -g[1]);
    ASSERT_EQ(f[2], -g[2]);
    other = in;  // mirrored along it: slip and forces turn round
    other.longitudinal = -in.longitudinal;
    table().evaluate(other, 0, g, nullptr);
    const double bound = in.friction * in.load;
    ASSERT_NEAR(f[0], -g[0], 1e-6 * bound);
    ASSERT_NEAR(f[1], g[1], 1e-6 * bound);
    ASSERT_NEAR(f[2], g[2], 1e-6 * bound * std::sqrt(in.a * in.b));
  }
}

TEST(creep_table, small_creepages_are_linear_and_vast_ones_slide) {
  TableInput in{8e4, 0.28, 0.3, 5, 5, 5e4, 0, 0, 0};
  const Answer rest = ask(in);
  EXPECT_EQ(rest.force[0], 0);
  RollingSampler sampler(1, 0.28, 6, 4);
  const double unit = in.friction * in.load / (in.shear * in.a * in.b);
  const auto small = sampler.solve({1e-6, 0, 0}).extrapolated;
  expect_error("C11", rest.by[0][6] * unit / (in.friction * in.load) / (small[0] / 1e-6) - 1, 2e-6);
  in.longitudinal = 1e-5 * unit;
  expect_error("force by C11", ask(in).force[0] / (rest.by[0][6] * in.longitudinal) - 1, 1e-4);
  in.longitudinal = 1e3;
  in.lateral = -1e3;
  expect_error("sliding, along", ask(in).force[0] / (in.friction * in.load) + std::sqrt(0.5), 2e-3);
  expect_error("sliding, across", ask(in).force[1] / (in.friction * in.load) - std::sqrt(0.5), 2e-3);
}

TEST(creep_table_long, random_cases_are_those_of_the_solver) {
  frames::Random random(5);
  double sum = 0, worst = 0;
  constexpr int count = 60;
  for (int n = 0; n < count; ++n) {
    const double ratio = std::exp(random.between(-0.65, 0.65)), a = std::sqrt(ratio);
    const std::array<double, 3> creepage{random.between(-0.8, 0.8), random.between(-0.8, 0.8),
                                         random.between(-0.8, 0.8)};
    RollingSampler sampler(ratio, 0.29, 12, 8);
    const auto exact = sampler.solve(creepage).extrapolated;
    double f[3];
    table().evaluate({1, 0.29, 1, a, 1 / a, 1, creepage[0], creepage[1], creepage[2]}, 0, f, nullptr);
    const double error = std::max(std::hypot(f[0] - exact[0], f[1] - exact[1]), std::abs(f[2] - exact[2]));
    sum += error * error;
    worst = std::max(worst, error);
  }
  expect_error("root mean square over mu Fn, beside finer frames", std::sqrt(sum / count), 0.012);
  expect_error("worst", worst, 0.035);
}

/// The bodies slide everywhere, with the pole of sliding inside the contact, on its long axis or off it.
TEST(creep_table_long, frames_suit_the_shape) {
  const TableGrid grid;
  for (const double ratio : {0.04, 0.1, 0.3, 1.0, 4.0, 25.0}) {
    const StripsSize size = frame_of(grid, ratio);
    EXPECT_LE(size.along * size.across, 2 * grid.along * grid.across);
    RollingSampler sampler(ratio, 0.28, size.along, size.across);
    const double a = std::sqrt(ratio), b = 1 / a;
    double worst = 0;
    for (const double place : {-0.57, -0.23, 0.11, 0.37, 0.61})
      for (const double off : {0.0, 0.3}) {
        const double x = a * (ratio < 1 ? off : place), y = b * (ratio < 1 ? place : off);
        constexpr double vast = 100;
        const std::array<double, 3> creepage{vast * y, -vast * x, vast};
        sampler.reset();
        const auto found = sampler.solve(creepage).extrapolated;
        double exact[3];
        sliding_limit(ratio, creepage, exact);
        worst = std::max(worst, std::hypot(found[0] - exact[0], found[1] - exact[1], found[2] - exact[2]));
      }
    const double bound = std::abs(std::log(ratio)) > 3 ? 0.05 : 0.02;
    expect_error("a/b = " + std::to_string(ratio) + ", force and moment over mu Fn", worst, bound);
  }
}

TEST(creep_table, neither_parts_nor_threads_change_samples) {
  TableGrid grid = small_grid();
  grid.poisson = {0.3};
  const std::vector<double> one = small_tables::solve(grid, 1, 1), many = small_tables::solve(grid, 3, 2);
  for (std::size_t i = 0; i < one.size(); ++i) ASSERT_EQ(one[i], many[i]) << i;
}

TEST(creep_table, comes_back_from_its_file) {
  const std::string path = ::testing::TempDir() + "creep_table_test.rct";
  table().save(path);
  const CreepTable again = CreepTable::load(path);
  frames::Random random(3);
  for (int n = 0; n < 100; ++n) {
    const TableInput in = draw(random);
    double f[3], g[3];
    table().evaluate(in, 0, f, nullptr);
    again.evaluate(in, 0, g, nullptr);
    for (int i = 0; i < 3; ++i) ASSERT_EQ(f[i], g[i]);
  }
  std::FILE* file = std::fopen(path.c_str(), "r+b");
  ASSERT_NE(file, nullptr);
  std::fseek(file, 5000, SEEK_SET);
  std::fputc(0x55, file);
  std::fputc(0xaa, file);
  std::fclose(file);
  EXPECT_THROW(CreepTable::load(path), Error);
  // A size beyond the file's own is refused before anything of that size is allocated.
  std::filesystem::resize_file(path, 2000);
  EXPECT_THROW(CreepTable::load(path), Error);
  std::remove(path.c_str());
}

TEST(creep_table, missing_samples_make_none) {
  std::vector<double> sample = samples();
  sample[100] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(CreepTable::fit(small_grid(), sample), Error);
}

TEST(spline_basis, cubics_come_back_and_ends_are_what_they_are_said_to_be) {
  constexpr std::int64_t n = 7;
  const auto cubic = [](double x) { return 1 + x * (0.5 + x * (-0.3 + 0.02 * x)); };
  std::vector<double> value, c(n + 3);
  for (int i = 0; i <= n; ++i) value.push_back(cubic(i));
  SplineFit(n, SplineEnd::open, SplineEnd::open).apply(value, c);
  double worst = 0;
  for (double t = 0; t <= n; t += 0.13) {
    const SplineWeights w = spline_weights(t, n);
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) sum += w.value[i] * c[static_cast<std::size_t>(w.first) + i];
    worst = std::max(worst, std::abs(sum - cubic(t)));
  }
  expect_error("a cubic", worst, 1e-12);
  SplineFit(n, SplineEnd::flat, SplineEnd::straight).apply(value, c);
  expect_error("slope at a flat end", (c[2] - c[0]) / 2, 1e-12);
  expect_error("bend at a straight end", c[n] - 2 * c[n + 1] + c[n + 2], 1e-12);
}

}  // namespace
}  // namespace rollcon
