/// Tests contacts without a caller's frame: results, their accuracy, statuses.

#include "rollcon.h"
#include "support/frames.hpp"
#include "support/scene.hpp"
#include "support/steady_rolling.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using closed_forms::Elastic;
using scenes::RollingPair;
using scenes::Solution;
namespace steady_rolling = scenes::steady_rolling;
const Elastic steel = steady_rolling::steel;

// Returns force and spin moment over what friction carries.
std::array<double, 3> shares(const Solution& s, double bound, double length) {
  return {s.force[0] / bound, s.force[1] / bound, s.moment[2] / (bound * length)};
}

double vector_error(const std::array<double, 3>& found, const std::array<double, 3>& expected) {
  return std::hypot(found[0] - expected[0], found[1] - expected[1]);
}

RollingPair& hertzian(RollingPair& pair, const closed_forms::Hertz& hertz, double mu) {
  return pair.gap_quadratic(hertz.A, hertz.B).load(hertz.load).friction(mu);
}

TEST(automatic_frames, published_cases_of_steady_rolling) {
  for (const char* which : {"a", "b"}) {
    RollingPair pair(steel, steel);
    hertzian(pair, steady_rolling::hertz, steady_rolling::mu);
    pair.creep(steady_rolling::creepage, 0, *which == 'b' ? steady_rolling::spin : 0);
    ASSERT_EQ(pair.solve(), ROLLCON_OK);
    const auto found = shares(pair.solution(), steady_rolling::mu * steady_rolling::hertz.load, steady_rolling::radius);
    std::array<double, 3> limit{closed_forms::steady_rolling(which, "fx"), 0, 0};
    if (*which == 'b') {
      limit[1] = closed_forms::steady_rolling(which, "fy");
      limit[2] = closed_forms::steady_rolling(which, "mz");
    }
    const std::string name = std::string("case ") + which;
    const double promised = 0.005 * std::hypot(limit[0], limit[1]);
    expect_error(name + ", force vector over mu Fn", vector_error(found, limit), promised);
    expect_error(name + ", spin moment over mu Fn a", found[2] - limit[2], promised);
    EXPECT_LE(pair.stat("error_estimate"), 0.005);
    for (const char* words : {"made by the library", "closed integrals over strips", "friction by"})
      EXPECT_NE(pair.plan().find(words), std::string::npos) << pair.plan();
  }
}

TEST(automatic_frames, frictionless_contact_is_that_of_hertz) {
  for (const double ratio : {0.1, 0.5, 1.0, 3.0, 10.0}) {
    const auto hertz = closed_forms::hertz_from_axes(std::sqrt(ratio), 1 / std::sqrt(ratio), 1000,
                                                     closed_forms::effective_modulus(steel, steel));
    RollingPair pair(steel, steel);
    hertzian(pair, hertz, 0);
    ASSERT_EQ(pair.solve(), ROLLCON_OK);
    const std::string name = "a/b = " + std::to_string(ratio);
    expect_error(name + ": approach", relative(pair.solution().approach, hertz.approach), 2e-3);
    expect_error(name + ": area", relative(pair.stat("contact_area"), std::numbers::pi * hertz.a * hertz.b), 2e-3);
    pair.approach(hertz.approach);
    ASSERT_EQ(pair.solve(), ROLLCON_OK);
    expect_error(name + ": load of an approach", relative(-pair.solution().force[2], hertz.load), 3e-3);
  }
}

// Half-spaces that touch about (0, y0) roll and turn alike, wherever that is: the spin turns about the contact.
TEST(automatic_frames, results_do_not_depend_on_where_the_axes_are) {
  constexpr double wide = 6, spin = 2e-4, mu = 0.3;
  constexpr std::int32_t points = 241;
  for (const double accuracy : {0.05, 0.005}) {
    double first = 0;
    for (const double y0 : {0.0, 30.0, -100.0}) {
      std::vector<double> gap;
      for (std::int32_t i = 0; i < points * points; ++i) {
        const double x = wide * (2.0 * (i % points) / (points - 1) - 1),
                     y = wide * (2.0 * (i / points) / (points - 1) - 1);
        gap.push_back(x * x / 600 + y * y / 400);
      }
      RollingPair pair(steel, steel);
      ASSERT_EQ(rollcon_contact_set_gap_grid(pair.handle(), points, -wide, wide, y0 - wide, y0 + wide,
                                             static_cast<std::int64_t>(gap.size()), gap.data()),
                ROLLCON_OK);
      pair.load(8000).friction(mu).creep(-5e-4 + y0 * spin, 3e-4, spin).option("frame_accuracy", accuracy);
      ASSERT_EQ(pair.solve(), ROLLCON_OK);
      const auto s = pair.solution();
      const double x = -s.moment[1] / s.force[2], y = s.moment[0] / s.force[2];
      const double own = (s.moment[2] - (x * s.force[1] - y * s.force[0])) / (mu * 8000);
      if (y0 == 0) first = own;
      expect_error("y0 = " + std::to_string(y0) + ": spin moment about the contact, mm of mu Fn", own - first, 1e-8);
    }
  }
}

