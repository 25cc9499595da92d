/// Compares slip from velocities of cones and crowned rollers with closed forms; tests what the last call decides, and
/// derivatives, lists of cases and the published procedures under such slip.

#include "support/testing.hpp"
#include "velocity_fixture.hpp"

using namespace capi_test;

/// Puts body 1, of any profile revolved about the lateral axis, below body 2, a rigid plane.
class roller_velocity : public Api {
 protected:
  static constexpr double radius = 50, speed = 10;

  void make_roller(const char* shape, std::initializer_list<double> parameters) {
    const double axis[3] = {0, 1, 0}, centre[3] = {0, 0, -radius};
    rollcon_contact_release(contact);
    rollcon_body_release(sphere);
    contact = nullptr;
    ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &sphere));
    ASSERT_OK(rollcon_body_set_elastic(sphere, 0, 1e4, 0.3));
    ASSERT_OK(rollcon_body_set_profile_shape(sphere, shape, static_cast<std::int64_t>(parameters.size()),
                                             parameters.begin()));
    ASSERT_OK(rollcon_body_revolve_profile(sphere, centre, axis, radius));
    contact = new_contact();
  }
  rollcon_contact* new_contact() {
    rollcon_contact* c = nullptr;
    const double mu = 0.3;
    EXPECT_OK(rollcon_contact_create(context, sphere, plane, &c));
    EXPECT_OK(rollcon_contact_frame_rectangle(c, ROLLCON_QUAD4, 16, 16, -2, 2, -2, 2));
    EXPECT_OK(rollcon_contact_set_friction(c, "coulomb", 1, &mu));
    EXPECT_OK(rollcon_contact_set_rolling(c, speed));
    EXPECT_OK(rollcon_contact_prescribe(c, ROLLCON_NORMAL, ROLLCON_BY_MOTION, 0.006));
    return c;
  }
  /// Returns where slip is taken, at speed 1: spin alone tells.
  std::vector<double> slip_points(rollcon_contact* c) {
    EXPECT_OK(rollcon_contact_set_rolling(c, 1));
    EXPECT_OK(rollcon_contact_set_creep(c, 0, 0, 1e-4));
    EXPECT_GE(rollcon_contact_solve(c), 0);
    std::vector<double> v = field_of(c, ROLLCON_FIELD_RIGID_SLIP);
    for (std::size_t k = 0; k < v.size(); k += 2) {
      const double x = v[k + 1] / 1e-4, y = -v[k] / 1e-4;
      v[k] = x, v[k + 1] = y;
    }
    return v;
  }
  void roll(rollcon_contact* c) { ASSERT_OK(move(c, 1, v, omega, {0, 0, -radius})); }
  /// Expects the slip of a roller whose surface is height(x, y).
  template <class Height>
  void expect_slip(const char* what, Height height) {
    const std::vector<double> at = slip_points(contact);
    ASSERT_OK(rollcon_contact_set_rolling(contact, speed));
    roll(contact);
    ASSERT_GE(rollcon_contact_solve(contact), 0);
    const std::vector<double> slip = field_of(contact, ROLLCON_FIELD_RIGID_SLIP);
    double worst = 0, variation = 0;
    for (std::size_t k = 0; k < at.size(); k += 2) {
      const Vector w = v + capi_test::cross(omega, {at[k], at[k + 1], radius + height(at[k], at[k + 1])});
      worst = std::max({worst, std::abs(slip[k] - w[0]), std::abs(slip[k + 1] - w[1])});
      variation = std::max(variation, std::abs(slip[k] - slip[0] - speed * (at[1] - at[k + 1]) * creep_of(contact)[2]));
    }
    rollcon::expect_error(std::string(what) + ": slip at the nodes, over the speed", worst / speed, 1e-13);
    EXPECT_GT(variation, 1e-4 * speed) << "more than spin";
    const Vector w = v + capi_test::cross(omega, {0, 0, radius + height(0, 0)}), creep = creep_of(contact);
    EXPECT_NEAR(creep[0], w[0] / speed, 1e-13);
    EXPECT_NEAR(creep[1], w[1] / speed, 1e-13);
    EXPECT_NEAR(creep[2], omega[2] / speed, 1e-15);
  }

  const Vector v{-speed, 0.01, 0}, omega{0.002, speed / radius * 1.001, 0.003};
};

TEST_F(roller_velocity, cone_slips_more_where_it_is_wider) {
  constexpr double slope = 0.01;
  make_roller("line", {5, slope});
  expect_slip("cone", [](double x, double y) {
    const double r = radius + slope * y;
    return std::sqrt(r * r - x * x) - radius;
  });
}

TEST_F(roller_velocity, crowned_roller_slips_less_towards_its_ends) {
  constexpr double crown = 200;
  make_roller("arc", {crown, 5});
  expect_slip("crowned roller", [](double x, double y) {
    const double r = radius + std::sqrt(crown * crown - y * y) - crown;
    return std::sqrt(r * r - x * x) - radius;
  });
}

