/// Tests tables of two bodies whose elastic constants differ.

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "support/error.hpp"
#include "support/scene.hpp"
#include "support/testing.hpp"
#include "tables/creep_table.hpp"
#include "tables/rolling_sampler.hpp"
#include "tables/small_table.hpp"

namespace rollcon {
namespace {

using closed_forms::Elastic;
using scenes::RollingPair;

/// The moduli have the ratio 3 : 1.
const UnlikePair pair_of_metals{{0.5, 1.5}, {0.28, 0.3}, {0.2, 0.3, 0.45}};

TableGrid small_grid() {
  TableGrid grid = small_tables::grid(10);
  grid.pair = pair_of_metals;
  grid.poisson = {grid.pair.mean_poisson()};
  return grid;
}

const CreepTable& table() {
  static const CreepTable made = CreepTable::fit(small_grid(), small_tables::solve(small_grid()));
  return made;
}

TableInput draw(frames::Random& random, double greatest_size = 2) {
  const double size = std::pow(10, random.between(-3, greatest_size));
  TableInput in{8e4, small_grid().poisson[0], random.between(0.2, 0.45), 6, 5, 5e4, 0, 0, 0};
  small_tables::draw_creepages(random, size, in);
  return in;
}

TEST(unlike_table_long, derivatives_are_those_of_its_forces) {
  frames::Random random(7);
  const double poisson = table().grid().poisson[0];  // the pair's, which cannot be changed
  const auto draw_one = [&] { return draw(random); };
  const double worst =
      small_tables::worst_derivative(table(), draw_one, 5e-4, {{1, {poisson, poisson}}, {2, {0.2, 0.45}}});
  expect_error("change of a force beside its derivative, over mu Fn", worst, 5e-7);
  for (int n = 0; n < 300; ++n) {
    const small_tables::Answer a = small_tables::ask(table(), draw_one());
    for (const auto& by : a.by) ASSERT_EQ(by[1], 0);
  }
}

TEST(unlike_table_long, friction_bounds_forces_and_one_symmetry_is_exact) {
  frames::Random random(11);
  double broken = 0;
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
    other = in;  // mirrored along it, where pressure pulls one way
    other.longitudinal = -in.longitudinal;
    table().evaluate(other, 0, g, nullptr);
    broken = std::max(broken, std::abs(f[0] + g[0]) / (in.friction * in.load));
  }
  EXPECT_GT(broken, 0.1);
}

/// The table is continuous where the creepages are none, where there is no spin and where there is nothing but spin.
TEST(unlike_table_long, seams_are_smooth) {
  frames::Random random(13);
  double value = 0, rate = 0;
  const auto compare = [&](const TableInput& in, const TableInput& beside) {
    const small_tables::Answer a = small_tables::ask(table(), in), b = small_tables::ask(table(), beside);
    const double bound = in.friction * in.load, length = std::sqrt(in.a * in.b);
    for (int i = 0; i < 3; ++i) {
      const double unit = bound * (i == 2 ? length : 1), creep = bound / (in.shear * in.a * in.b);
      value = std::max(value, std::abs(a.force[i] - b.force[i]) / unit);
      for (int j = 6; j < 9; ++j)
        rate = std::max(rate, std::abs(a.by[i][j] - b.by[i][j]) * creep / (j == 8 ? length : 1) / unit);
    }
  };
  for (int n = 0; n < 200; ++n) {
    TableInput in = draw(random, 0), beside = in;
    const double tiny = 1e-7;
    beside.spin = -(in.spin *= tiny);
    compare(in, beside);
    in = beside = draw(random, 0);
    in.longitudinal *= tiny, in.lateral *= tiny;
    beside.longitudinal = -in.longitudinal, beside.lateral = -in.lateral;
    compare(in, beside);
    in = draw(random, 0);
    in.longitudinal *= tiny, in.lateral *= tiny, in.spin *= tiny;
    beside = in;
    beside.longitudinal = beside.lateral = beside.spin = 0;
    compare(in, beside);
  }
  expect_error("forces across seams, over mu Fn", value, 2e-6);
  expect_error("their derivatives by creepages", rate, 1e-5);
}

TEST(unlike_table_long, random_cases_are_those_of_the_solver) {
  frames::Random random(5);
  double sum = 0, worst = 0, by_mean = 0;
  constexpr int count = 40;
  const double nu = table().grid().poisson[0];
  for (int n = 0; n < count; ++n) {
    const double ratio = std::exp(random.between(-0.65, 0.65)), a = std::sqrt(ratio), mu = random.between(0.2, 0.45);
    const std::array<double, 3> creepage{random.between(-0.8, 0.8), random.between(-0.8, 0.8),
                                         random.between(-0.8, 0.8)};
    RollingSampler sampler(ratio, pair_of_metals, mu, 10, 7), like(ratio, nu, 10, 7);
    const auto exact = sampler.solve(creepage).extrapolated, of_like = like.solve(creepage).extrapolated;
    double f[3];
    table().evaluate({1, nu, mu, a, 1 / a, 1 / mu, creepage[0], creepage[1], creepage[2]}, 0, f, nullptr);
    const auto error_of = [&](const auto& g) {
      return std::max(std::hypot(g[0] - exact[0], g[1] - exact[1]), std::abs(g[2] - exact[2]));
    };
    sum += error_of(f) * error_of(f);
    by_mean += error_of(of_like) * error_of(of_like);
    worst = std::max(worst, error_of(f));
  }
  expect_error("root mean square over mu Fn, beside finer frames", std::sqrt(sum / count), 0.012);
  expect_error("worst", worst, 0.04);
  EXPECT_GT(std::sqrt(by_mean / count), 0.08) << "like bodies of mean constants would do as well";
}

TEST(unlike_table_long, none_of_it_is_left_of_bodies_that_hardly_differ) {
  TableGrid grid = small_grid();
  grid.pair = {{1 - 1e-5, 1 + 1e-5}, {0.28, 0.28}, {0.3}};
  grid.poisson = {grid.pair.mean_poisson()};
  TableGrid of_like = small_grid();
  of_like.pair = {};
  of_like.poisson = {0.28};
  const CreepTable unlike = CreepTable::fit(grid, small_tables::solve(grid)),
                   like = CreepTable::fit(of_like, small_tables::solve(of_like));
  frames::Random random(17);
  double worst = 0;
  for (int n = 0; n < 300; ++n) {
    TableInput in = draw(random);
    in.friction = 0.3;
    in.poisson = 0.28;
    double f[3], g[3];
    unlike.evaluate(in, 0, f, nullptr);
    like.evaluate(in, 0, g, nullptr);
    for (int i = 0; i < 3; ++i)
      worst = std::max(worst, std::abs(f[i] - g[i]) / (in.friction * in.load * (i == 2 ? std::sqrt(in.a * in.b) : 1)));
  }
  expect_error("beside a table of like bodies", worst, 2e-5);
}

TEST(unlike_table_long, comes_back_from_its_file) {
  const std::string path = ::testing::TempDir() + "unlike_table_test.rct";
  table().save(path);
  const CreepTable again = CreepTable::load(path);
  std::remove(path.c_str());
  EXPECT_EQ(again.grid().pair.friction, pair_of_metals.friction);
  frames::Random random(3);
  for (int n = 0; n < 100; ++n) {
    const TableInput in = draw(random);
    double f[3], g[3];
    table().evaluate(in, 0, f, nullptr);
    again.evaluate(in, 0, g, nullptr);
    for (int i = 0; i < 3; ++i) ASSERT_EQ(f[i], g[i]);
  }
}

TEST(unlike_table_long, entries_that_are_not_the_pairs_are_refused) {
  TableInput in{8e4, table().grid().poisson[0], 0.3, 6, 5, 5e4, 1e-3, 0, 0};
  double f[3];
  table().evaluate(in, 0, f, nullptr);
  in.friction = 0.1;
  EXPECT_THROW(table().evaluate(in, 0, f, nullptr), Error);
  in.friction = 0.3;
  in.poisson += 0.01;
  EXPECT_THROW(table().evaluate(in, 0, f, nullptr), Error);
}

TEST(plane_weights, reproduce_parabolas_and_their_slopes) {
  const std::vector<double> x{-1.5, -1.1, -0.6, 0.3, 0.9};
  for (const std::size_t planes : {2U, 3U, 5U}) {
    const std::vector<double> of(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(planes));
    const double bend = planes == 2 ? 0 : 0.7;
    double worst = 0;
    for (double where = of.front(); where <= of.back(); where += 0.037) {
      const PlaneWeights w = plane_weights(of, where);
      double value = 0, slope = 0;
      for (int i = 0; i < w.count; ++i) {
        const double at = of[static_cast<std::size_t>(w.first + i)], f = 2 + at * (0.4 + bend * at);
        value += w.value[i] * f;
        slope += w.slope[i] * f;
      }
      worst = std::max(
          {worst, std::abs(value - 2 - where * (0.4 + bend * where)), std::abs(slope - 0.4 - 2 * bend * where)});
    }
    expect_error(std::to_string(planes) + " planes", worst, 1e-12);
  }
}

// The interface is asked for the pair's own contact, another pair, and the bodies in either order.
TEST(unlike_table, is_asked_by_contacts_of_its_bodies) {
  rollcon_context* context = nullptr;
  rollcon_table* made = nullptr;
  ASSERT_EQ(rollcon_context_create(ROLLCON_ABI, &context), ROLLCON_OK);
  ASSERT_EQ(rollcon_table_create(context, &made), ROLLCON_OK);
  constexpr Elastic stiff{.shear = 80000, .poisson = 0.28}, soft{.shear = 26000, .poisson = 0.33};
  const double young[2] = {2 * 1.28 * 80000, 2 * 1.33 * 26000}, poisson[2] = {0.28, 0.33}, mu = 0.3;
  ASSERT_EQ(rollcon_table_set_ratios(made, 4, 0.7, 1.5), ROLLCON_OK);
  ASSERT_EQ(rollcon_table_set_resolution(made, 8, 6, 6), ROLLCON_OK);
  ASSERT_EQ(rollcon_table_set_frame(made, 6, 4), ROLLCON_OK);
  ASSERT_EQ(rollcon_table_set_bodies(made, young, poisson, 1, &mu), ROLLCON_OK) << rollcon_last_error();
  ASSERT_EQ(rollcon_table_make(made, 0, 1), ROLLCON_OK) << rollcon_last_error();
  const auto solved = [&](const Elastic& body1, const std::optional<Elastic>& body2, double friction) {
    const auto hertz = closed_forms::hertz_from_axes(6, 5, 1000, closed_forms::effective_modulus(body1, *body2));
    auto pair = std::make_unique<RollingPair>(body1, body2);
    pair->rectangle(ElementType::quad4, 32, 32, 6.3, 5.3).gap_quadratic(hertz.A, hertz.B).load(hertz.load);
    pair->friction(friction).creep(1e-3, -5e-4, 1e-4).solve();
    return pair;
  };
  const auto rolling = solved(stiff, soft, mu), frictionless = solved(stiff, soft, 0);
  double force[3], moment[3], own[3], without[3];
  ASSERT_EQ(rollcon_contact_get_resultant(rolling->handle(), ROLLCON_LOCAL, force, moment), ROLLCON_OK);
  ASSERT_EQ(rollcon_table_evaluate_contact(made, rolling->handle(), -1, own), ROLLCON_OK) << rollcon_last_error();
  ASSERT_EQ(rollcon_table_evaluate_contact(made, frictionless->handle(), mu, without), ROLLCON_OK);
  const double bound = mu * -force[2];
  for (const double* f : {own, without}) {
    expect_error("force over mu Fn", std::hypot(f[0] - force[0], f[1] - force[1]) / bound, 0.01);
    expect_error("moment", (f[2] - moment[2]) / (bound * std::sqrt(30.0)), 0.01);
  }
  EXPECT_EQ(rollcon_table_evaluate_contact(made, frictionless->handle(), -1, own), ROLLCON_ERR_ARGUMENT);
  EXPECT_NE(std::string(rollcon_last_error()).find("friction of entry 0"), std::string::npos) << rollcon_last_error();
  EXPECT_EQ(rollcon_table_evaluate_contact(made, solved(soft, stiff, mu)->handle(), -1, own), ROLLCON_ERR_ARGUMENT);
  EXPECT_NE(std::string(rollcon_last_error()).find("the table's bodies"), std::string::npos) << rollcon_last_error();
  rollcon_table_release(made);
  rollcon_context_release(context);
}

}  // namespace
}  // namespace rollcon
