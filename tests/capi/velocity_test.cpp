/// Compares slip from velocities of bodies without profiles, a sphere on a plane, a curved mesh, with closed forms;
/// tests the speed that follows, and what is refused.

#include "fem_fixture.hpp"
#include "support/testing.hpp"
#include "velocity_fixture.hpp"

using namespace capi_test;

/// Uses the sphere of Api as body 1; n points out of it, upwards here.
class velocity : public Api {
 protected:
  static constexpr double radius = 50;

  /// Places axes anywhere, with the frame in their plane.
  void place(const Matrix& q, const Vector& origin) {
    set_scene();
    const Vector ahead = q * Vector{1, 0, 0}, up = q * Vector{0, 0, 1};
    for (std::size_t k = 0; k < frame.x.size(); k += 3) {
      const Vector at = q * Vector{frame.x[k], frame.x[k + 1], 0} + origin;
      std::copy(at.begin(), at.end(), frame.x.begin() + static_cast<std::ptrdiff_t>(k));
    }
    set_scene();
    ASSERT_OK(rollcon_contact_set_axes(contact, origin.data(), ahead.data(), up.data()));
  }
};

TEST_F(velocity, rolling_sphere_has_creepages_of_the_closed_form) {
  // The plane moves and turns, too.
  const double speed = 10;
  for (const Matrix& q : {Matrix{1, 0, 0, 0, 1, 0, 0, 0, 1}, turned({1, 2, -1}, 0.8)}) {
    const bool upright = q[0] == 1;
    const Vector origin = upright ? none : Vector{30, -20, 5};
    frame = SquareFrame(12, 1.5);
    place(q, origin);
    const Vector v1{-speed, 0.02, 0}, omega1{0.003, 0.2005, 0.004}, v2{-speed - 0.3, -0.01, 0},
        omega2{0, 0.001, -0.002};
    const Vector other{0.4, -7, 3};
    ASSERT_OK(move(contact, 1, q * v1, q * omega1, q * Vector{0, 0, -radius} + origin));
    ASSERT_OK(move(contact, 2, q * v2, q * omega2, q * other + origin));
    ASSERT_OK(rollcon_contact_solve(contact));
    const Vector a = v1 + capi_test::cross(omega1, {0, 0, radius}), b = v2 + capi_test::cross(omega2, -1.0 * other);
    const Vector wanted{(a[0] - b[0]) / speed, (a[1] - b[1]) / speed, (omega1[2] - omega2[2]) / speed};
    const Vector creep = creep_of(contact);
    double worst = 0;
    for (std::size_t i = 0; i < 3; ++i) worst = std::max(worst, std::abs(creep[i] - wanted[i]));
    rollcon::expect_error(upright ? "rolling sphere: creepages" : "the same, turned and shifted", worst, 1e-14);
    const std::vector<double> moved = field_of(contact, ROLLCON_FIELD_TRACTION),
                              slip = field_of(contact, ROLLCON_FIELD_RIGID_SLIP);
    // Warm starts would end beside each other within the tolerance.
    ASSERT_OK(rollcon_contact_reset(contact));
    ASSERT_OK(rollcon_contact_set_creep(contact, creep[0], creep[1], creep[2]));
    ASSERT_OK(rollcon_contact_solve(contact));
    EXPECT_EQ(moved, field_of(contact, ROLLCON_FIELD_TRACTION));
    EXPECT_EQ(slip, field_of(contact, ROLLCON_FIELD_RIGID_SLIP));
  }
}

TEST_F(velocity, without_a_frame_as_the_creepages_that_follow) {
  const double mu = 0.3;
  ASSERT_OK(rollcon_contact_set_gap_quadratic(contact, 0.01, 0.02, 0));
  ASSERT_OK(rollcon_contact_set_friction(contact, "coulomb", 1, &mu));
  ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, 100));
  ASSERT_OK(move(contact, 0, {20, 0, 0}, none, none));
  std::array<Vector, 2> force{};
  for (const bool again : {false, true}) {  // the second time another load moves the frames
    if (again) {
      ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, 120));
    }
    ASSERT_OK(move(contact, 1, {20, 0.01, 0}, {0, -0.4004, 0.001}, {0, 0, -radius}));
    force[0] = solved_force(contact);
    const Vector creep = creep_of(contact);
    rollcon_contact* fresh = nullptr;
    ASSERT_OK(rollcon_contact_create(context, sphere, plane, &fresh));
    ASSERT_OK(rollcon_contact_set_gap_quadratic(fresh, 0.01, 0.02, 0));
    ASSERT_OK(rollcon_contact_set_friction(fresh, "coulomb", 1, &mu));
    ASSERT_OK(rollcon_contact_prescribe(fresh, ROLLCON_NORMAL, ROLLCON_BY_FORCE, again ? 120 : 100));
    ASSERT_OK(rollcon_contact_set_creep(fresh, creep[0], creep[1], creep[2]));
    force[1] = solved_force(fresh);
    rollcon_contact_release(fresh);
    for (std::size_t i = 0; i < 3; ++i)
      rollcon::expect_error("no frame: force from velocities and from creepages", force[0][i] / force[1][i] - 1, 1e-7);
  }
}

