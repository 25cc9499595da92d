/// Tests a wheel on its rail through the public interface: the Manchester benchmark, missing and bad inputs, geometry,
/// states.

#include <cstring>

#include "wheelrail_fixture.hpp"

using namespace capi_test;

using wheelrail = Wheel;

// CONTACT's answers are forces on the rail, and creepages of the rail relative to the wheel.
TEST_F(wheelrail, manchester_at_2_mm) {
  give(right);
  ASSERT_OK(rollcon_wheelrail_solve(right));
  ASSERT_EQ(patches(right), 1);
  const double limit = 0.3 * 9799;
  expect_error("x, mm", patch_stat(right, "x") + 3.368, 0.01);
  expect_error("y, mm", patch_stat(right, "y") - 740.9147, 0.01);
  expect_error("z, mm", patch_stat(right, "z") - 0.6548, 0.01);
  expect_error("angle", patch_stat(right, "angle") + 0.0806, 1e-4);
  expect_error("longitudinal creepage", patch_stat(right, "longitudinal_creepage") + 8.752e-4, 2e-6);
  expect_error("lateral creepage", patch_stat(right, "lateral_creepage") + 4.818e-3, 5e-6);
  expect_error("spin, 1/mm", patch_stat(right, "spin") + 1.746e-4, 1e-6);
  expect_error("normal force, of CONTACT's", patch_stat(right, "normal_force") / 9799 - 1, 0.01);
  expect_error("longitudinal force, of the limit", (patch_stat(right, "longitudinal_force") - 517.3) / limit, 0.01);
  expect_error("lateral force, of the limit", (patch_stat(right, "lateral_force") - 2893) / limit, 0.01);
  // CONTACT's slip is of first order, on elements of 0.2 mm: about 25 along the patch.
  expect_error("power, of CONTACT's", patch_stat(right, "friction_power") / 28390 - 1, 0.02);

  ASSERT_OK(rollcon_wheelrail_prescribe_vertical(right, ROLLCON_BY_FORCE, 10000));
  ASSERT_OK(rollcon_wheelrail_solve(right));
  double force[3], moment[3], turned[3];
  ASSERT_OK(rollcon_wheelrail_get_resultant(right, ROLLCON_IN_TRACK, force, moment));
  ASSERT_OK(rollcon_wheelrail_get_resultant(right, ROLLCON_IN_WHEELSET, turned, nullptr));
  expect_error("vertical force, N", force[2] + 10000, 1e-2);
  expect_error("z of 10 kN, mm", stat(right, "z") - 0.1529, 1e-4);
  expect_error("force in other axes",
               std::hypot(force[0], force[1], force[2]) / std::hypot(turned[0], turned[1], turned[2]) - 1, 1e-12);
}

// Forces of the contact are turned into the track, with the moment that the place of its axes gives them about the
// wheelset.
TEST_F(wheelrail, axes_of_a_patch_put_its_contact_into_the_track) {
  for (const double side : {1.0, -1.0}) {
    rollcon_wheelrail* w = made(side > 0 ? ROLLCON_RIGHT : ROLLCON_LEFT);
    give(w, side);
    ASSERT_OK(rollcon_wheelrail_solve(w));
    rollcon_contact* contact = nullptr;
    double own_force[3], own_moment[3], force[3], moment[3], origin[3], axes[9];
    ASSERT_OK(rollcon_wheelrail_get_contact(w, 0, &contact));
    ASSERT_OK(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, own_force, own_moment));
    ASSERT_OK(rollcon_wheelrail_get_resultant(w, ROLLCON_IN_TRACK, force, moment));
    ASSERT_OK(rollcon_wheelrail_get_patch_axes(w, 0, origin, axes));
    double f[3] = {0, 0, 0}, m[3] = {0, 0, 0};
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < 3; ++i)
        f[i] += own_force[k] * axes[3 * k + i], m[i] += side * own_moment[k] * axes[3 * k + i];
    const double arm[3] = {origin[0], origin[1] - side * 2, origin[2] - stat(w, "z") + 460};
    for (int i = 0; i < 3; ++i) m[i] += arm[(i + 1) % 3] * f[(i + 2) % 3] - arm[(i + 2) % 3] * f[(i + 1) % 3];
    for (int i = 0; i < 3; ++i) {
      expect_error("force, N", f[i] - force[i], 1e-8);
      expect_error("moment, N mm", m[i] - moment[i], 1e-5);
    }
    EXPECT_EQ(rollcon_wheelrail_get_patch_axes(w, 1, origin, axes), ROLLCON_ERR_ARGUMENT);
    rollcon_contact_release(contact);
    rollcon_wheelrail_release(w);
  }
  EXPECT_EQ(rollcon_wheelrail_get_patch_axes(right, 0, nullptr, nullptr), ROLLCON_ERR_STATE);
}

