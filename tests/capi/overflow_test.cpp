/// Tests gaps and creepages at the end of the range of double precision: they are refused by a text that names the
/// node, or calculated with.

#include <cfloat>

#include "fixture.hpp"

using namespace capi_test;

namespace {

class overflow : public Api {
 protected:
  void SetUp() override {
    Api::SetUp();
    set_scene();
  }

  std::vector<double> force() {
    std::vector<double> f(3);
    EXPECT_OK(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, f.data(), nullptr));
    return f;
  }

  int not_finite(std::int32_t field) {
    std::int64_t n = 0;
    rollcon_contact_get_field(contact, field, ROLLCON_LOCAL, 0, nullptr, &n);
    std::vector<double> v(static_cast<std::size_t>(n));
    EXPECT_OK(rollcon_contact_get_field(contact, field, ROLLCON_LOCAL, n, v.data(), nullptr));
    int bad = 0;
    for (const double value : v) bad += !std::isfinite(value);
    return bad;
  }
};

}  // namespace

TEST_F(overflow, creepages_are_refused_and_the_scene_stays_usable) {
  ASSERT_OK(rollcon_contact_solve(contact));
  const double mu = 0.2;
  ASSERT_OK(rollcon_contact_set_friction(contact, "coulomb", 1, &mu));
  ASSERT_OK(rollcon_contact_solve(contact));
  const std::vector<double> before = force();
  for (const double huge : {1e304, DBL_MAX, -DBL_MAX}) {
    for (int which = 0; which < 3; ++which) {
      ASSERT_OK(
          rollcon_contact_set_creep(contact, which == 0 ? huge : 0, which == 1 ? huge : 0, which == 2 ? huge : 0));
      EXPECT_FAILS(rollcon_contact_solve(contact), ARGUMENT, "node 0 ", "creepages", "allowed: up to");
      EXPECT_FAILS(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, nullptr, nullptr), STATE, "solve");
    }
  }
  ASSERT_OK(rollcon_contact_set_creep(contact, 1e-3, 0, 0));
  ASSERT_OK(rollcon_contact_solve(contact));
  double read = 0;
  ASSERT_OK(rollcon_contact_get_stat(contact, "friction_builds", &read));
  EXPECT_EQ(read, 2) << "what was made for the frame and its counters were thrown away";
  const std::vector<double> after = force();
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(after[i], before[i], 1e-8 * std::abs(before[2]));
}

TEST_F(overflow, every_creepage_below_slides) {
  double worst = 0;
  for (const double creep : {1e3, 1e30, 1e100, 1e154, 1e200, 1e280, 1e295}) {
    ASSERT_OK(rollcon_contact_set_creep(contact, creep, 0, 0));
    ASSERT_OK(rollcon_contact_solve(contact)) << creep;
    const std::vector<double> f = force();
    worst = std::max(worst, std::abs(f[0] / f[2] - 0.1));  // both on body 1: against creep, pressure
    for (const std::int32_t field :
         {ROLLCON_FIELD_SLIP, ROLLCON_FIELD_RIGID_SLIP, ROLLCON_FIELD_GAP, ROLLCON_FIELD_TRACTION})
      EXPECT_EQ(not_finite(field), 0) << "field " << field << " at creepage " << creep;
  }
  std::printf("ratio of forces off the coefficient of friction by %.1e (bound 1e-9)\n", worst);
  EXPECT_LT(worst, 1e-9);
}

TEST_F(overflow, creep_fields_and_speeds) {
  std::vector<double> field(static_cast<std::size_t>(2 * frame.nodes), 0.0);
  field[2 * 17 + 1] = DBL_MAX;
  ASSERT_OK(rollcon_contact_set_creep_field(contact, frame.nodes, field.data()));
  EXPECT_FAILS(rollcon_contact_solve(contact), ARGUMENT, "allowed: up to");
  ASSERT_OK(rollcon_contact_set_creep_field(contact, 0, nullptr));
  EXPECT_OK(rollcon_contact_solve(contact));
  ASSERT_OK(rollcon_contact_set_creep(contact, 10, 0, 0));
  ASSERT_OK(rollcon_contact_set_rolling(contact, 1e300));
  EXPECT_OK(rollcon_contact_solve(contact));
  ASSERT_OK(rollcon_contact_set_rolling(contact, DBL_MAX));
  EXPECT_FAILS(rollcon_contact_solve(contact), ARGUMENT, "slip by 10 of the speed");
}

