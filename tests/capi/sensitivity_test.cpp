/// Derivatives through the public interface: what is differentiated by what, and when they exist.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "fixture.hpp"

using namespace capi_test;

/// Force, moment, approach, creepages and spin.
using Values = std::array<double, 10>;

class sensitivity : public Api {
 protected:
  void SetUp() override {
    Api::SetUp();
    set_scene();
    ASSERT_EQ(rollcon_contact_set_real(contact, "tolerance", 1e-13), ROLLCON_OK);
    ASSERT_EQ(rollcon_contact_set_creep(contact, 4e-4, -2e-4, 3e-4), ROLLCON_OK);
  }

  std::int32_t get(std::int32_t parameter, Values& v) {
    return rollcon_contact_get_sensitivity(contact, parameter, &v[0], &v[3], &v[6], &v[7]);
  }

  Values results() {
    Values v{};
    EXPECT_EQ(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, &v[0], &v[3]), ROLLCON_OK);
    EXPECT_EQ(rollcon_contact_get_motion(contact, &v[6], &v[7]), ROLLCON_OK);
    return v;
  }

  std::vector<std::int32_t> states() {
    std::vector<std::int32_t> s(static_cast<std::size_t>(frame.nodes));
    EXPECT_EQ(rollcon_contact_get_status(contact, frame.nodes, s.data()), ROLLCON_OK);
    return s;
  }

  /// Results with the parameter's value v; no node changes its state.
  Values solved_with(std::int32_t parameter, std::int32_t how, double v) {
    const std::vector<std::int32_t> before = states();
    if (parameter == ROLLCON_FRICTION)
      EXPECT_EQ(rollcon_contact_set_friction(contact, "coulomb", 1, &v), ROLLCON_OK);
    else
      EXPECT_EQ(rollcon_contact_prescribe(contact, parameter, how, v), ROLLCON_OK);
    EXPECT_EQ(rollcon_contact_solve(contact), ROLLCON_OK);
    EXPECT_EQ(states(), before);
    return results();
  }

  /// The derivatives asked for, against central differences with the value v and the step h.
  void expect_slope(std::int32_t parameter, std::int32_t how, double v, double h, double factor) {
    Values found{};
    ASSERT_EQ(rollcon_contact_solve(contact), ROLLCON_OK);
    ASSERT_EQ(get(parameter, found), ROLLCON_OK);
    const Values low = solved_with(parameter, how, v - h),
                 high = solved_with(parameter, how, v + h);
    const Values result = solved_with(parameter, how, v);
    double error = 0;
    for (std::size_t i = 0; i < 10; ++i) {
      // Each in units of its own size; the frame is about 1 wide, so moments in those of forces.
      const double size = i < 6 ? std::hypot(result[0], result[1]) : std::abs(result[i]);
      const double slope = factor * (high[i] - low[i]) / (2 * h);
      error = std::max(error, std::abs(found[i] - slope) / size * std::abs(v / factor));
    }
    std::printf("parameter %d, how %d: error %.1e (bound 1e-6)\n", parameter, how, error);
    EXPECT_LT(error, 1e-6);
  }
};

TEST_F(sensitivity, is_the_slope_of_solves) {
  expect_slope(ROLLCON_NORMAL, ROLLCON_BY_MOTION, 0.02, 2e-6, 1);
  expect_slope(ROLLCON_LONGITUDINAL, ROLLCON_BY_MOTION, 4e-4, 4e-8, 1);
  expect_slope(ROLLCON_SPIN, ROLLCON_BY_MOTION, 3e-4, 3e-8, 1);
  // By a factor on it: 0.1 times the slope by the coefficient.
  expect_slope(ROLLCON_FRICTION, 0, 0.1, 1e-5, 0.1);
  const Values v = results();
  ASSERT_EQ(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, -v[2]),
            ROLLCON_OK);
  ASSERT_EQ(rollcon_contact_prescribe(contact, ROLLCON_LATERAL, ROLLCON_BY_FORCE, v[1]),
            ROLLCON_OK);
  expect_slope(ROLLCON_NORMAL, ROLLCON_BY_FORCE, -v[2], -1e-4 * v[2], 1);
  expect_slope(ROLLCON_LATERAL, ROLLCON_BY_FORCE, v[1], 1e-4 * v[1], 1);
}

TEST_F(sensitivity, needs_a_converged_solution) {
  Values v{};
  EXPECT_FAILS(
      rollcon_contact_get_sensitivity(contact, ROLLCON_NORMAL, v.data(), nullptr, nullptr, nullptr),
      ROLLCON_ERR_STATE, "rollcon_contact_solve");
  ASSERT_EQ(rollcon_contact_set_int(contact, "max_iterations", 1), ROLLCON_OK);
  ASSERT_EQ(rollcon_contact_solve(contact), ROLLCON_NOT_CONVERGED);
  EXPECT_FAILS(
      rollcon_contact_get_sensitivity(contact, ROLLCON_NORMAL, v.data(), nullptr, nullptr, nullptr),
      ROLLCON_ERR_STATE, "did not converge");
  ASSERT_EQ(rollcon_contact_set_int(contact, "max_iterations", 500), ROLLCON_OK);
  ASSERT_EQ(rollcon_contact_solve(contact), ROLLCON_OK);
  EXPECT_EQ(get(ROLLCON_NORMAL, v), ROLLCON_OK);
  EXPECT_LT(v[2], 0) << "the force on body 1 along its outward normal is compressive";
  EXPECT_EQ(v[6], 1) << "the approach is what is prescribed";
  ASSERT_EQ(rollcon_contact_reset(contact), ROLLCON_OK);
  EXPECT_EQ(get(ROLLCON_NORMAL, v), ROLLCON_ERR_STATE);
}