// The patch lies on the rail's outline, and the wheel's is as deep below it as both overlap; without yaw, the outline
// of the wheel is its profile.
TEST_F(wheelrail, profiles_stand_where_the_patch_is) {
  for (const double side : {1.0, -1.0}) {
    rollcon_wheelrail* w = made(side > 0 ? ROLLCON_RIGHT : ROLLCON_LEFT);
    give(w, side);
    const double position[6] = {0, side * 2, 0.1529, side * -1.128e-4, 0, 0}, deviation[3] = {side * 0.7, -0.3, 0};
    const double still[3] = {0, 0, 0};
    ASSERT_OK(rollcon_wheelrail_set_position(w, position));
    ASSERT_OK(rollcon_wheelrail_set_rail_deviation(w, deviation, still));
    ASSERT_OK(rollcon_wheelrail_prescribe_vertical(w, ROLLCON_BY_FORCE, 10000));
    ASSERT_OK(rollcon_wheelrail_solve(w));
    const double y = patch_stat(w, "y"), z = patch_stat(w, "z");
    double above[2] = {1e9, 1e9};
    for (const std::int32_t body : {1, 2}) {
      double p[2], before[2] = {0, 0};
      constexpr int parts = 20000;
      for (int i = 0; i <= parts; ++i) {
        ASSERT_OK(rollcon_wheelrail_get_profile_point(w, body, static_cast<double>(i) / parts, p));
        const double t = (y - before[0]) / (p[0] - before[0]), there = before[1] + t * (p[1] - before[1]) - z;
        if (i > 0 && t >= 0 && t <= 1 && std::abs(there) < std::abs(above[body - 1])) above[body - 1] = there;
        std::copy(p, p + 2, before);
      }
    }
    expect_error("rail's outline at the patch, mm", above[1], 1e-6);
    expect_error("wheel's outline, of the overlap",
                 above[0] * std::cos(patch_stat(w, "angle")) / patch_stat(w, "overlap") - 1, 0.01);
    double p[2] = {5, 5};
    EXPECT_EQ(rollcon_wheelrail_get_profile_point(w, 3, 0, p), ROLLCON_ERR_ARGUMENT);
    EXPECT_STREQ(rollcon_last_error(), "rollcon_wheelrail_get_profile_point: which is 3; allowed: 1 (wheel), 2 (rail)");
    EXPECT_EQ(rollcon_wheelrail_get_profile_point(w, 2, -1, p), ROLLCON_ERR_ARGUMENT);
    EXPECT_EQ(rollcon_wheelrail_get_profile_point(w, 2, NAN, p), ROLLCON_ERR_NONFINITE);
    EXPECT_EQ(p[0], 5);
    rollcon_wheelrail_release(w);
  }
  double p[2];
  EXPECT_EQ(rollcon_wheelrail_get_profile_point(right, 1, 0, p), ROLLCON_ERR_STATE);
}

TEST_F(wheelrail, left_is_the_mirror_image) {
  rollcon_wheelrail* left = made(ROLLCON_LEFT);
  give(right);
  give(left, -1);
  double f[2][3], m[2][3];
  ASSERT_OK(rollcon_wheelrail_solve(right));
  ASSERT_OK(rollcon_wheelrail_solve(left));
  ASSERT_OK(rollcon_wheelrail_get_resultant(right, ROLLCON_IN_TRACK, f[0], m[0]));
  ASSERT_OK(rollcon_wheelrail_get_resultant(left, ROLLCON_IN_TRACK, f[1], m[1]));
  for (int c = 0; c < 3; ++c) {
    EXPECT_DOUBLE_EQ(f[1][c], c == 1 ? -f[0][c] : f[0][c]);
    EXPECT_DOUBLE_EQ(m[1][c], c == 1 ? m[0][c] : -m[0][c]);
  }
  EXPECT_DOUBLE_EQ(patch_stat(left, "y"), -patch_stat(right, "y"));
  rollcon_wheelrail_release(left);
}

