/// Tests contacts without a caller's frame under given tangential loads, up to what friction can carry and none beyond
/// it, and creepages that vanish.

#include "rollcon.h"
#include "support/scene.hpp"
#include "support/steady_rolling.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using closed_forms::Elastic;
using scenes::RollingPair;
const Elastic steel = scenes::steady_rolling::steel, aluminium{.shear = 27000, .poisson = 0.34};
constexpr double mu = 0.3;

struct Ellipse {
  double a, b;
  closed_forms::Hertz hertz(const Elastic& other) const {
    return closed_forms::hertz_from_axes(a, b, 1000, closed_forms::effective_modulus(steel, other));
  }
  /// Returns the moment of friction all around over mu Fn: 3/8 of the larger semi-axis times E(m), for a circle 3 pi /
  /// 16.
  double arm() const {
    double sum = 0;
    constexpr int n = 20000;  // points of the integral of sqrt(a^2 cos^2 + b^2 sin^2)
    for (int i = 0; i < n; ++i) {
      const double angle = std::numbers::pi / 2 * (i + 0.5) / n;
      sum += std::hypot(a * std::cos(angle), b * std::sin(angle)) / n;
    }
    return 3.0 / 8 * std::numbers::pi / 2 * sum;
  }
};

RollingPair& hertzian(RollingPair& pair, const closed_forms::Hertz& hertz) {
  return pair.gap_quadratic(hertz.A, hertz.B).load(hertz.load).friction(mu);
}

TEST(automatic_loads, spin_moments_up_to_all_that_friction_can_carry) {
  expect_error("arm of a circle", Ellipse{1, 1}.arm() - 3 * std::numbers::pi / 16, 1e-9);
  for (const Ellipse& e : {Ellipse{1, 1}, {1, 3}, {5, 1}}) {
    const auto hertz = e.hertz(steel);
    const double limit = mu * hertz.load * e.arm();
    RollingPair pair(steel, steel);
    hertzian(pair, hertz).option("frame_accuracy", 0.05);
    double last = 0;
    for (const double share : {0.5, 0.9, 0.97, 0.98, 0.99, 0.995, 0.999}) {
      pair.tangential_force(ROLLCON_SPIN, -share * limit);
      const std::string name = "a/b = " + std::to_string(e.a / e.b) + ", moment " + std::to_string(share);
      EXPECT_EQ(pair.solve(), ROLLCON_OK) << name;
      expect_error(name, pair.solution().moment[2] / limit + share, 1e-12);
      EXPECT_GT(pair.solution().creep[2], 1.05 * last) << name;
      last = pair.solution().creep[2];
    }
    for (const double share : {1.001, 1.02, 1.5}) {
      pair.tangential_force(ROLLCON_SPIN, -share * limit);
      EXPECT_EQ(rollcon_contact_solve(pair.handle()), ROLLCON_ERR_LOAD) << share;
      EXPECT_NE(std::string(rollcon_last_error()).find("spin moment"), std::string::npos) << rollcon_last_error();
    }
  }
}

TEST(automatic_loads, a_solution_that_is_gone_takes_its_extrapolation_along) {
  const auto hertz = Ellipse{1, 1.5}.hertz(steel);
  RollingPair pair(steel, steel);
  hertzian(pair, hertz).option("frame_accuracy", 0.05).creep(1e-3, 0, 0);
  double force[3], t_gamma = 0;
  std::int64_t rows = -1;
  const auto gone = [&] {
    EXPECT_EQ(rollcon_contact_get_resultant(pair.handle(), ROLLCON_LOCAL, force, nullptr), ROLLCON_ERR_STATE);
    EXPECT_EQ(rollcon_contact_get_stat(pair.handle(), "t_gamma", &t_gamma), ROLLCON_ERR_STATE);
    EXPECT_EQ(rollcon_contact_get_sensitivity(pair.handle(), ROLLCON_NORMAL, force, nullptr, nullptr, nullptr),
              ROLLCON_ERR_STATE);
    EXPECT_EQ(rollcon_contact_get_history(pair.handle(), "step", 0, nullptr, &rows), ROLLCON_OK);
    EXPECT_EQ(rows, 0);
  };
  ASSERT_EQ(pair.solve(), ROLLCON_OK);
  pair.creep(2e-3, 0, 0);
  const double value = 1e-3;
  ASSERT_EQ(rollcon_contact_solve_many(pair.handle(), "longitudinal", 1, &value, "force", 3, force, nullptr, nullptr),
            ROLLCON_OK);
  gone();
  // The load is beyond friction.
  pair.load(hertz.load);
  ASSERT_EQ(pair.solve(), ROLLCON_OK);
  pair.tangential_force(ROLLCON_LONGITUDINAL, -2 * mu * hertz.load);
  ASSERT_EQ(rollcon_contact_solve(pair.handle()), ROLLCON_ERR_LOAD);
  gone();
}