TEST_F(overflow, gaps_and_approaches) {
  ASSERT_OK(rollcon_contact_set_gap_quadratic(contact, DBL_MAX, DBL_MAX, 0));
  EXPECT_FAILS(rollcon_contact_solve(contact), ARGUMENT, "gap of node 0 ", "is inf");
  ASSERT_OK(rollcon_contact_set_gap_quadratic(contact, 0.01, 0.01, 0));
  for (const double approach : {1e148, 1e155, 1e200, 1e290, 1e302, DBL_MAX}) {
    ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, approach));
    EXPECT_FAILS(rollcon_contact_solve(contact), ARGUMENT, "approach", "allowed: -");
  }
  ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, -DBL_MAX));
  EXPECT_EQ(rollcon_contact_solve(contact), ROLLCON_NO_CONTACT);
  ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, 0.02));
  ASSERT_OK(rollcon_contact_solve(contact));
  const std::vector<double> before = force();

  // Some nodes are never to touch: no approach closes their gap.
  std::vector<double> gap;
  for (std::size_t i = 0; i < frame.x.size(); i += 3) {
    const double x = frame.x[i], y = frame.x[i + 1], near = 0.01 * (x * x + y * y);
    gap.push_back(near < 0.024 ? near : DBL_MAX);
  }
  ASSERT_OK(rollcon_contact_set_gap(contact, frame.nodes, gap.data()));
  ASSERT_OK(rollcon_contact_solve(contact));
  const double load = -force()[2], change = std::abs(load / -before[2] - 1);
  std::printf("load with huge gaps away from the contact differs by %.1e (bound 1e-8)\n", change);
  EXPECT_LT(change, 1e-8);
  double normal = 0, estimate = 0;
  ASSERT_OK(rollcon_contact_get_stat(contact, "error_estimate_normal", &normal));
  ASSERT_OK(rollcon_contact_get_stat(contact, "error_estimate", &estimate));
  EXPECT_TRUE(std::isnan(normal) ? std::isnan(estimate) : estimate >= normal)
      << estimate << " is not the worst of its parts, of which one is " << normal;

  // The scene is solved by force, too, from nothing: the guess of an approach starts from the gaps.
  double depth = 0, iterations[2] = {};
  ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, load));
  for (const double far : {1.0, 1e10, 1e100, 1e150, 1e200, DBL_MAX}) {
    for (double& g : gap)
      if (!(g < 0.024)) g = far;
    ASSERT_OK(rollcon_contact_set_gap(contact, frame.nodes, gap.data()));
    ASSERT_OK(rollcon_contact_reset(contact));
    ASSERT_OK(rollcon_contact_solve(contact)) << far;
    ASSERT_OK(rollcon_contact_get_motion(contact, &depth, nullptr));
    EXPECT_NEAR(depth, 0.02, 1e-8 * 0.02) << far;
    ASSERT_OK(rollcon_contact_get_stat(contact, "iterations", &iterations[far > 1]));
    EXPECT_LE(iterations[1], iterations[0] + 3) << far;
  }
}

TEST_F(overflow, the_monolithic_system_counts_far_gaps) {
  if (!rollcon_has_feature("procedures")) GTEST_SKIP() << "this build has no procedures";
  ASSERT_OK(rollcon_contact_set_str(contact, "convection", "godunov"));
  ASSERT_OK(rollcon_contact_set_procedure(contact, "system=monolithic jacobian=b_derivative"));
  std::vector<double> gap;
  for (std::size_t i = 0; i < frame.x.size(); i += 3)
    gap.push_back(0.01 * (frame.x[i] * frame.x[i] + frame.x[i + 1] * frame.x[i + 1]));
  for (const double far : {1.0, 1e100}) {
    gap[0] = far;
    ASSERT_OK(rollcon_contact_set_gap(contact, frame.nodes, gap.data()));
    EXPECT_OK(rollcon_contact_solve(contact)) << far;
  }
  gap[0] = DBL_MAX;
  ASSERT_OK(rollcon_contact_set_gap(contact, frame.nodes, gap.data()));
  EXPECT_FAILS(rollcon_contact_solve(contact), ARGUMENT, "gap of node 0 ", "allowed");
}