// Without friction the creepages that are given are told.
TEST(automatic_frames, given_creepages_are_told_without_friction) {
  for (const double accuracy : {0.06, 0.002}) {
    RollingPair pair(steel, steel);
    pair.gap_quadratic(0.01, 0.005).load(1000).friction(0).creep(-1e-3, 5e-4, 1e-4).option("frame_accuracy", accuracy);
    ASSERT_EQ(pair.solve(), ROLLCON_OK);
    const auto creep = pair.solution().creep;
    EXPECT_EQ(creep[0], -1e-3);
    EXPECT_EQ(creep[1], 5e-4);
    EXPECT_EQ(creep[2], 1e-4);
  }
}

// Where results of two counts are mixed, derivatives under a law are those of the finer strips.
TEST(automatic_frames, derivatives_under_laws_are_there_where_counts_are_mixed) {
  const double parameters[] = {0.36, 0.19, 0.2}, step = 1e-7;
  for (const double accuracy : {0.05, 0.02}) {
    RollingPair pair(steel, steel);
    pair.gap_quadratic(1 / 920.0, 1 / 600.0).load(80000).option("frame_accuracy", accuracy);
    ASSERT_EQ(rollcon_contact_set_friction(pair.handle(), "rational", 3, parameters), ROLLCON_OK);
    const auto force_at = [&](double creep) {
      pair.creep(creep, 1e-4, 1e-5);
      EXPECT_EQ(pair.solve(), ROLLCON_OK);
      return pair.solution().force[0];
    };
    force_at(-5e-4);
    double force[3] = {}, moment[3] = {}, approach = 0, creep[3] = {};
    ASSERT_EQ(rollcon_contact_get_sensitivity(pair.handle(), ROLLCON_LONGITUDINAL, force, moment, &approach, creep),
              ROLLCON_OK);
    const double slope = (force_at(-5e-4 + step) - force_at(-5e-4 - step)) / (2 * step);
    expect_error("accuracy " + std::to_string(accuracy) + ": slope by differences", relative(force[0], slope), 0.015);
  }
}

// Ellipses at any angle to the rolling direction are compared with a fine lattice; lattices of this size are off by
// half a per cent themselves.
TEST(automatic_frames_long, ellipses_at_any_angle_beside_lattices) {
  const double a = 2, b = 1, mu = 0.3;
  const auto hertz = closed_forms::hertz_from_axes(a, b, 1000, closed_forms::effective_modulus(steel, steel));
  for (const double angle : {0.5, 1.2, 2.4}) {
    const double c = std::cos(angle), s = std::sin(angle);
    RollingPair pair(steel, steel);
    pair.gap_quadratic(hertz.A * c * c + hertz.B * s * s, hertz.A * s * s + hertz.B * c * c,
                       2 * (hertz.A - hertz.B) * c * s);
    pair.load(hertz.load).friction(mu).creep(-6e-4, 4e-4, 4e-4);
    ASSERT_EQ(pair.solve(), ROLLCON_OK);
    const auto automatic = shares(pair.solution(), mu * hertz.load, std::sqrt(a * b));
    const auto lines = frames::uniform_lines(-2.1, 2.1, 126);
    pair.frame(frames::rectangle(ElementType::quad4, lines, lines));
    ASSERT_EQ(pair.solve(), ROLLCON_OK);
    const auto lattice = shares(pair.solution(), mu * hertz.load, std::sqrt(a * b));
    const std::string name = "ellipse at " + std::to_string(angle);
    expect_error(name + ", force vector beside 127 x 127", vector_error(automatic, lattice), 0.004);
    expect_error(name + ", spin moment", automatic[2] - lattice[2], 0.002);
  }
}