// An equal disc loses along the path what the radius of the other loses.
TEST_F(roller_velocity, discs_slip_where_their_radii_differ) {
  make_roller("arc", {200, 5});
  rollcon_contact* c = nullptr;
  const double mu = 0.3;
  rollcon_body* disc = nullptr;
  ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &disc));
  ASSERT_OK(rollcon_body_set_elastic(disc, 0, 1e4, 0.3));
  const double shape[2] = {200, 5}, axis[3] = {0, 1, 0};
  for (const double second : {50.0, 20.0}) {
    const double centre[3] = {0, 0, second};
    ASSERT_OK(rollcon_body_set_profile_shape(disc, "arc", 2, shape));
    ASSERT_OK(rollcon_body_revolve_profile(disc, centre, axis, second));
    ASSERT_OK(rollcon_contact_create(context, sphere, disc, &c));
    ASSERT_OK(rollcon_contact_frame_rectangle(c, ROLLCON_QUAD4, 16, 16, -2, 2, -2, 2));
    ASSERT_OK(rollcon_contact_set_friction(c, "coulomb", 1, &mu));
    ASSERT_OK(rollcon_contact_prescribe(c, ROLLCON_NORMAL, ROLLCON_BY_MOTION, 0.006));
    const std::vector<double> at = slip_points(c);
    ASSERT_OK(move(c, 0, none, none, none));
    ASSERT_OK(move(c, 1, none, {0, -speed / radius, 0}, {0, 0, -radius}));
    ASSERT_OK(move(c, 2, none, {0, speed / second, 0}, {0, 0, second}));
    ASSERT_OK(solve_small(c));
    const std::vector<double> slip = field_of(c, ROLLCON_FIELD_RIGID_SLIP);
    double along = 0, across = 0;
    for (std::size_t k = 2 * 8 * 17; k < 2 * 9 * 17; k += 2) {
      // Each surface point turns about its own axis.
      const double x = at[k],
                   wanted = std::sqrt(1 - x * x / (second * second)) - std::sqrt(1 - x * x / (radius * radius));
      along = std::max(along, std::abs(slip[k] / speed - wanted));
      across = std::max(across, std::abs(slip[k + 1] / speed));
    }
    // The formula is right to the square of the path: the next term is its fourth power over 8 R^4.
    const double bound = second == radius ? 1e-14 : 16 / (4 * std::pow(second, 4));
    const std::string what = "discs of radius 50 and " + std::to_string(static_cast<int>(second));
    rollcon::expect_error(what + ": slip over the speed", along, bound);
    rollcon::expect_error(what + ": lateral", across, 1e-14);
    rollcon_contact_release(c);
    rollcon_body_release(disc);
    ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &disc));
    ASSERT_OK(rollcon_body_set_elastic(disc, 0, 1e4, 0.3));
  }
  rollcon_body_release(disc);
}

TEST_F(roller_velocity, bodies_that_move_as_one_do_not_slip) {
  make_roller("arc", {200, 5});
  for (const std::int32_t which : {1, 2}) ASSERT_OK(move(contact, which, {-3, 2, 5}, {0.4, -0.3, 0.2}, {7, -80, 20}));
  const Vector force = solved_force(contact);
  double largest = 0;
  for (const double s : field_of(contact, ROLLCON_FIELD_RIGID_SLIP)) largest = std::max(largest, std::abs(s));
  rollcon::expect_error("both move as one: slip over the speed", largest / speed, 1e-14);
  ASSERT_OK(rollcon_contact_reset(contact));
  ASSERT_OK(rollcon_contact_set_creep(contact, 0, 0, 0));
  EXPECT_EQ(force, solved_force(contact)) << "without any velocity";
  ASSERT_OK(move(contact, 1, {-3, 2, 5}, {0.4, -0.3, 0.2}, {7, -80, 20}));
  // The velocities are given at other points.
  const Vector omega1{0.4, -0.3, 0.2}, at{-40, 3, 9};
  const Vector there = Vector{-3, 2, 5} + capi_test::cross(omega1, at + -1.0 * Vector{7, -80, 20});
  ASSERT_OK(move(contact, 2, there, omega1, at));
  ASSERT_OK(solve_small(contact));
  for (const double s : field_of(contact, ROLLCON_FIELD_RIGID_SLIP)) largest = std::max(largest, std::abs(s));
  rollcon::expect_error("told of in other points", largest / speed, 1e-13);
}