TEST_F(velocity, speed_is_that_of_the_contact_less_the_mean_of_both_bodies) {
  set_scene();
  const double ahead = 3, first = -7, second = -6.5;
  ASSERT_OK(move(contact, 0, {ahead, 1, 2}, none, none));
  ASSERT_OK(move(contact, 1, {first, 0, 0}, none, none));
  ASSERT_OK(move(contact, 2, {second, 0, 0}, none, none));
  const auto expect_speed = [&](double wanted) {
    double speed = 0;
    EXPECT_OK(rollcon_contact_solve(contact));
    EXPECT_OK(rollcon_contact_get_stat(contact, "rolling_speed", &speed));
    rollcon::expect_error("rolling speed", speed / wanted - 1, 1e-15);
    EXPECT_NEAR(creep_of(contact)[0], (first - second) / wanted, 1e-15);
  };
  expect_speed(ahead - (first + second) / 2);
  ASSERT_OK(rollcon_contact_set_rolling(contact, 4));
  expect_speed(4);
  ASSERT_OK(move(contact, 0, {2, 0, 0}, {0, 0, 1}, {0, -1, 0}));  // 1 at the origin
  expect_speed(1 - (first + second) / 2);
}

TEST_F(velocity, what_is_refused_leaves_the_contact_usable) {
  const double nothing[3] = {0, 0, 0};
  set_scene();
  for (const std::int32_t which : {-1, 3})
    EXPECT_FAILS(rollcon_contact_set_velocity(contact, which, nothing, nothing, nothing), ARGUMENT,
                 "which is " + std::to_string(which), "0 (the contact), 1, 2");
  EXPECT_FAILS(rollcon_contact_set_velocity(contact, 1, nullptr, nothing, nothing), ARGUMENT, "velocity is NULL");
  EXPECT_FAILS(rollcon_contact_set_velocity(contact, 1, nothing, nullptr, nothing), ARGUMENT,
               "angular_velocity is NULL");
  EXPECT_FAILS(rollcon_contact_set_velocity(contact, 1, nothing, nothing, nullptr), ARGUMENT, "point is NULL");
  for (const double bad : {std::nan(""), HUGE_VAL}) {
    const double wrong[3] = {0, bad, 0};
    EXPECT_FAILS(rollcon_contact_set_velocity(contact, 1, wrong, nothing, nothing), NONFINITE,
                 "component y of velocity");
    EXPECT_FAILS(rollcon_contact_set_velocity(contact, 2, nothing, wrong, nothing), NONFINITE,
                 "component y of angular_velocity");
    EXPECT_FAILS(rollcon_contact_set_velocity(contact, 0, nothing, nothing, wrong), NONFINITE, "component y of point");
  }
  // The refused velocities were not taken: creepages are those of before.
  const Vector force = solved_force(contact);
  EXPECT_EQ(creep_of(contact)[0], 1e-3);

  EXPECT_FAILS(rollcon_contact_set_rolling(contact, 0), ARGUMENT, "speed is 0", "> 0");
  for (const Vector& ahead : {Vector{0, 5, 0}, Vector{-1, 0, 0}}) {
    ASSERT_OK(move(contact, 0, ahead, none, none));
    EXPECT_FAILS(rollcon_contact_solve(contact), ARGUMENT, "velocity of the contact along the rolling direction", "> 0",
                 "rollcon_contact_set_velocity");
  }
  ASSERT_OK(move(contact, 0, {10, 0, 0}, none, none));
  ASSERT_OK(move(contact, 1, {1e300, 0, 0}, {0, 1e300, 0}, {1e300, 0, 1e300}));
  EXPECT_LT(rollcon_contact_solve(contact), 0);
  ASSERT_OK(rollcon_contact_set_rolling(contact, 10));
  EXPECT_FAILS(rollcon_contact_solve(contact), ARGUMENT, "velocities");
  ASSERT_OK(rollcon_contact_set_creep(contact, 1e-3, 0, 0));
  const Vector again = solved_force(contact);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(again[i], force[i], 1e-8 * std::abs(force[2]));

  // A contact without any speed is refused.
  rollcon_contact* c = nullptr;
  const double mu = 0.3;
  ASSERT_OK(rollcon_contact_create(context, sphere, plane, &c));
  give_frame(c, frame);
  ASSERT_OK(rollcon_contact_set_gap_quadratic(c, 0.01, 0.01, 0));
  ASSERT_OK(rollcon_contact_set_friction(c, "coulomb", 1, &mu));
  ASSERT_OK(move(c, 1, {1e-3, 0, 0}, none, none));
  EXPECT_FAILS(rollcon_contact_solve(c), STATE, "rollcon_contact_set_velocity", "rollcon_contact_set_rolling");
  ASSERT_OK(rollcon_contact_set_rolling(c, 1));
  ASSERT_OK(rollcon_contact_prescribe(c, ROLLCON_NORMAL, ROLLCON_BY_MOTION, 0.02));
  EXPECT_OK(solve_small(c));
  EXPECT_EQ(creep_of(c)[0], 1e-3);
  rollcon_contact_release(c);
}