TEST(automatic_frames, motions_found_for_given_forces_lead_back_to_them) {
  const double mu = 0.25;
  const auto hertz = closed_forms::hertz_from_axes(1, 1.5, 1000, closed_forms::effective_modulus(steel, steel));
  const double bound = mu * hertz.load;
  RollingPair pair(steel, steel);
  hertzian(pair, hertz, mu);
  pair.tangential_force(ROLLCON_LONGITUDINAL, 0.4 * bound).tangential_force(ROLLCON_LATERAL, -0.3 * bound);
  ASSERT_EQ(pair.solve(), ROLLCON_OK);
  const Solution given = pair.solution();
  expect_error("the forces given", std::hypot(given.force[0] / bound - 0.4, given.force[1] / bound + 0.3), 1e-9);
  pair.creep(given.creep[0], given.creep[1], given.creep[2]);
  ASSERT_EQ(pair.solve(), ROLLCON_OK);
  const Solution back = pair.solution();
  expect_error("forces under the creepages found",
               std::hypot(back.force[0] - given.force[0], back.force[1] - given.force[1]) / bound, 1e-4);
}

// The pair's sensitivities are those of its extrapolated results.
TEST(automatic_frames, sensitivities_are_derivatives_of_the_results) {
  RollingPair pair(steel, steel);
  hertzian(pair, steady_rolling::hertz, 0.3);
  const double xi = -5e-4, step = 1e-8;
  const auto force_at = [&](double creepage) {
    pair.creep(creepage, 2e-4, 1e-4);
    EXPECT_EQ(pair.solve(), ROLLCON_OK);
    return pair.solution().force;
  };
  const auto less = force_at(xi - step), more = force_at(xi + step);
  force_at(xi);
  double rate[3];
  ASSERT_EQ(rollcon_contact_get_sensitivity(pair.handle(), ROLLCON_LONGITUDINAL, rate, nullptr, nullptr, nullptr),
            ROLLCON_OK);
  for (std::size_t i = 0; i < 2; ++i)
    expect_error("derivative of force " + std::to_string(i),
                 (rate[i] - (more[i] - less[i]) / (2 * step)) / std::abs(rate[0]), 1e-7);
}

TEST(automatic_frames, units_do_not_matter) {
  std::array<double, 3> found[2];
  const double unit[2] = {1, 1e-3};
  for (std::size_t u = 0; u < 2; ++u) {
    const double l = unit[u];  // N and unit length: moduli per square
    const Elastic material{.shear = 82000 / (l * l), .poisson = 0.28};
    RollingPair pair(material, Elastic{.shear = 30000 / (l * l), .poisson = 0.35});
    pair.gap_quadratic(1e-3 / l, 3e-3 / l, 1e-3 / l).load(5000).friction(0.3).creep(5e-4, -4e-4, 2e-4 / l);
    ASSERT_EQ(pair.solve(), ROLLCON_OK);
    found[u] = shares(pair.solution(), 1500, l);
  }
  expect_error("mm and m, force", vector_error(found[0], found[1]), 1e-11);
  expect_error("mm and m, moment", found[0][2] - found[1][2], 1e-11);
}

// Pressures of unlike bodies move surfaces along each other, which nothing resists.
TEST(automatic_frames, unlike_bodies_without_friction_carry_nothing_along_the_surface) {
  RollingPair pair(steel, Elastic{.shear = 30000, .poisson = 0.35});
  pair.gap_quadratic(1e-3, 3e-3, 1e-3).approach(0.01).friction(0.3).creep(5e-4, 0, 0);
  ASSERT_EQ(pair.solve(), ROLLCON_OK);
  pair.friction(0).tangential_force(ROLLCON_LONGITUDINAL, 0).tangential_force(ROLLCON_LATERAL, 0);
  for (const bool warm : {true, false}) {
    if (!warm) pair.reset();
    ASSERT_EQ(pair.solve(), ROLLCON_OK);
    const Solution s = pair.solution();
    EXPECT_EQ(std::hypot(s.force[0], s.force[1]), 0);
    EXPECT_EQ(pair.stat("law_equilibrium"), 0);
  }
}

TEST(automatic_frames, bodies_apart_are_told) {
  RollingPair pair(steel, steel);
  pair.gap_quadratic(1e-3, 1e-3).approach(-0.1).friction(0.3).creep(1e-3, 0, 0);
  EXPECT_EQ(pair.solve(), ROLLCON_NO_CONTACT);
  EXPECT_EQ(pair.solution().force[0], 0);
  pair.load(0);
  EXPECT_EQ(pair.solve(), ROLLCON_NO_CONTACT);
  pair.load(1000);
  EXPECT_EQ(pair.solve(), ROLLCON_OK);
}

