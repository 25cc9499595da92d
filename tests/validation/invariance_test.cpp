// Tests what must not change the answer, and limits that have an answer of their own.

#include "validation/laws.hpp"

namespace rollcon::validation {
namespace {

constexpr double pi = 3.14159265358979323846;

/// Describes a soft sphere on steel, every coupling at work, by the numbers of one system of units.
struct Problem {
  Elastic body1{.shear = 23000, .poisson = 0.31};
  Elastic body2{.shear = 82000, .poisson = 0.28};
  double a = 2, p0 = 500, mu = 0.3, speed = 10;
  double xi = -8e-4, eta = 4e-4, spin = 2e-4;
  int rings = 6;

  Hertz hertz() const { return closed_forms::hertz_from_axes(a, a, p0, closed_forms::effective_modulus(body1, body2)); }

  Solution solve(const char* scheme = "least_squares", double* iterations = nullptr) const {
    RollingPair pair(body1, body2);
    const Hertz h = hertz();
    pair.frame(graded_disc(a, a, rings)).gap_quadratic(h.A, h.B).load(h.load).friction(mu);
    pair.speed(speed).creep(xi, eta, spin).option("convection", scheme);
    EXPECT_EQ(pair.solve(), ROLLCON_OK);
    if (iterations) *iterations = pair.stat("iterations");
    return pair.solution();
  }
};

/// Returns the largest difference of the tractions of two solutions, the second times a factor, over its p0.
double difference(const Solution& s, const Solution& t, double factor, double p0) {
  double largest = 0;
  for (std::size_t k = 0; k < s.nodes(); ++k)
    for (std::size_t i = 0; i < 3; ++i)
      largest = std::max(largest, std::abs(s.traction[k][i] - factor * t.traction[k][i]));
  return largest / p0;
}

TEST(Invariance, units) {
  const Problem mm;
  Problem m = mm;  // metre, newton, pascal
  m.body1.shear *= 1e6;
  m.body2.shear *= 1e6;
  m.p0 *= 1e6;
  m.a *= 1e-3;
  m.speed *= 1e-3;
  m.spin *= 1e3;
  expect_error("tractions in mm, N, MPa and in m, N, Pa", difference(mm.solve(), m.solve(), 1e-6, mm.p0), 1e-8);
}

TEST(Invariance, stiffness) {
  const Problem one;
  Problem stiff = one;
  stiff.body1.shear *= 1e12;
  stiff.body2.shear *= 1e12;
  stiff.p0 *= 1e12;
  expect_error("tractions of bodies 1e12 times stiffer under 1e12 times the load",
               difference(one.solve(), stiff.solve(), 1e-12, one.p0), 1e-8);
}

TEST(Invariance, speed) {
  const Problem slow;
  Problem fast = slow;
  fast.speed *= 1e4;
  const Solution s = slow.solve(), f = fast.solve();
  expect_error("tractions at 1e4 times the speed", difference(s, f, 1, slow.p0), 1e-8);
  double slip = 0;
  for (std::size_t k = 0; k < s.nodes(); ++k)
    slip = std::max(slip, std::abs(1e4 * s.slip[k][0] - f.slip[k][0]) / (fast.speed * 8e-4));
  expect_error("slip grows with the speed", slip, 1e-8);
}

TEST(Invariance, identical_bodies_answer_reversed_creepage_with_reversed_force) {
  Problem forward;
  forward.body1 = forward.body2;
  Problem backward = forward;
  backward.xi = -forward.xi;
  backward.eta = -forward.eta;
  backward.spin = -forward.spin;
  const Solution f = forward.solve(), b = backward.solve();
  double largest = 0;
  for (std::size_t k = 0; k < f.nodes(); ++k)
    for (std::size_t i = 0; i < 2; ++i) largest = std::max(largest, std::abs(f.traction[k][i] + b.traction[k][i]));
  expect_error("sum of tractions", largest / (forward.mu * forward.p0), 1e-8);
}

TEST(Limits, no_friction_no_tangential_traction) {
  Problem smooth;
  smooth.mu = 0;
  const Solution s = smooth.solve();
  for (std::size_t k = 0; k < s.nodes(); ++k) {
    ASSERT_EQ(s.traction[k][0], 0);
    ASSERT_EQ(s.traction[k][1], 0);
  }
  expect_error("load carried without friction", relative(-s.force[2], smooth.hertz().load), 1e-9);
}

TEST(Limits, friction_of_ten_sticks) {
  Problem rough;
  rough.mu = 10;
  double iterations = 0;
  const Solution s = rough.solve("least_squares", &iterations);
  report("Newton iterations at mu = 10", iterations);
  expect_laws("mu = 10", check_laws(s, rough.mu, rough.speed * 8e-4));
  const auto sticking = std::count(s.state.begin(), s.state.end(), ROLLCON_STICK);
  const auto slipping = std::count(s.state.begin(), s.state.end(), ROLLCON_SLIP);
  report("share of slipping nodes", static_cast<double>(slipping) / static_cast<double>(slipping + sticking));
  EXPECT_GT(sticking, 3 * slipping);
}

TEST(Limits, huge_creepage_slides_everywhere_along_the_rigid_slip) {
  for (const char* scheme : {"godunov", "least_squares", "characteristic"}) {
    Problem sliding;
    sliding.xi *= 1e4;
    sliding.eta *= 1e4;
    sliding.spin = 0;
    const Solution s = sliding.solve(scheme);
    const double creepage = std::hypot(sliding.xi, sliding.eta);
    const double full = sliding.mu * sliding.hertz().load / creepage;
    // The elastic slip, about p/G, is 1e-4 of the creepage here, and sine of the angle it adds.
    expect_error(std::string(scheme) + ": Fx at full slip", relative(s.force[0], -full * sliding.xi), 1e-3);
    expect_error(std::string(scheme) + ": Fy at full slip", relative(s.force[1], -full * sliding.eta), 1e-3);
    expect_laws(scheme, check_laws(s, sliding.mu, sliding.speed * creepage));
  }
}

TEST(Limits, pure_spin_slides_around_the_centre) {
  Problem spinning;
  spinning.body1 = spinning.body2;
  spinning.xi = spinning.eta = 0;
  spinning.spin = 10;
  // The moment of full slip around the centre is M = -mu integral of p r = -(3 pi/16) mu P a for Hertz's pressure.
  const Hertz h = spinning.hertz();
  const double exact = -3 * pi / 16 * spinning.mu * h.load * h.a;
  const double coarse = relative(spinning.solve().moment[2], exact);
  spinning.rings = 12;
  const double fine = relative(spinning.solve().moment[2], exact);
  report("moment of full spin, 6 rings", coarse);
  expect_error("moment of full spin, 12 rings", fine, 1e-2);
  // The direction turns, and is interpolated linearly.
  expect_order("moment of full spin", observed_order(coarse, fine, 2, 1), 1.5);
}

TEST(Limits, no_creepage_no_traction_between_identical_bodies) {
  Problem still;
  still.body1 = still.body2;
  still.xi = still.eta = still.spin = 0;
  const Solution s = still.solve();
  expect_error("tangential force without creepage",
               std::hypot(s.force[0], s.force[1]) / (still.mu * still.hertz().load), 1e-9);
}

TEST(Limits, no_creepage_between_dissimilar_bodies_obeys_the_laws) {
  Problem still;
  still.xi = still.eta = still.spin = 0;
  const Solution s = still.solve();
  // The pressure alone drags the soft body's surface along, by a slip of about p0/E* at zero creepage.
  const double scale = still.speed * still.p0 / closed_forms::effective_modulus(still.body1, still.body2);
  expect_laws("zero creepage", check_laws(s, still.mu, scale));
  EXPECT_GT(std::abs(s.force[0]), 0.01 * still.mu * still.hertz().load);
  expect_error("lateral force, zero by symmetry of the scene", s.force[1] / (still.mu * still.hertz().load), 5e-3);
}

TEST(Limits, nearly_incompressible_bodies) {
  Problem rubber;
  rubber.body1 = {.shear = 1, .poisson = 0.4999};
  rubber.body2 = {.shear = 1e6, .poisson = 0.3};
  rubber.p0 = 0.1;
  rubber.xi = -0.01;
  rubber.eta = 0.005;
  rubber.spin = 0.002;
  const Solution s = rubber.solve();
  expect_laws("nu = 0.4999", check_laws(s, rubber.mu, rubber.speed * 0.01));
}

}  // namespace
}  // namespace rollcon::validation