TEST_F(roller_velocity, last_call_counts) {
  make_roller("arc", {200, 5});
  roll(contact);
  ASSERT_OK(solve_small(contact));
  const std::vector<double> varying = field_of(contact, ROLLCON_FIELD_RIGID_SLIP);
  const Vector creep = creep_of(contact);
  const auto shifted = [&](double by) {
    std::vector<double> slip = varying;
    for (std::size_t k = 0; k < slip.size(); k += 2) slip[k] += speed * by;
    return slip;
  };
  // One creepage is replaced; the rest of the slip stays.
  ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_LONGITUDINAL, ROLLCON_BY_MOTION, creep[0] + 1e-3));
  ASSERT_OK(solve_small(contact));
  rollcon::expect_error("another longitudinal creepage",
                        largest_difference(field_of(contact, ROLLCON_FIELD_RIGID_SLIP), shifted(1e-3)) / speed, 1e-14);
  ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_LONGITUDINAL, ROLLCON_BY_FORCE, -5));
  rollcon::expect_error("force that was prescribed", solved_force(contact)[0] / -5 - 1, 1e-8);
  rollcon::expect_error(
      "the creepage that was found",
      largest_difference(field_of(contact, ROLLCON_FIELD_RIGID_SLIP), shifted(creep_of(contact)[0] - creep[0])) / speed,
      1e-14);
  // The velocities are given once more.
  roll(contact);
  ASSERT_OK(solve_small(contact));
  EXPECT_EQ(field_of(contact, ROLLCON_FIELD_RIGID_SLIP), varying);
  // Creepages alone are given: slip does not vary any more.
  ASSERT_OK(rollcon_contact_set_creep(contact, creep[0], creep[1], 0));
  ASSERT_OK(solve_small(contact));
  const std::vector<double> plain = field_of(contact, ROLLCON_FIELD_RIGID_SLIP);
  for (std::size_t k = 0; k < plain.size(); k += 2) ASSERT_EQ(plain[k], plain[0]);
  // Velocities were forgotten: the plane, which moved, is at rest.
  ASSERT_OK(move(contact, 2, {1, 0, 0}, none, none));
  ASSERT_OK(rollcon_contact_set_creep(contact, 0, 0, 0));
  roll(contact);
  ASSERT_OK(solve_small(contact));
  EXPECT_EQ(field_of(contact, ROLLCON_FIELD_RIGID_SLIP), varying);
  // A field is added.
  const std::vector<double> more(varying.size(), 0.25);
  ASSERT_OK(rollcon_contact_set_creep_field(contact, static_cast<std::int64_t>(more.size() / 2), more.data()));
  ASSERT_OK(solve_small(contact));
  std::vector<double> sum = varying;
  for (double& s : sum) s += 0.25;
  rollcon::expect_error("creep field on top",
                        largest_difference(field_of(contact, ROLLCON_FIELD_RIGID_SLIP), sum) / speed, 1e-13);
}

TEST_F(roller_velocity, derivatives_by_creepage_and_lists_of_cases) {
  make_roller("arc", {200, 5});
  ASSERT_OK(rollcon_contact_set_real(contact, "tolerance", 1e-12));
  roll(contact);
  ASSERT_OK(solve_small(contact));
  const Vector creep = creep_of(contact);
  double slope[3];
  ASSERT_OK(rollcon_contact_get_sensitivity(contact, ROLLCON_LATERAL, slope, nullptr, nullptr, nullptr));
  const double step = 1e-7, values[3] = {creep[1] - step, creep[1], creep[1] + step};
  double force[9];
  std::int32_t status[3];
  ASSERT_GE(rollcon_contact_solve_many(contact, "lateral", 3, values, "force", 3, force, nullptr, status), 0);
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_LATERAL, ROLLCON_BY_MOTION, values[i]));
    const Vector one = solved_force(contact);
    for (std::size_t c = 0; c < 3; ++c) rollcon::expect_error("case of a list", force[3 * i + c] / one[c] - 1, 1e-9);
  }
  rollcon::expect_error("derivative of the lateral force", (force[7] - force[1]) / (2 * step) / slope[1] - 1, 1e-4);
}

TEST_F(roller_velocity, procedures_of_the_paper_see_the_same_slip) {
  if (!rollcon_has_feature("procedures")) GTEST_SKIP() << "this build has no published solution procedures";
  make_roller("arc", {200, 5});
  for (const char* scheme : {"characteristic", "least_squares", "godunov"}) {
    ASSERT_OK(rollcon_contact_set_str(contact, "convection", scheme));
    ASSERT_OK(rollcon_contact_set_procedure(contact, ""));
    roll(contact);
    const Vector one = solved_force(contact);
    ASSERT_OK(rollcon_contact_set_procedure(contact, "system=monolithic"));
    if (solve_small(contact) == ROLLCON_ERR_UNSUPPORTED) continue;
    const Vector other = solved_force(contact);
    for (std::size_t c = 0; c < 3; ++c)
      rollcon::expect_error(std::string(scheme) + ": monolithic beside condensed", other[c] / one[c] - 1, 1e-7);
  }
}