TEST(automatic_frames_long, an_accuracy_beyond_the_finest_frame_is_not_called_success) {
  // The pressure of a body on a rigid one strains it alone, which converges slowly.
  RollingPair pair(steel, std::nullopt);
  const auto hertz = closed_forms::hertz_from_axes(1, 3, 1000, closed_forms::effective_modulus(steel));
  hertzian(pair, hertz, 0.3);
  pair.creep(0, 1e-4, 2e-3);
  pair.option("frame_accuracy", 1e-4);
  const std::int32_t status = pair.solve();
  EXPECT_EQ(status, ROLLCON_INACCURATE);
  EXPECT_GT(pair.stat("error_estimate"), 1e-4);
  EXPECT_LT(pair.stat("error_estimate"), 0.02);
}

TEST(automatic_frames, what_is_missing_is_told) {
  RollingPair pair(steel, steel);
  pair.friction(0.3);
  const auto expect_state = [&](const char* words) {
    EXPECT_EQ(rollcon_contact_solve(pair.handle()), ROLLCON_ERR_STATE);
    EXPECT_NE(std::string(rollcon_last_error()).find(words), std::string::npos) << rollcon_last_error();
  };
  expect_state("rollcon_contact_set_gap_quadratic");
  pair.gap_quadratic(1e-3, -1e-3);
  expect_state("does not grow in all directions");
  const double h = 0;
  EXPECT_EQ(rollcon_contact_set_gap(pair.handle(), 1, &h), ROLLCON_ERR_STATE);
  pair.gap_quadratic(1e-3, 1e-3).load(100);
  EXPECT_EQ(pair.solve(), ROLLCON_OK);
  // The nodes are the library's, so nothing can be given at them.
  const std::vector<double> mu(static_cast<std::size_t>(pair.solution().nodes()), 0.1);
  EXPECT_EQ(rollcon_contact_set_friction_field(pair.handle(), static_cast<std::int64_t>(mu.size()), mu.data()),
            ROLLCON_ERR_STATE);
}

// Each case is solved on frames of its own, with the results of single solves, on any number of threads.
TEST(automatic_frames, lists_of_cases) {
  RollingPair pair(steel, steel);
  hertzian(pair, steady_rolling::hertz, 0.3).creep(0, 0, 2e-4).option("frame_accuracy", 0.01);
  ASSERT_EQ(pair.solve(), ROLLCON_OK);
  const Solution before = pair.solution();
  const double full = steady_rolling::hertz.load;
  std::vector<std::array<double, 3>> given;  // load, creepage, factor on friction
  for (const double load : {0.3, 1.0, 2.5})
    for (const double creep : {-4e-4, 1e-4, 6e-4})
      for (const double factor : {0.5, 1.0}) given.push_back({load * full, creep, factor});
  const auto solve = [&](int threads) {
    EXPECT_EQ(rollcon_context_set_threads(pair.context(), threads), ROLLCON_OK);
    std::vector<double> row(given.size() * 38);
    std::vector<std::int32_t> status(given.size(), -1);
    EXPECT_EQ(rollcon_contact_solve_many(pair.handle(), "normal longitudinal friction",
                                         static_cast<std::int64_t>(given.size()), given[0].data(),
                                         "force moment approach derivatives contact_area", 38, row.data(), nullptr,
                                         status.data()),
              ROLLCON_OK)
        << rollcon_last_error();
    for (const std::int32_t s : status) EXPECT_EQ(s, ROLLCON_OK);
    return row;
  };
  const std::vector<double> one = solve(1), two = solve(2);
  EXPECT_EQ(one, two) << "threads";
  EXPECT_EQ(pair.solution().force, before.force) << "the last solution stays";
  double worst = 0;  // all are on pairs of one size
  for (std::size_t i = 0; i < given.size(); ++i) {
    const auto& [load, creep, factor] = given[i];
    RollingPair single(steel, steel);
    hertzian(single, steady_rolling::hertz, 0.3 * factor).load(load).creep(creep, 0, 2e-4);
    single.option("frame_accuracy", 0.01);
    ASSERT_EQ(single.solve(), ROLLCON_OK);
    const Solution s = single.solution();
    const double* row = one.data() + 38 * i;
    const double bound = 0.3 * factor * load;
    double by_creepage[3], by_friction[3];
    ASSERT_EQ(
        rollcon_contact_get_sensitivity(single.handle(), ROLLCON_LONGITUDINAL, by_creepage, nullptr, nullptr, nullptr),
        ROLLCON_OK);
    // The sensitivity is that to relative changes of all coefficients.
    ASSERT_EQ(
        rollcon_contact_get_sensitivity(single.handle(), ROLLCON_FRICTION, by_friction, nullptr, nullptr, nullptr),
        ROLLCON_OK);
    for (const double error :
         {(row[0] - s.force[0]) / bound, (row[1] - s.force[1]) / bound, row[2] / s.force[2] - 1,
          (row[5] - s.moment[2]) / bound, row[6] / s.approach - 1, row[37] / single.stat("contact_area") - 1,
          (row[17] - by_creepage[0]) * 1e-4 / bound, (row[27] * factor - by_friction[0]) / bound})
      worst = std::max(worst, std::abs(error));
  }
  expect_error("18 cases beside each by itself: forces, moment, approach, area, derivatives", worst, 1e-9);
}