TEST_F(overflow, every_approach_below_presses) {
  double unit = 0, worst = 0;
  for (const double approach : {1e3, 1e10, 1e50, 1e100, 1e140}) {
    ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, approach));
    ASSERT_EQ(rollcon_contact_solve(contact), ROLLCON_RIM_CONTACT) << approach;
    const double stiffness = -force()[2] / approach;
    if (unit == 0) unit = stiffness;
    worst = std::max(worst, std::abs(stiffness / unit - 1));
  }
  std::printf("force over approach changes by %.1e (bound 1e-4)\n",
              worst);  // rounding of the gaps at 1e3
  EXPECT_LT(worst, 1e-4);
}

TEST_F(overflow, nodes_of_no_element_are_not_asked) {
  SquareFrame more = frame;
  more.x.insert(more.x.end(), {9, 9, 0});
  ++more.nodes;
  ASSERT_OK(set_nodes(more));
  ASSERT_OK(add_elements(more));
  std::vector<double> gap, slip(static_cast<std::size_t>(2 * more.nodes), 0.0);
  for (std::size_t i = 0; i < more.x.size(); i += 3)
    gap.push_back(0.01 * (more.x[i] * more.x[i] + more.x[i + 1] * more.x[i + 1]));
  gap.back() = -DBL_MAX;
  slip.back() = DBL_MAX;
  ASSERT_OK(rollcon_contact_set_gap(contact, more.nodes, gap.data()));
  ASSERT_OK(rollcon_contact_set_creep_field(contact, more.nodes, slip.data()));
  EXPECT_OK(rollcon_contact_solve(contact));
}

TEST_F(overflow, only_what_is_left_of_gap_and_approach_counts) {
  // The scene lies a long way off: 2^1000 in gaps and approach, to which their differences are lost.
  const double far = std::ldexp(1.0, 1000);
  const std::vector<double> gap(static_cast<std::size_t>(frame.nodes), far);
  ASSERT_OK(rollcon_contact_set_gap(contact, frame.nodes, gap.data()));
  ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, far));
  EXPECT_EQ(rollcon_contact_solve(contact), ROLLCON_NO_CONTACT);
  ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, 2 * far));
  EXPECT_FAILS(rollcon_contact_solve(contact), ARGUMENT, "approach");
  ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, 100));
  const std::int32_t flat = rollcon_contact_solve(contact);
  EXPECT_TRUE(flat == ROLLCON_OK || flat == ROLLCON_RIM_CONTACT) << flat;
  EXPECT_NEAR(force()[2], -100, 1e-6);
}

TEST_F(overflow, load_cases_fail_alone) {
  const double value[3] = {1e-3, DBL_MAX, 2e-3};
  std::int32_t status[3] = {-1000, -1000, -1000};
  std::vector<double> f(9);
  EXPECT_EQ(rollcon_contact_solve_many(contact, "longitudinal", 3, value, "force", 3, f.data(), nullptr, status),
            ROLLCON_NOT_CONVERGED);
  EXPECT_OK(status[0]);
  EXPECT_EQ(status[1], ROLLCON_ERR_ARGUMENT);
  EXPECT_OK(status[2]);
  EXPECT_TRUE(std::isnan(f[3])) << f[3];
  EXPECT_GT(std::abs(f[6]), std::abs(f[0]));
}

TEST_F(overflow, results_beyond_the_range_are_neither_given_nor_written) {
  if (!rollcon_has_feature("vtu")) GTEST_SKIP() << "this build writes no VTU files";
  ASSERT_OK(rollcon_body_set_elastic(sphere, 0, 1e11, 0.3));
  ASSERT_OK(rollcon_contact_set_rolling(contact, 1e11));
  ASSERT_OK(rollcon_contact_set_creep(contact, 1e292, 0, 0));
  ASSERT_OK(rollcon_contact_solve(contact));
  EXPECT_EQ(not_finite(ROLLCON_FIELD_SLIP), 0);
  std::int64_t n = 0;
  ASSERT_OK(rollcon_contact_get_field(contact, ROLLCON_FIELD_FRICTION_POWER, ROLLCON_LOCAL, 0, nullptr, &n));
  std::vector<double> power(static_cast<std::size_t>(n));
  EXPECT_FAILS(
      rollcon_contact_get_field(contact, ROLLCON_FIELD_FRICTION_POWER, ROLLCON_LOCAL, n, power.data(), nullptr),
      NONFINITE, "get_field", "comes out as inf");
  EXPECT_FAILS(rollcon_contact_write(contact, "never_written.vtu"), NONFINITE, "friction_power");
  EXPECT_EQ(std::fopen("never_written.vtu", "r"), nullptr);
}