TEST_F(sensitivity, arguments) {
  ASSERT_EQ(rollcon_contact_solve(contact), ROLLCON_OK);
  double v[3];
  for (const std::int32_t p : {0, 6, -1})
    EXPECT_FAILS(rollcon_contact_get_sensitivity(contact, p, v, nullptr, nullptr, nullptr),
                 ROLLCON_ERR_ARGUMENT, "parameter is " + std::to_string(p), "allowed: 1 to 5");
  double approach = 7, creep[3] = {7, 7, 7};
  ASSERT_EQ(
      rollcon_contact_get_sensitivity(contact, ROLLCON_LATERAL, nullptr, nullptr, &approach, creep),
      ROLLCON_OK);
  EXPECT_EQ(approach, 0);
  EXPECT_EQ((std::array{creep[0], creep[1], creep[2]}), (std::array{0.0, 1.0, 0.0}));
}

TEST_F(sensitivity, belongs_to_what_was_last_solved) {
  Values before{}, after{};
  ASSERT_EQ(rollcon_contact_solve(contact), ROLLCON_OK);
  ASSERT_EQ(get(ROLLCON_LONGITUDINAL, before), ROLLCON_OK);
  ASSERT_EQ(rollcon_contact_prescribe(contact, ROLLCON_LONGITUDINAL, ROLLCON_BY_FORCE, 1),
            ROLLCON_OK);
  ASSERT_EQ(rollcon_contact_set_real(contact, "tolerance", 1e-6), ROLLCON_OK);
  ASSERT_EQ(get(ROLLCON_LONGITUDINAL, after), ROLLCON_OK);
  EXPECT_EQ(before, after);
  ASSERT_EQ(get(ROLLCON_SPIN, after), ROLLCON_OK) << "those not asked for before, too";
  EXPECT_EQ(after[7], 0) << "the creepage was prescribed";
  EXPECT_NE(after[0], 0);
}

TEST_F(sensitivity, without_contact_only_the_motion_itself_changes) {
  ASSERT_EQ(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, -0.01),
            ROLLCON_OK);
  ASSERT_EQ(rollcon_contact_solve(contact), ROLLCON_NO_CONTACT);
  for (std::int32_t p = ROLLCON_LONGITUDINAL; p <= ROLLCON_FRICTION; ++p) {
    Values v{}, wanted{};
    ASSERT_EQ(get(p, v), ROLLCON_OK);
    constexpr std::size_t own[] = {7, 8, 6, 9};
    if (p != ROLLCON_FRICTION) wanted[own[p - 1]] = 1;
    EXPECT_EQ(v, wanted) << p;
  }
  ASSERT_EQ(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, 0), ROLLCON_OK);
  ASSERT_EQ(rollcon_contact_solve(contact), ROLLCON_NO_CONTACT);
  Values v{};
  v.fill(7);
  ASSERT_EQ(get(ROLLCON_NORMAL, v), ROLLCON_OK);
  EXPECT_EQ(v, Values{});
}

TEST_F(sensitivity, a_force_without_friction_has_none) {
  const double none = 0;
  ASSERT_EQ(rollcon_contact_set_friction(contact, "coulomb", 1, &none), ROLLCON_OK);
  ASSERT_EQ(rollcon_contact_prescribe(contact, ROLLCON_LATERAL, ROLLCON_BY_FORCE, 0), ROLLCON_OK);
  ASSERT_EQ(rollcon_contact_solve(contact), ROLLCON_OK);
  double v[3];
  EXPECT_FAILS(
      rollcon_contact_get_sensitivity(contact, ROLLCON_LATERAL, v, nullptr, nullptr, nullptr),
      ROLLCON_ERR_STATE, "direction 2", "friction coefficient is 0");
  EXPECT_EQ(rollcon_contact_get_sensitivity(contact, ROLLCON_NORMAL, v, nullptr, nullptr, nullptr),
            ROLLCON_OK);
  EXPECT_LT(v[2], 0);
}

TEST_F(sensitivity, a_load_that_cannot_change_has_none) {
  // Friction at nodes out of contact only.
  std::vector<double> mu(static_cast<std::size_t>(frame.nodes), 0.0);
  mu.back() = 0.3;
  ASSERT_EQ(rollcon_contact_set_friction_field(contact, frame.nodes, mu.data()), ROLLCON_OK);
  ASSERT_EQ(rollcon_contact_prescribe(contact, ROLLCON_LATERAL, ROLLCON_BY_FORCE, 0), ROLLCON_OK);
  ASSERT_EQ(rollcon_contact_solve(contact), ROLLCON_OK);
  double v[3];
  EXPECT_FAILS(
      rollcon_contact_get_sensitivity(contact, ROLLCON_LATERAL, v, nullptr, nullptr, nullptr),
      ROLLCON_ERR_SINGULAR, "singular");
  ASSERT_EQ(rollcon_contact_prescribe(contact, ROLLCON_LATERAL, ROLLCON_BY_MOTION, 0), ROLLCON_OK);
  ASSERT_EQ(rollcon_contact_solve(contact), ROLLCON_OK);
  EXPECT_EQ(rollcon_contact_get_sensitivity(contact, ROLLCON_LATERAL, v, nullptr, nullptr, nullptr),
            ROLLCON_OK);
  EXPECT_EQ(v[1], 0);
}