TEST_F(wheelrail, missing_inputs_name_the_call_to_make) {
  const double position[6] = {0, 0, 0.2, 0, 0, 0}, velocity[6] = {1000, 0, 0, 0, 0, -2.2};
  EXPECT_FAILS(rollcon_wheelrail_solve(right), STATE, "rollcon_wheelrail_set_track");
  ASSERT_OK(rollcon_wheelrail_set_track(right, 1435, 14, 0.025));
  EXPECT_FAILS(rollcon_wheelrail_solve(right), STATE, "rollcon_wheelrail_set_wheelset");
  ASSERT_OK(rollcon_wheelrail_set_wheelset(right, 1360, -70, 460));
  EXPECT_FAILS(rollcon_wheelrail_solve(right), STATE, "rollcon_wheelrail_set_position");
  ASSERT_OK(rollcon_wheelrail_set_position(right, position));
  EXPECT_FAILS(rollcon_wheelrail_solve(right), STATE, "rollcon_wheelrail_set_velocity");
  ASSERT_OK(rollcon_wheelrail_set_velocity(right, velocity));
  EXPECT_FAILS(rollcon_wheelrail_solve(right), STATE, "rollcon_wheelrail_set_friction");
  const double mu = 0.3;
  ASSERT_OK(rollcon_wheelrail_set_friction(right, "coulomb", 1, &mu));
  std::int64_t n = -1;
  double value = 0;
  rollcon_contact* contact = nullptr;
  EXPECT_FAILS(rollcon_wheelrail_get_patch_count(right, &n), STATE, "rollcon_wheelrail_solve");
  EXPECT_FAILS(rollcon_wheelrail_get_stat(right, "z", &value), STATE, "rollcon_wheelrail_solve");
  EXPECT_FAILS(rollcon_wheelrail_get_patch_stat(right, 0, "x", &value), STATE, "rollcon_wheelrail_solve");
  EXPECT_FAILS(rollcon_wheelrail_get_resultant(right, 0, nullptr, nullptr), STATE, "rollcon_wheelrail_solve");
  EXPECT_FAILS(rollcon_wheelrail_get_contact(right, 0, &contact), STATE, "rollcon_wheelrail_solve");
  EXPECT_OK(rollcon_wheelrail_solve(right));
  EXPECT_EQ(patches(right), 1);
  ASSERT_OK(rollcon_wheelrail_reset(right));
  EXPECT_FAILS(rollcon_wheelrail_get_patch_count(right, &n), STATE, "rollcon_wheelrail_solve");
}

