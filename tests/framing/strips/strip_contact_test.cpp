/// Contacts on strips beside Hertz, Kalker's coefficients and fine lattices.

#include "framing/strips/strip_adhesion.hpp"
#include "framing/strips/strip_families.hpp"
#include "support/scene.hpp"
#include "support/steady_rolling.hpp"

namespace rollcon::strips {
namespace {

using std::numbers::pi;

/// A gap whose contact has the semi-axes a along and b across rolling.
FamilyGap gap_of(double a, double b, double modulus, double load) {
  const auto hertz = closed_forms::hertz_from_axes(std::max(a, b), std::min(a, b), 1.5 * load / (pi * a * b), modulus);
  FamilyGap gap(FamilyGap::ellipse, 0);
  gap.a = a > b ? hertz.A : hertz.B;
  gap.b = a > b ? hertz.B : hertz.A;
  return gap;
}

// A wheel's outline over a rail's arcs has no mirror image across rolling; where all sticks forces are symmetric.
TEST(strips, adhesion_has_the_symmetries_of_linear_theory) {
  StripCase test(FamilyGap::arcs, 3);
  test.scene.motion = {};
  StripContact contact;
  StripSolution solution;
  ASSERT_EQ(contact.solve(test.now(), wide, {12, 12}, solution, false).status, StripStatus::solved);
  Adhesion k;
  ASSERT_TRUE(adhere(contact, test.now(), solution, k));
  const double unit = k.force[0][0], length = solution.strips.geometry[solution.strips.layout.width_of(0)];
  expect_error("K13 - K31", (k.force[2][0] - k.force[0][2]) / (unit * length), 1e-3);
  expect_error("K12 + K21", (k.force[1][0] + k.force[0][1]) / unit, 1e-3);
  EXPECT_GT(std::abs(k.force[2][0] / (unit * length)), 0.02);
  // A solve under small motions and high friction has the forces.
  const double small = 1e-6;
  test.scene.mu = 100;
  test.scene.motion = {small, 0, -small / length};
  ASSERT_EQ(contact.solve(test.now(), wide, {12, 12}, solution, false).status, StripStatus::solved);
  const StripTotals total = StripContact::totals(solution);
  for (std::size_t i = 0; i < 3; ++i)
    expect_error("force",
                 (total.force[i] / small - k.force[0][i] + k.force[2][i] / length) / unit / (i == 2 ? length : 1),
                 2e-3);
}

TEST(strips, adhesion_on_ellipses_is_kalkers) {
  const StripBodies bodies = equal_bodies();
  StripContact contact;
  StripSolution solution;
  Adhesion k, larger;
  ASSERT_GT(adhere_on_ellipse(contact, bodies, 5, 5, {12, 12}, solution, k), 0);
  ASSERT_GT(adhere_on_ellipse(contact, bodies, 10, 10, {12, 12}, solution, larger), 0);
  // Kalker's coefficients for a/b = 1 lie between those of nu = 1/4 and 1/2: 4.12 and 4.85, 3.67 and 3.81.
  const double unit = -8e4 * 25;
  EXPECT_NEAR(k.force[0][0] / unit, 4.20, 0.09);
  EXPECT_NEAR(k.force[1][1] / unit, 3.69, 0.09);
  expect_error("size", larger.force[2][1] / k.force[2][1] / 8 - 1, 1e-6);
}

TEST(strips, fit_ellipses_of_hertz) {
  StripFinder finder;
  double chord = 0, width = 0, approach = 0, peak = 0, fine_peak = 0;
  for (const double ratio : {0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 10.0})
    for (const StripCounts counts : {StripCounts{8, 12}, StripCounts{12, 12}}) {
      StripCase test(FamilyGap::ellipse, 0);
      const double a = 5 * std::sqrt(ratio), b = 5 / std::sqrt(ratio);
      const double modulus = 1 / (pi * test.scene.bodies.cn);
      const auto hertz = closed_forms::hertz_from_axes(std::max(a, b), std::min(a, b), 1.5e5 / (pi * a * b), modulus);
      test.gap = gap_of(a, b, modulus, 1e5);
      StripState state;
      const Rectangle box{-1.9 * a, 2 * a, -1.7 * b, 2 * b};
      ASSERT_EQ(finder.find(test.now(), box, counts, state, false).status, StripStatus::solved);
      const StripLayout& l = state.layout;
      const double top = relative(largest_pressure(state).pressure, hertz.p0);
      if (counts.along == 12) {
        fine_peak = std::max(fine_peak, top);
        continue;
      }
      peak = std::max(peak, top);
      chord = std::max(chord, relative(state.geometry[l.half_of(l.rows / 2)], a));
      width = std::max(width, relative(state.geometry[l.width_of(0)], b));
      approach = std::max(approach, relative(state.approach, hertz.approach));
    }
  expect_error("half chord in the middle, 8 x 12", chord, 4.5e-3);
  expect_error("half width", width, 9e-3);
  expect_error("approach", approach, 1.5e-3);
  expect_error("largest pressure", peak, 4e-3);
  expect_error("largest pressure, 12 x 12", fine_peak, 1.5e-3);
}

// The known values are those of strips 32 x 40 under a Poisson's ratio of 0.28.
TEST(strips, have_kalkers_coefficients) {
  constexpr double known[3][3] = {{3.742, 3.030, 0.942}, {4.223, 3.706, 1.483}, {5.210, 4.985, 2.658}};
  constexpr double shear = 8e4;
  StripFinder finder;
  double straight = 0, spin = 0;
  for (int i = 0; i < 3; ++i) {
    const double ratio = i == 0 ? 0.5 : i == 1 ? 1 : 2, a = 5 * std::sqrt(ratio), b = 5 / std::sqrt(ratio);
    for (int k = 0; k < 3; ++k) {
      StripCase test(FamilyGap::ellipse, 0, equal_bodies(shear));
      test.gap = gap_of(a, b, 1 / (pi * test.scene.bodies.cn), 1e5);
      test.scene.motion = {};
      test.scene.motion[k] = 1e-7;
      StripState state;
      ASSERT_EQ(finder.find(test.now(), wide, {8, 12}, state, false).status, StripStatus::solved);
      const StripTotals t = StripSolver::totals(state);
      const double c = std::abs(t.force[k == 2 ? 1 : k]) / 1e-7 / shear / std::pow(a * b, k == 2 ? 1.5 : 1);
      (k == 2 ? spin : straight) = std::max(k == 2 ? spin : straight, relative(c, known[i][k]));
    }
  }
  expect_error("C11 and C22, 8 x 12", straight, 4e-3);
  expect_error("C23", spin, 1.4e-2);
}

// Lattices of 64 and 128 cells, extrapolated to first order, under the same slanted gap.
void expect_lattice(const char* name, std::optional<closed_forms::Elastic> second, double force_bound) {
  const auto steel = scenes::steady_rolling::steel;
  using scenes::RollingPair;
  constexpr double load = 1000, mu = 0.3;
  FamilyGap gap(FamilyGap::ellipse, 0);
  gap.a = 1e-3, gap.b = 2.2e-3, gap.c = 8e-4;
  RollingPair pair(steel, second);
  pair.load(load).friction(mu).creep(-4e-4, 2e-4, 1e-4).gap_quadratic(gap.a, gap.b, gap.c);
  std::array<double, 4> found{};
  StripCase test(FamilyGap::ellipse, 0);
  test.gap = gap;
  const double unit = 1 / (2 * pi * steel.shear);
  test.scene.bodies =
      second ? equal_bodies(steel.shear, steel.poisson)
             : StripBodies{(1 - steel.poisson) * unit, steel.poisson * unit, (1 - 2 * steel.poisson) * unit / 2};
  test.scene.value = load;
  test.scene.mu = mu;
  test.scene.motion = {-4e-4, 2e-4, 1e-4};
  StripFinder finder;
  StripState state;
  ASSERT_EQ(finder.find(test.now(), {-6, 5, -4, 5}, {12, 12}, state, false).status, StripStatus::solved);
  const StripTotals t = StripSolver::totals(state);
  const StripLayout& l = state.layout;
  double half = 0;
  for (int k = 0; k < l.rows; ++k) half = std::max(half, std::abs(state.geometry[k]) + state.geometry[l.half_of(k)]);
  half *= 1.05;
  const double across = 1.05 * state.geometry[l.width_of(0)];
  for (const int n : {64, 128}) {
    ASSERT_EQ(rollcon_contact_frame_rectangle(pair.handle(), ROLLCON_QUAD4, n, n, -half, half, -across, across),
              ROLLCON_OK);
    ASSERT_EQ(pair.solve(), ROLLCON_OK);
    const auto s = pair.solution();
    for (int c = 0; c < 4; ++c) {
      const double value = c < 2 ? s.force[c] : c == 2 ? s.moment[2] : s.approach;
      found[c] = n == 64 ? value : 2 * value - found[c];
    }
  }
  const std::string title = name;
  expect_error(title + ": force over mu Fn", std::hypot(t.force[0] - found[0], t.force[1] - found[1]) / (mu * load),
               force_bound);
  expect_error(title + ": spin moment", (t.force[2] - found[2]) / (mu * load * half), force_bound);
  expect_error(title + ": approach", relative(t.approach, found[3]), 2e-3);
}

// Where all slides under spin, slip turns along each chord: few nodes find it if it is extrapolated to them as a curve.
TEST(strips, slide_under_spin_at_few_nodes) {
  StripContact contact;
  StripSolution solution;
  for (const double lateral : {-8e-3, 0.0, 8e-3}) {
    StripCase test(FamilyGap::ellipse, 0.3);
    test.scene.motion = {8e-3, lateral, 1e-3};
    ASSERT_EQ(contact.solve(test.now(), wide, {24, 22}, solution, false).status, StripStatus::solved);
    const StripTotals fine = StripContact::totals(solution);
    ASSERT_EQ(contact.solve(test.now(), wide, {12, 12}, solution, false).status, StripStatus::solved);
    const StripTotals few = StripContact::totals(solution);
    const double off = std::hypot(few.force[0] - fine.force[0], few.force[1] - fine.force[1]);
    expect_error("12 x 12 beside 24 x 22: force over mu Fn", off / (0.3 * fine.load), 2.5e-3);
  }
}

TEST(strips, agree_with_lattices) {
  const auto steel = scenes::steady_rolling::steel;
  expect_lattice("equal bodies", steel, 3e-3);
  expect_lattice("on a rigid body", std::nullopt, 5e-3);
}

// Loads that are given are met, and the creepages are those that the loads came from.
TEST(strips, take_loads_in_place_of_motions) {
  for (const bool unlike : {false, true}) {
    StripCase test(FamilyGap::arcs, 0.3, unlike ? on_rigid() : equal_bodies());
    StripFinder finder;
    StripState state;
    ASSERT_EQ(finder.find(test.now(), wide, {8, 12}, state, false).status, StripStatus::solved);
    const StripTotals first = StripSolver::totals(state);
    test.scene.motion = {first.force[0], -5e-4, first.force[2]};
    test.scene.force_given = {true, false, true};
    test.scene.by_load = false;
    test.scene.value = first.approach;
    ASSERT_EQ(finder.find(test.now(), wide, {8, 12}, state, false).status, StripStatus::solved);
    const StripTotals second = StripSolver::totals(state);
    expect_error("creepage", relative(second.motion[0], 1e-3), 1e-6);
    expect_error("spin", relative(second.motion[2], 2e-4), 1e-6);
    expect_error("load", relative(second.load, 1e5), 1e-8);
    expect_error("lateral force", relative(second.force[1], first.force[1]), 1e-6);
  }
}

// Rounding leaves residuals of all equations at once above 1e-9.
TEST(strips_long, of_unlike_bodies_end_on_many_nodes) {
  StripCase test(FamilyGap::ellipse, 0, unlike_bodies());
  test.gap.a = 7.029361599e-3;
  test.gap.b = 6.675473626e-4;
  test.scene.value = 52359.87756;
  test.scene.motion = {6.027977529e-4, -3.728755881e-4, 0};
  StripContact contact;
  StripSolution solution;
  std::array<double, 6> found[2];
  for (const int fine : {0, 1}) {
    const StripCounts counts = fine == 0 ? StripCounts{20, 30} : StripCounts{24, 36};
    const StripReport report = contact.solve(test.now(), wide, counts, solution, false, false);
    ASSERT_EQ(report.status, StripStatus::solved);
    std::printf("%d x %d: %d rounds\n", counts.along, counts.across, report.friction_rounds);
    EXPECT_LT(report.friction_rounds, 15);
    found[fine] = components(StripContact::totals(solution), test.scene.mu);
  }
  expect_error("20 x 30 beside 24 x 36", largest_difference(found[0], found[1]), 1e-3);
}

TEST(strips, refuse_forces_beyond_friction) {
  for (const double share : {0.98, 1.02}) {
    StripCase test(FamilyGap::ellipse, 0);
    test.scene.force_given = {true, true, false};
    test.scene.motion = {-0.6 * share * 3e4, 0.8 * share * 3e4, 0};
    StripContact contact;
    StripSolution solution;
    EXPECT_EQ(contact.solve(test.now(), wide, {8, 12}, solution, false).status,
              share < 1 ? StripStatus::solved : StripStatus::beyond_friction);
  }
}

TEST(strips, of_bodies_that_do_not_touch) {
  StripCase test(FamilyGap::arcs, 0.3);
  test.scene.by_load = false;
  test.scene.value = -1;
  StripFinder finder;
  StripState state;
  EXPECT_EQ(finder.find(test.now(), wide, {8, 12}, state, false).status, StripStatus::no_contact);
}

}  // namespace
}  // namespace rollcon::strips