TEST(automatic_frames, refusals_of_lists) {
  RollingPair pair(steel, steel);
  hertzian(pair, steady_rolling::hertz, 0.3);
  const double value[2] = {10, 20};
  double row[6];
  std::int32_t status[2];
  const auto expect = [&](const char* parameters, const char* columns, std::int32_t refusal, const char* words) {
    EXPECT_EQ(rollcon_contact_solve_many(pair.handle(), parameters, 2, value, columns, 3, row, nullptr, status),
              refusal);
    EXPECT_NE(std::string(rollcon_last_error()).find(words), std::string::npos) << rollcon_last_error();
  };
  ASSERT_EQ(pair.solve(), ROLLCON_OK);
  std::vector<double> tractions(6 * static_cast<std::size_t>(pair.solution().nodes()));
  EXPECT_EQ(
      rollcon_contact_solve_many(pair.handle(), "normal", 2, value, "tractions",
                                 static_cast<std::int64_t>(tractions.size() / 2), tractions.data(), nullptr, status),
      ROLLCON_ERR_STATE);
  EXPECT_NE(std::string(rollcon_last_error()).find("rollcon_contact_frame_ellipse"), std::string::npos);
  const double falling[4] = {0.3, 0.2, 0.1, 1};
  ASSERT_EQ(rollcon_contact_set_rolling(pair.handle(), 1), ROLLCON_OK);
  if (rollcon_contact_set_friction(pair.handle(), "exponential", 3, falling) == ROLLCON_OK)
    expect("friction", "force", ROLLCON_ERR_UNSUPPORTED, "Coulomb");
  pair.friction(0.3);
  ASSERT_EQ(rollcon_contact_set_step(pair.handle(), ROLLCON_ROLLING_STEP, 0.1), ROLLCON_OK);
  expect("normal", "force", ROLLCON_ERR_STATE, "time steps");
  ASSERT_EQ(rollcon_contact_set_step(pair.handle(), ROLLCON_STEADY, 0), ROLLCON_OK);
  // A case that fails leaves the others alone.
  pair.tangential_force(ROLLCON_LONGITUDINAL, 4);
  EXPECT_EQ(rollcon_contact_solve_many(pair.handle(), "normal", 2, value, "force", 3, row, nullptr, status),
            ROLLCON_NOT_CONVERGED);
  EXPECT_EQ(status[0], ROLLCON_ERR_LOAD);
  EXPECT_TRUE(std::isnan(row[0]));
  EXPECT_EQ(status[1], ROLLCON_OK);
  EXPECT_NEAR(row[3], 4, 1e-6);
}

TEST(automatic_frames, callers_frames_come_and_go) {
  RollingPair pair(steel, steel);
  hertzian(pair, steady_rolling::hertz, 0.3).creep(-5e-4, 0, 0);
  ASSERT_EQ(pair.solve(), ROLLCON_OK);
  const double automatic = pair.solution().force[0];
  pair.frame(steady_rolling::grid(20));
  ASSERT_EQ(pair.solve(), ROLLCON_OK);
  EXPECT_EQ(pair.solution().nodes(), 400U);
  EXPECT_GT(std::abs(pair.solution().force[0] - automatic), 1e-3 * std::abs(automatic));
  ASSERT_EQ(rollcon_contact_frame_automatic(pair.handle()), ROLLCON_OK);
  ASSERT_EQ(pair.solve(), ROLLCON_OK);
  expect_error("the library's frame again", relative(pair.solution().force[0], automatic), 1e-8);
}

}  // namespace
}  // namespace rollcon