TEST_F(wheelrail, bad_inputs_are_named_and_change_nothing) {
  give(right);
  const double nan = std::nan(""), six[6] = {0, 0, 0, 0.6, 0, 0}, bad[6] = {0, 0, nan, 0, 0, 0}, none[6] = {};
  EXPECT_FAILS(rollcon_wheelrail_set_track(right, 0, 14, 0), ARGUMENT, "gauge is 0", "> 0");
  EXPECT_FAILS(rollcon_wheelrail_set_track(right, 1435, -1, 0), ARGUMENT, "gauge_height is -1", "> 0");
  EXPECT_FAILS(rollcon_wheelrail_set_track(right, 1435, 14, 1), ARGUMENT, "cant is 1", "-0.5 to 0.5");
  EXPECT_FAILS(rollcon_wheelrail_set_track(right, nan, 14, 0), NONFINITE, "gauge");
  EXPECT_FAILS(rollcon_wheelrail_set_wheelset(right, -1, -70, 460), ARGUMENT, "back_to_back is -1", "> 0");
  EXPECT_FAILS(rollcon_wheelrail_set_wheelset(right, 1360, HUGE_VAL, 460), NONFINITE, "flange_back");
  EXPECT_FAILS(rollcon_wheelrail_set_wheelset(right, 1360, -70, 1), ARGUMENT, "radius");
  EXPECT_FAILS(rollcon_wheelrail_set_rail_deviation(right, bad, none), NONFINITE, "deviation");
  EXPECT_FAILS(rollcon_wheelrail_set_rail_deviation(right, none, nullptr), ARGUMENT, "rate is NULL");
  EXPECT_FAILS(rollcon_wheelrail_set_position(right, nullptr), ARGUMENT, "position is NULL");
  EXPECT_FAILS(rollcon_wheelrail_set_position(right, bad), NONFINITE, "entry 2 of position");
  EXPECT_FAILS(rollcon_wheelrail_set_position(right, six), ARGUMENT, "roll is 0.6", "-0.5 to 0.5");
  EXPECT_FAILS(rollcon_wheelrail_set_velocity(right, bad), NONFINITE, "entry 2 of velocity");
  EXPECT_FAILS(rollcon_wheelrail_set_roller(right, -1, 1), ARGUMENT, "radius is -1", "> 0, or 0: a rail");
  EXPECT_FAILS(rollcon_wheelrail_prescribe_vertical(right, 3, 1), ARGUMENT, "how is 3", "1 (by motion), 2 (by force)");
  EXPECT_FAILS(rollcon_wheelrail_prescribe_vertical(right, ROLLCON_BY_FORCE, -1), ARGUMENT, "force is -1", ">= 0");
  const double friction[] = {-0.1, 0.1, -0.2, 0.1};
  EXPECT_FAILS(rollcon_wheelrail_set_friction(right, "coulomb", 1, friction), ARGUMENT, "mu is -0.1", "0 or more");
  EXPECT_FAILS(rollcon_wheelrail_set_friction(right, "coulomb", 2, friction), ARGUMENT, "n is 2", "1 parameter");
  EXPECT_FAILS(rollcon_wheelrail_set_friction(right, "by_angle", 3, friction), ARGUMENT, "n is 3", "2, 4, 6");
  EXPECT_FAILS(rollcon_wheelrail_set_friction(right, "by_angle", 4, friction), ARGUMENT, "angle of point 1", "above");
  EXPECT_FAILS(rollcon_wheelrail_set_friction(right, "other", 1, friction), ARGUMENT, "law is 'other'", "by_angle");
  EXPECT_FAILS(rollcon_wheelrail_set_friction(right, "coulomb", 1, nullptr), ARGUMENT, "parameters is NULL");
  EXPECT_FAILS(rollcon_wheelrail_set_real(right, "accuracy", 0.001), OPTION, "accuracy", "0.005 to 1");
  EXPECT_OK(rollcon_wheelrail_set_table(right, nullptr));
  ASSERT_OK(rollcon_wheelrail_solve(right));
  double value = -7;
  rollcon_contact* contact = nullptr;
  EXPECT_FAILS(rollcon_wheelrail_get_stat(right, "no such", &value), OPTION, "'no such'", "rollcon_stat_info");
  EXPECT_FAILS(rollcon_wheelrail_get_stat(right, nullptr, &value), ARGUMENT, "name is NULL");
  EXPECT_FAILS(rollcon_wheelrail_get_patch_stat(right, 1, "x", &value), ARGUMENT, "patch is 1", "0 to 0");
  EXPECT_FAILS(rollcon_wheelrail_get_patch_stat(right, 0, "no such", &value), OPTION, "'no such'", "rollcon_stat_info");
  EXPECT_FAILS(rollcon_wheelrail_get_patch_stat(right, 0, "x", nullptr), ARGUMENT, "value is NULL");
  EXPECT_FAILS(rollcon_wheelrail_get_resultant(right, 2, &value, &value), ARGUMENT, "axes is 2", "1 (in wheelset)");
  EXPECT_FAILS(rollcon_wheelrail_get_contact(right, -1, &contact), ARGUMENT, "patch is -1", "0 to 0");
  EXPECT_FAILS(rollcon_wheelrail_get_contact(right, 0, nullptr), ARGUMENT, "contact is NULL");
  EXPECT_EQ(value, -7);
  expect_error("vertical force by what was set first, N", stat(right, "vertical_force") - 10000, 100);
}