TEST(automatic_loads_long, spin_moments_lead_to_spins_that_lead_back) {
  const Ellipse e{1, 1.5};
  const auto hertz = e.hertz(steel);
  const double limit = mu * hertz.load * e.arm();
  for (const double share : {0.3, 0.6, 0.8}) {
    RollingPair pair(steel, steel);
    // The moment hardly grows with the spin near the limit of friction. Given moments are solved on pairs of frames,
    // which are off by up to 0.4 %, spins on strips.
    hertzian(pair, hertz).tangential_force(ROLLCON_SPIN, -share * limit).option("frame_accuracy", 0.002);
    ASSERT_EQ(pair.solve(), ROLLCON_OK);
    const auto given = pair.solution();
    pair.creep(0, 0, given.creep[2]);
    // The pole of sliding lies inside, where strips do not reach 0.2 % and say so.
    const std::int32_t status = pair.solve();
    ASSERT_TRUE(status == ROLLCON_OK || status == ROLLCON_INACCURATE) << status;
    const auto back = pair.solution();
    expect_error("moment under the spin found", back.moment[2] / limit + share, 4e-3);
    expect_error("lateral force", (back.force[1] - given.force[1]) / (mu * hertz.load), 2e-3);
  }
}

TEST(automatic_loads, forces_under_a_given_approach) {
  const auto hertz = Ellipse{2, 1}.hertz(steel);
  for (const double share : {0.99, 0.999}) {
    RollingPair pair(steel, steel);
    hertzian(pair, hertz).approach(hertz.approach);
    pair.tangential_force(ROLLCON_LONGITUDINAL, share * mu * hertz.load);
    EXPECT_EQ(pair.solve(), ROLLCON_OK) << share;
    expect_error("force", pair.solution().force[0] / (mu * hertz.load) - share, 1e-12);
    pair.tangential_force(ROLLCON_LONGITUDINAL, 1.001 * mu * hertz.load);
    EXPECT_EQ(rollcon_contact_solve(pair.handle()), ROLLCON_ERR_LOAD);
  }
}

// The loads together lie on the line between both limits.
TEST(automatic_loads, forces_and_moments) {
  const Ellipse e{1, 2};
  for (const Elastic& other : {steel, aluminium}) {
    const auto hertz = e.hertz(other);
    const double bound = mu * hertz.load;
    for (const double part : {0.2, 0.5, 0.8}) {
      RollingPair pair(steel, other);
      hertzian(pair, hertz).tangential_force(ROLLCON_SPIN, 0.99 * (1 - part) * bound * e.arm());
      pair.tangential_force(ROLLCON_LONGITUDINAL, 0.99 * part * bound);
      pair.tangential_force(ROLLCON_LATERAL, 0.1 * part * bound);
      EXPECT_EQ(pair.solve(), ROLLCON_OK) << part;
      expect_error(
          "force",
          std::hypot(pair.solution().force[0] / bound - 0.99 * part, pair.solution().force[1] / bound - 0.1 * part),
          1e-12);
    }
  }
}

// The creepages vanish by symmetry; their error is measured by forces, not by themselves.
TEST(automatic_loads, creepages_that_vanish) {
  const auto hertz = Ellipse{1, 2}.hertz(steel);
  RollingPair pair(steel, steel);
  hertzian(pair, hertz);
  for (const int d : {ROLLCON_LONGITUDINAL, ROLLCON_LATERAL, ROLLCON_SPIN}) pair.tangential_force(d, 0);
  EXPECT_EQ(pair.solve(), ROLLCON_OK);
  const double unit = mu * hertz.load / (steel.shear * hertz.a * hertz.b);
  for (const double creep : pair.solution().creep) expect_error("free rolling: creepage", creep / unit, 1e-9);
  EXPECT_LE(pair.stat("error_estimate"), 0.005);
  for (const double longitudinal : {1e-3 * unit, 0.3 * unit, 30 * unit}) {
    ASSERT_EQ(rollcon_contact_prescribe(pair.handle(), ROLLCON_LONGITUDINAL, ROLLCON_BY_MOTION, longitudinal),
              ROLLCON_OK);
    EXPECT_EQ(pair.solve(), ROLLCON_OK);
    expect_error("lateral creepage", pair.solution().creep[1] / unit, 1e-7);
    expect_error("spin", pair.solution().creep[2] / unit, 1e-7);
  }
}

// A little more force takes far more creepage, near what friction can carry.
TEST(automatic_loads, creepages_of_nearly_full_sliding_are_judged_by_their_force) {
  for (const Elastic& other : {steel, aluminium}) {
    const auto hertz = Ellipse{3, 1}.hertz(other);
    for (const double share : {0.98, 0.999}) {
      RollingPair pair(steel, other);
      hertzian(pair, hertz).tangential_force(ROLLCON_LONGITUDINAL, share * mu * hertz.load);
      EXPECT_EQ(pair.solve(), ROLLCON_OK) << share;
      const auto given = pair.solution();
      pair.creep(given.creep[0], given.creep[1], given.creep[2]);
      EXPECT_EQ(pair.solve(), ROLLCON_OK) << share;
      expect_error("force under the creepage found", pair.solution().force[0] / (mu * hertz.load) - share, 5e-3);
    }
  }
}

}  // namespace
}  // namespace rollcon
