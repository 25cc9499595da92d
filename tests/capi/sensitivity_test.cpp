/// Tests when derivatives exist through the public interface. tests/contact/sensitivity_test shows that they are slopes
/// of solves.

#include "fixture.hpp"

using namespace capi_test;

/// Holds force, moment, approach, creepages and spin.
using Values = std::array<double, 10>;

class sensitivity : public Api {
 protected:
  void SetUp() override {
    Api::SetUp();
    set_scene();
    ASSERT_OK(rollcon_contact_set_real(contact, "tolerance", 1e-13));
    ASSERT_OK(rollcon_contact_set_creep(contact, 4e-4, -2e-4, 3e-4));
  }

  std::int32_t get(std::int32_t parameter, Values& v) {
    return rollcon_contact_get_sensitivity(contact, parameter, &v[0], &v[3], &v[6], &v[7]);
  }
};

TEST_F(sensitivity, needs_a_converged_solution) {
  Values v{};
  EXPECT_FAILS(rollcon_contact_get_sensitivity(contact, ROLLCON_NORMAL, v.data(), nullptr, nullptr, nullptr), STATE,
               "rollcon_contact_solve");
  ASSERT_OK(rollcon_contact_set_int(contact, "max_iterations", 1));
  ASSERT_EQ(rollcon_contact_solve(contact), ROLLCON_NOT_CONVERGED);
  EXPECT_FAILS(rollcon_contact_get_sensitivity(contact, ROLLCON_NORMAL, v.data(), nullptr, nullptr, nullptr), STATE,
               "did not converge");
  ASSERT_OK(rollcon_contact_set_int(contact, "max_iterations", 500));
  ASSERT_OK(rollcon_contact_solve(contact));
  EXPECT_OK(get(ROLLCON_NORMAL, v));
  EXPECT_LT(v[2], 0) << "the force on body 1 along its outward normal is compressive";
  EXPECT_EQ(v[6], 1) << "the approach is what is prescribed";
  ASSERT_OK(rollcon_contact_reset(contact));
  EXPECT_EQ(get(ROLLCON_NORMAL, v), ROLLCON_ERR_STATE);
}

TEST_F(sensitivity, arguments) {
  ASSERT_OK(rollcon_contact_solve(contact));
  double v[3];
  for (const std::int32_t p : {0, 8, -1})
    EXPECT_FAILS(rollcon_contact_get_sensitivity(contact, p, v, nullptr, nullptr, nullptr), ARGUMENT,
                 "parameter is " + std::to_string(p), "allowed: 1 to 7");
  double approach = 7, creep[3] = {7, 7, 7};
  ASSERT_OK(rollcon_contact_get_sensitivity(contact, ROLLCON_LATERAL, nullptr, nullptr, &approach, creep));
  EXPECT_EQ(approach, 0);
  EXPECT_EQ((std::array{creep[0], creep[1], creep[2]}), (std::array{0.0, 1.0, 0.0}));
}

TEST_F(sensitivity, belongs_to_what_was_last_solved) {
  Values before{}, after{};
  ASSERT_OK(rollcon_contact_solve(contact));
  ASSERT_OK(get(ROLLCON_LONGITUDINAL, before));
  ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_LONGITUDINAL, ROLLCON_BY_FORCE, 1));
  ASSERT_OK(rollcon_contact_set_real(contact, "tolerance", 1e-6));
  ASSERT_OK(get(ROLLCON_LONGITUDINAL, after));
  EXPECT_EQ(before, after);
  ASSERT_OK(get(ROLLCON_SPIN, after)) << "those not asked for before, too";
  EXPECT_EQ(after[7], 0) << "the creepage was prescribed";
  EXPECT_NE(after[0], 0);
}

TEST_F(sensitivity, without_contact_only_the_motion_itself_changes) {
  ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, -0.01));
  ASSERT_EQ(rollcon_contact_solve(contact), ROLLCON_NO_CONTACT);
  for (std::int32_t p = ROLLCON_LONGITUDINAL; p <= ROLLCON_FRICTION; ++p) {
    Values v{}, wanted{};
    ASSERT_OK(get(p, v));
    constexpr std::size_t own[] = {7, 8, 6, 9};
    if (p != ROLLCON_FRICTION) wanted[own[p - 1]] = 1;
    EXPECT_EQ(v, wanted) << p;
  }
  ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, 0));
  ASSERT_EQ(rollcon_contact_solve(contact), ROLLCON_NO_CONTACT);
  Values v{};
  v.fill(7);
  ASSERT_OK(get(ROLLCON_NORMAL, v));
  EXPECT_EQ(v, Values{});
}

TEST_F(sensitivity, a_force_without_friction_has_none) {
  const double none = 0;
  ASSERT_OK(rollcon_contact_set_friction(contact, "coulomb", 1, &none));
  ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_LATERAL, ROLLCON_BY_FORCE, 0));
  ASSERT_OK(rollcon_contact_solve(contact));
  double v[3];
  EXPECT_FAILS(rollcon_contact_get_sensitivity(contact, ROLLCON_LATERAL, v, nullptr, nullptr, nullptr), STATE,
               "direction 2", "friction coefficient is 0");
  EXPECT_OK(rollcon_contact_get_sensitivity(contact, ROLLCON_NORMAL, v, nullptr, nullptr, nullptr));
  EXPECT_LT(v[2], 0);
}

TEST_F(sensitivity, a_load_that_cannot_change_has_none) {
  // Only nodes out of contact have friction.
  std::vector<double> mu(static_cast<std::size_t>(frame.nodes), 0.0);
  mu.back() = 0.3;
  ASSERT_OK(rollcon_contact_set_friction_field(contact, frame.nodes, mu.data()));
  ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_LATERAL, ROLLCON_BY_FORCE, 0));
  ASSERT_OK(rollcon_contact_solve(contact));
  double v[3];
  EXPECT_FAILS(rollcon_contact_get_sensitivity(contact, ROLLCON_LATERAL, v, nullptr, nullptr, nullptr), SINGULAR,
               "singular");
  ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_LATERAL, ROLLCON_BY_MOTION, 0));
  ASSERT_OK(rollcon_contact_solve(contact));
  EXPECT_OK(rollcon_contact_get_sensitivity(contact, ROLLCON_LATERAL, v, nullptr, nullptr, nullptr));
  EXPECT_EQ(v[1], 0);
}