TEST_F(wheelrail, geometry_of_a_wheelset) {
  rollcon_wheelrail* left = made(ROLLCON_LEFT);
  const double shift[2] = {1, -1}, bad[2] = {0, 500}, amplitude[2] = {3, -3}, nan = std::nan("");
  constexpr const char* columns = "radius_difference left_y right_y left_radius right_radius";
  double points[2][5], conicity[2], wavelength[2];
  EXPECT_FAILS(rollcon_wheelrail_find_conicity(left, right, 1, amplitude, conicity, nullptr), STATE, "set_track");
  give(right);
  give(left, -1);
  ASSERT_OK(rollcon_wheelrail_find_contact_points(left, right, 2, shift, columns, points[0]));
  expect_error("odd difference, mm", points[0][0] + points[1][0], 1e-12);
  expect_error("points on the other side, mm", points[0][1] + points[1][2], 1e-11);
  expect_error("radii and difference, mm", points[0][4] - points[0][3] - points[0][0], 0);
  ASSERT_OK(rollcon_wheelrail_find_conicity(left, right, 1, amplitude, conicity, wavelength));
  expect_error("conicity beside 0.18", conicity[0] - 0.18, 2e-3);
  ASSERT_OK(rollcon_wheelrail_find_conicity(left, right, 0, nullptr, nullptr, nullptr));
  EXPECT_FAILS(rollcon_wheelrail_find_contact_points(left, right, 2, bad, columns, points[0]), ARGUMENT,
               "entry 1 of shift", "the shift is 500");
  EXPECT_FAILS(rollcon_wheelrail_find_contact_points(left, right, 1, &nan, columns, points[0]), NONFINITE,
               "entry 0 of shift");
  EXPECT_FAILS(rollcon_wheelrail_find_contact_points(left, right, -1, shift, columns, points[0]), ARGUMENT, "n is -1");
  EXPECT_FAILS(rollcon_wheelrail_find_contact_points(left, right, 1, shift, columns, nullptr), ARGUMENT,
               "points is NULL");
  EXPECT_FAILS(rollcon_wheelrail_find_contact_points(left, nullptr, 1, shift, columns, points[0]), ARGUMENT,
               "right is NULL");
  EXPECT_FAILS(rollcon_wheelrail_find_contact_points(right, left, 1, shift, columns, points[0]), ARGUMENT,
               "left is a wheel");
  EXPECT_FAILS(rollcon_wheelrail_find_contact_points(left, left, 1, shift, columns, points[0]), ARGUMENT,
               "right is a wheel on the left");
  EXPECT_FAILS(rollcon_wheelrail_find_conicity(left, reinterpret_cast<rollcon_wheelrail*>(wheel), 1, amplitude,
                                               conicity, nullptr),
               HANDLE, "right");
  EXPECT_FAILS(rollcon_wheelrail_find_conicity(left, right, 2, amplitude, conicity, nullptr), ARGUMENT,
               "entry 1 of amplitude", "> 0");
  rollcon_wheelrail_release(left);
}