// The top of a cube is a cylinder along the rolling direction. Slip lies in the tangent plane of its nodes, between it
// and the plane of body 2.
TEST_F(velocity, curved_mesh_takes_the_part_along_its_surface) {
  if (!rollcon_has_feature("fem")) GTEST_SKIP() << "this build has no finite elements";
  BoxVolume box(6);
  for (std::size_t k = 0; k < box.x.size(); k += 3) box.x[k + 2] *= 1 - 0.3 * std::pow(box.x[k + 1] - 0.5, 2);
  rollcon_body* body = nullptr;
  ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_FEM, &body));
  ASSERT_OK(rollcon_body_set_elastic(body, 0, 200, 0.3));
  give_mesh(body, box);
  ASSERT_OK(hold(body, box.nodes_at(2, 0), ROLLCON_DOF_XYZ));
  rollcon_contact* c = roll_on_top(context, body, plane);
  ASSERT_OK(rollcon_contact_set_rolling(c, 1));
  const auto slip_of = [&](double longitudinal, double lateral) {
    EXPECT_OK(rollcon_contact_set_creep(c, longitudinal, lateral, 0));
    EXPECT_GE(rollcon_contact_solve(c), 0);
    return field_of(c, ROLLCON_FIELD_RIGID_SLIP, ROLLCON_GLOBAL);
  };
  const std::vector<double> x = (slip_of(0, 0), field_of(c, ROLLCON_FIELD_POINT)), first = slip_of(1e-2, 0),
                            second = slip_of(0, 1e-2);
  const Vector v{0.002, -0.004, 0.003}, omega{0.05, 0.02, 0.01};
  ASSERT_OK(move(c, 1, v, omega, {0.5, 0.5, 1}));
  ASSERT_GE(rollcon_contact_solve(c), 0) << error();
  const std::vector<double> slip = field_of(c, ROLLCON_FIELD_RIGID_SLIP, ROLLCON_GLOBAL);
  double worst = 0, least = 1;
  for (std::size_t k = 0; k < x.size(); k += 3) {
    // The parts of e_n along the surface follow from those of e_1 and e_2.
    const double squared = 1 - 1e2 * second[k + 1];  // from the normal's component 2
    ASSERT_NEAR(first[k], 1e-2, 1e-12) << "the surface is straight along the rolling direction";
    least = std::min(least, 1 - squared);
    const Vector third{0, 1e2 * second[k + 2], squared};
    // The slip lies between both surfaces, half of each because neither is curved along the path, and along the nodes'
    // own normals.
    const double n2 = -std::copysign(std::sqrt(std::max(squared, 0.0)), second[k + 2]), n3 = std::sqrt(1 - squared);
    const double half = 0.5 * -x[k + 2] / n3;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto at = [&](double along) {
        const Vector w = v + capi_test::cross(omega, {along, x[k + 1] + half * n2, x[k + 2] + half * n3});
        return 1e2 * (w[0] * first[k + i] + w[1] * second[k + i]) + w[2] * third[i];
      };
      // Slip is taken within a spacing upstream, where it is linear.
      const double here = at(x[k]), ahead = at(x[k] + 1.0 / 6), value = slip[k + i];
      const double rounding = 1e-9;
      worst = std::max({worst, std::min(here, ahead) - rounding - value, value - std::max(here, ahead) - rounding});
    }
  }
  rollcon::expect_error("slip along a curved surface, beyond its values here and a spacing ahead", std::max(worst, 0.0),
                        1e-9);
  EXPECT_LT(least, 0.96) << "the surface is curved";
  rollcon_contact_release(c);
  rollcon_body_release(body);
}