TEST_F(wheelrail, states_copies_and_lists) {
  give(right);
  ASSERT_OK(rollcon_wheelrail_prescribe_vertical(right, ROLLCON_BY_FORCE, 10000));
  ASSERT_OK(rollcon_wheelrail_solve(right));
  const double position[2][6] = {{0, 4, 0, 0, 9.6e-3, 0}, {0, 5, 0, 0, 1.2e-2, 0}};
  const double velocity[2][6] = {{2000, 0, 0, 0, 0, -4.34}, {2000, 0, 0, 0, 0, -4.34}};
  constexpr const char* columns = "force_z vertical_force";
  double kept[3], now[3], totals[2][2];
  std::int32_t status[2] = {9, 9};
  ASSERT_OK(rollcon_wheelrail_get_resultant(right, ROLLCON_IN_TRACK, kept, nullptr));
  EXPECT_FAILS(rollcon_wheelrail_rollback(right, 0), STATE, "rollcon_wheelrail_snapshot");
  EXPECT_FAILS(rollcon_wheelrail_snapshot(right, 16), ARGUMENT, "place is 16", "0 to 15");
  ASSERT_OK(rollcon_wheelrail_snapshot(right, 0));
  rollcon_wheelrail* copy = nullptr;
  ASSERT_OK(rollcon_wheelrail_copy(right, &copy));
  ASSERT_OK(rollcon_wheelrail_set_position(right, position[1]));
  ASSERT_OK(rollcon_wheelrail_solve(right));
  ASSERT_OK(rollcon_wheelrail_rollback(right, 0));
  for (const rollcon_wheelrail* w : {right, copy}) {
    ASSERT_OK(rollcon_wheelrail_get_resultant(w, ROLLCON_IN_TRACK, now, nullptr));
    EXPECT_EQ(std::memcmp(now, kept, sizeof now), 0);
  }
  ASSERT_OK(rollcon_wheelrail_solve_many(right, 2, position[0], velocity[0], columns, totals[0], status));
  EXPECT_EQ(status[0] + status[1], 0);
  expect_error("vertical force of the list, N", totals[1][1] - 10000, 2e-2);
  ASSERT_OK(rollcon_wheelrail_solve_many(right, 0, nullptr, nullptr, columns, nullptr, nullptr));
  EXPECT_FAILS(rollcon_wheelrail_solve_many(right, -1, position[0], velocity[0], columns, totals[0], status), ARGUMENT,
               "n is -1");
  EXPECT_FAILS(rollcon_wheelrail_solve_many(right, 1, nullptr, velocity[0], columns, totals[0], status), ARGUMENT,
               "positions is NULL");
  EXPECT_FAILS(rollcon_wheelrail_solve_many(right, 1, position[0], velocity[0], columns, nullptr, status), ARGUMENT,
               "totals is NULL");
  EXPECT_EQ(-totals[1][0], totals[1][1]);
  EXPECT_FAILS(rollcon_wheelrail_solve_many(right, 1, position[0], velocity[0], "z speed", totals[0], status), OPTION,
               "columns has 'speed'", "vertical_force");
  EXPECT_FAILS(rollcon_wheelrail_solve_many(right, 1, position[0], velocity[0], nullptr, totals[0], status), ARGUMENT,
               "columns is NULL");
  EXPECT_FAILS(rollcon_wheelrail_copy(right, nullptr), ARGUMENT, "copy is NULL");
  // A request from before a solve does not count.
  ASSERT_OK(rollcon_wheelrail_request_cancel(right));
  EXPECT_OK(rollcon_wheelrail_solve(right));
  rollcon_wheelrail_release(copy);
}

TEST_F(wheelrail, statistics_have_names) {
  give(right);
  ASSERT_OK(rollcon_wheelrail_solve(right));
  char name[64];
  double value = 0;
  ASSERT_GT(rollcon_stat_count(ROLLCON_OF_WHEELRAIL), 0);
  for (std::int32_t i = 0; i < rollcon_stat_count(ROLLCON_OF_WHEELRAIL); ++i) {
    ASSERT_OK(rollcon_stat_info(ROLLCON_OF_WHEELRAIL, i, sizeof name, name, nullptr, nullptr, nullptr));
    EXPECT_OK(rollcon_wheelrail_get_stat(right, name, &value));
    EXPECT_TRUE(std::isfinite(value)) << name;
  }
  ASSERT_GT(rollcon_stat_count(ROLLCON_OF_PATCH), 0);
  for (std::int32_t i = 0; i < rollcon_stat_count(ROLLCON_OF_PATCH); ++i) {
    ASSERT_OK(rollcon_stat_info(ROLLCON_OF_PATCH, i, sizeof name, name, nullptr, nullptr, nullptr));
    EXPECT_TRUE(std::isfinite(patch_stat(right, name))) << name;
  }
  EXPECT_FAILS(rollcon_stat_info(ROLLCON_OF_WHEELRAIL, -1, sizeof name, name, nullptr, nullptr, nullptr), ARGUMENT,
               "i is -1", "0 to");
  EXPECT_FAILS(rollcon_stat_info(ROLLCON_OF_PATCH, 99, sizeof name, name, nullptr, nullptr, nullptr), ARGUMENT,
               "i is 99", "0 to");
}
