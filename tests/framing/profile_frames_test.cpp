/// Tests contacts without a caller's frame between bodies with profiles: gap, patches and frames from surfaces and
/// poses.

#include "rollcon.h"
#include "support/closed_forms.hpp"
#include "support/scene.hpp"
#include "support/steady_rolling.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using scenes::RollingPair;
using scenes::Solution;
const closed_forms::Elastic steel = scenes::steady_rolling::steel;
constexpr double load = 1000, mu = 0.3;

std::array<Vec3, 3> about_x(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {{{1, 0, 0}, {0, c, -s}, {0, s, c}}};
}

void give_shape(RollingPair& pair, int which, const char* shape, const std::vector<double>& parameter) {
  ASSERT_EQ(rollcon_body_set_profile_shape(pair.body(which), shape, static_cast<std::int64_t>(parameter.size()),
                                           parameter.data()),
            ROLLCON_OK)
      << rollcon_last_error();
}

/// Gives a revolved profile that touches the plane z = 0 in the origin: body 1 from below, body 2 from above.
void revolve(RollingPair& pair, int which, double radius, const Vec3& axis) {
  const double centre[3] = {0, 0, which == 1 ? -radius : radius}, along[3] = {axis[0], axis[1], axis[2]};
  ASSERT_EQ(rollcon_body_revolve_profile(pair.body(which), centre, along, radius), ROLLCON_OK) << rollcon_last_error();
}

void expect_same(const std::string& name, const RollingPair& found, const RollingPair& expected, double bound,
                 double approach_bound = 1e-3) {
  const Solution a = found.solution(), b = expected.solution();
  const double length = std::sqrt(expected.stat("contact_area") / std::numbers::pi);
  expect_error(name + ": force vector over mu Fn",
               std::hypot(a.force[0] - b.force[0], a.force[1] - b.force[1]) / (mu * load), bound);
  expect_error(name + ": spin moment", (a.moment[2] - b.moment[2]) / (mu * load * length), bound);
  expect_error(name + ": approach", relative(a.approach, b.approach), approach_bound);
}

TEST(profile_frames_long, spheres_and_crossed_cylinders_are_those_of_a_quadratic_gap) {
  constexpr double r1 = 80, r2 = 300;
  for (const double angle : {-1.0, 0.0, 0.5, 1.2}) {
    const bool sphere = angle < 0;
    RollingPair found(steel, steel), expected(steel, steel);
    for (RollingPair* pair : {&found, &expected}) pair->load(load).friction(mu).creep(6e-4, -4e-4, 2e-4);
    // The gap of a cylinder is the squared distance of (x, y) from the axis (-sin, cos), over the diameter.
    const double c = std::cos(angle), s = std::sin(angle);
    if (sphere) {
      give_shape(found, 2, "arc", {r2, 20});
      revolve(found, 2, r2, {0, 1, 0});
      expected.gap_quadratic(0.5 / r2, 0.5 / r2);
    } else {
      give_shape(found, 1, "line", {30, 0});
      revolve(found, 1, r1, {1, 0, 0});
      give_shape(found, 2, "line", {30, 0});
      revolve(found, 2, r2, {-s, c, 0});
      expected.gap_quadratic(0.5 * c * c / r2, 0.5 / r1 + 0.5 * s * s / r2, s * c / r2);
    }
    ASSERT_EQ(found.solve(), ROLLCON_OK) << rollcon_last_error();
    ASSERT_EQ(expected.solve(), ROLLCON_OK);
    expect_same(sphere ? "sphere on a plane" : "cylinders crossed at " + std::to_string(angle), found, expected, 6e-3);
  }
}

/// Lays a roller of half length 5 on a plane. Pressures are singular at its sharp ends, where convergence is slow.
void lay_straight_roller(RollingPair& pair) {
  pair.load(load).friction(mu).creep(5e-4, 0, 0).option("frame_accuracy", 0.04).option("pressure_length", 0.5);
  give_shape(pair, 2, "line", {5, 0});
  revolve(pair, 2, 6, {0, 1, 0});
}

void lay_crowned_roller(RollingPair& pair, double tilt) {
  pair.load(load).friction(mu).creep(5e-4, 0, 0).pose(2, about_x(tilt), {});
  give_shape(pair, 2, "arc", {300, 10});
  revolve(pair, 2, 60, {0, 1, 0});
}

// The pressure rises without bound towards both ends; frames end there, and their last nodes carry.
TEST(profile_frames_long, a_straight_roller_is_pressed_to_its_ends) {
  RollingPair pair(steel, steel);
  lay_straight_roller(pair);
  ASSERT_EQ(pair.solve(), ROLLCON_OK) << rollcon_last_error();
  const Solution s = pair.solution();
  double end = 0, middle = 0, most = 0;
  for (std::size_t k = 0; k < s.nodes(); ++k) {
    most = std::max(most, std::abs(s.y[k]));
    if (std::abs(s.y[k]) > 4.99) end = std::max(end, s.pressure[k]);
    if (std::abs(s.y[k]) < 1) middle = std::max(middle, s.pressure[k]);
  }
  expect_error("the frame ends where the roller does", most - 5, 1e-4);
  report("largest pressure at the end over that in the middle", end / middle);
  EXPECT_GT(end, 1.2 * middle);

  RollingPair lattice(steel, steel);
  lay_straight_roller(lattice);
  double half = 0;
  for (const double x : s.x) half = std::max(half, 1.3 * std::abs(x));
  lattice.rectangle(ElementType::quad4, 112, 256, half, 5 * (1 - 1e-9));
  ASSERT_EQ(lattice.solve(), ROLLCON_OK);
  expect_same("straight roller beside a lattice", pair, lattice, 2e-2, 1e-2);
  pair.option("frame_accuracy", 0.005);
  EXPECT_EQ(pair.solve(), ROLLCON_OK) << rollcon_last_caveat();
  expect_same("the same on finer frames", pair, lattice, 5e-3, 3e-3);
}

// The middle of the contact is not at the origin, and the origin may be where the bodies are apart.
TEST(profile_frames, errors_are_told_wherever_the_axes_are) {
  double estimate[2] = {0, 0};
  for (const double at : {0.0, 3.7}) {
    RollingPair pair(steel, steel);
    lay_crowned_roller(pair, 2e-3);
    pair.axes({0, at, 0}, {1, 0, 0}, {0, 0, 1});
    ASSERT_EQ(pair.solve(), ROLLCON_OK) << rollcon_last_error();
    estimate[at > 0] = pair.stat("error_estimate");
  }
  expect_error("estimates from both origins", relative(estimate[1], estimate[0]), 1e-6);
}

constexpr double ball_radius = 8, degree = std::numbers::pi / 180;

/// Returns Hertz's pressure of the ball under a normal force.
double pressure_of_ball(double force) {
  const double modulus = closed_forms::effective_modulus(steel, steel);
  return std::cbrt(6 * force * modulus * modulus / (ball_radius * ball_radius)) / std::numbers::pi;
}

/// Lays a ball on a plane through the origin that is inclined by an angle about the rolling direction.
void lay_ball_on_plane(RollingPair& pair, double angle) {
  const double s = std::sin(angle), c = std::cos(angle);
  give_shape(pair, 1, "line", {25, 0});
  give_shape(pair, 2, "arc", {ball_radius, 0.999 * ball_radius});
  const double origin[3] = {}, along[3] = {1, 0, 0}, normal[3] = {0, -s, c};
  const double centre[3] = {0, -ball_radius * s, ball_radius * c}, axis[3] = {0, 1, 0};
  ASSERT_EQ(rollcon_body_extrude_profile(pair.body(1), origin, along, normal), ROLLCON_OK);
  ASSERT_EQ(rollcon_body_revolve_profile(pair.body(2), centre, axis, ball_radius), ROLLCON_OK);
}

// A ball on an inclined plane, pressed along n of the axes: the normal force is load / cos(angle).
TEST(profile_frames, inclined_normals_are_told_on_planes) {
  for (const double angle : {5.0, 20.0, 45.0, 65.0})
    for (const bool turned : {false, true}) {
      RollingPair pair(steel, steel);
      const double s = std::sin(angle * degree), c = std::cos(angle * degree);
      lay_ball_on_plane(pair, angle * degree);
      if (turned) pair.axes({0, 0, 0}, {1, 0, 0}, {0, -s, c});
      // Frames do not follow surfaces steeper than 60 degrees.
      pair.friction(0).load(turned ? load / c : load).option("conformal", std::int64_t{angle > 60 ? 0 : -1});
      EXPECT_EQ(pair.solve(), turned || angle < 10 ? ROLLCON_OK : ROLLCON_INACCURATE) << angle;
      const std::string name = std::to_string(angle) + (turned ? " degrees, axes along the normal" : " degrees");
      const double off = relative(pair.stat("max_pressure"), pressure_of_ball(load / c));
      if (turned || angle < 60) expect_error(name, off, turned ? 1e-3 : 1.1 * (1 / c - 1));
      if (!turned) expect_error(name + ": estimate over error", pair.stat("error_estimate") / off - 1, 0.2);
    }
}

TEST(profile_frames, frames_follow_inclined_patches) {
  for (const double angle : {8.0, 20.0, 45.0, 58.0}) {
    RollingPair pair(steel, steel);
    lay_ball_on_plane(pair, angle * degree);
    pair.friction(0).load(load);
    EXPECT_EQ(pair.solve(), ROLLCON_OK) << angle << ": " << rollcon_last_caveat();
    const double c = std::cos(angle * degree), modulus = closed_forms::effective_modulus(steel, steel);
    const std::string name = std::to_string(angle) + " degrees: ";
    const double sunk = std::cbrt(9 * load * load / (16 * ball_radius * modulus * modulus * c * c)) / c;
    expect_error(name + "pressure", relative(pair.stat("max_pressure"), pressure_of_ball(load / c)), 2e-3);
    expect_error(name + "approach", relative(pair.solution().approach, sunk), 2e-3);
  }
}

// Frames follow surfaces across the rolling direction alone.
TEST(profile_frames, normals_inclined_along_rolling_are_told) {
  RollingPair pair(steel, steel);
  lay_ball_on_plane(pair, 0);
  const double s = std::sin(15 * degree), c = std::cos(15 * degree);
  pair.axes({0, 0, 0}, {c, 0, -s}, {s, 0, c}).friction(0).load(load);
  EXPECT_EQ(pair.solve(), ROLLCON_INACCURATE);
  expect_error("estimate beside that of 15 degrees", relative(pair.stat("error_estimate"), 1 / c - 1), 0.1);
}

// Each side of the ball is beside a contact of its own, with axes along its normal and the motion there.
TEST(profile_frames, a_ball_rolls_in_a_v) {
  for (const double angle : {20 * degree, 35 * degree, 44.9 * degree}) {
    const double s = std::sin(angle), c = std::cos(angle), side = load / (2 * c), height = 3 * ball_radius * s / c;
    RollingPair pair(steel, steel);
    const double y = 3 * ball_radius, points[10] = {-y, height, -y / 2, height / 2, 0, 0, y / 2, height / 2, y, height};
    ASSERT_EQ(rollcon_body_set_profile(pair.body(1), 5, points, 0), ROLLCON_OK) << rollcon_last_error();
    const double origin[3] = {}, along[3] = {1, 0, 0}, up[3] = {0, 0, 1};
    ASSERT_EQ(rollcon_body_extrude_profile(pair.body(1), origin, along, up), ROLLCON_OK);
    give_shape(pair, 2, "arc", {ball_radius, 0.999 * ball_radius});
    const double centre[3] = {0, 0, ball_radius / c}, axis[3] = {0, 1, 0};
    ASSERT_EQ(rollcon_body_revolve_profile(pair.body(2), centre, axis, ball_radius), ROLLCON_OK);
    pair.load(load).friction(mu).creep(4e-4, 2e-4, 2e-4);
    EXPECT_EQ(pair.solve(), ROLLCON_OK) << rollcon_last_caveat();
    Vec3 sum{};
    for (const double sign : {-1.0, 1.0}) {
      RollingPair one(steel, steel);
      one.gap_quadratic(0.5 / ball_radius, 0.5 / ball_radius).load(side).friction(mu);
      one.creep(4e-4 - 2e-4 * sign * ball_radius * s, 2e-4 * c, 2e-4 * c);
      EXPECT_EQ(one.solve(), ROLLCON_OK);
      const Vec3 f = one.solution().force;
      sum = sum + Vec3{f[0], c * f[1] - sign * s * f[2], sign * s * f[1] + c * f[2]};
    }
    const std::string name = "V of " + std::to_string(angle / degree) + " degrees: ";
    const Vec3 off = pair.solution().force - sum;
    // Both sides feel each other a little.
    expect_error(name + "force over mu Fn", std::hypot(off[0], off[1]) / (2 * mu * side), 8e-3);
    expect_error(name + "pressure", relative(pair.stat("max_pressure"), pressure_of_ball(side)), 1e-3);
    EXPECT_LE(pair.solution().nodes(), 2000) << "frames cover the patches alone";
  }
}

TEST(profile_frames, another_pose_is_another_frame) {
  RollingPair pair(steel, steel), fresh(steel, steel);
  lay_crowned_roller(pair, 0);
  ASSERT_EQ(pair.solve(), ROLLCON_OK) << rollcon_last_error();
  const double lever = pair.solution().moment[0];
  pair.pose(2, about_x(5e-3), {});
  ASSERT_EQ(pair.solve(), ROLLCON_OK) << rollcon_last_error();
  // The circle touches where it is level.
  expect_error("lever of the normal force", relative((pair.solution().moment[0] - lever) / load, 300 * 5e-3), 1e-2);
  lay_crowned_roller(fresh, 5e-3);
  ASSERT_EQ(fresh.solve(), ROLLCON_OK);
  expect_same("tilted roller, found from the straight one", pair, fresh, 1e-9);
}

TEST(profile_frames, bodies_that_give_no_frame_are_told) {
  const auto refused = [](RollingPair& pair, const char* words) {
    const std::int32_t status = rollcon_contact_solve(pair.handle());
    const std::string message = rollcon_last_error();
    EXPECT_EQ(status, ROLLCON_ERR_STATE) << message;
    EXPECT_NE(message.find(words), std::string::npos) << message;
  };
  const double origin[3] = {0, 0, 0}, along[3] = {1, 0, 0}, up[3] = {0, 0, 1};
  RollingPair rail(steel, steel);
  rail.load(load).friction(mu);
  give_shape(rail, 1, "arc", {80, 30});
  ASSERT_EQ(rollcon_body_extrude_profile(rail.body(1), origin, along, up), ROLLCON_OK);
  refused(rail, "without end");
  RollingPair beside(steel, steel);
  beside.load(load).friction(mu).creep(5e-4, 0, 0).pose(2, about_x(0), {0, 100, 0});
  give_shape(beside, 1, "arc", {80, 30});
  ASSERT_EQ(rollcon_body_extrude_profile(beside.body(1), origin, along, up), ROLLCON_OK);
  give_shape(beside, 2, "line", {30, 0});
  revolve(beside, 2, 300, {0, 1, 0});
  refused(beside, "no part of one body lies over the other");
  beside.pose(2, about_x(0), {0, 0, 0});
  EXPECT_EQ(beside.solve(), ROLLCON_OK) << "the contact stays usable";
  RollingPair nothing(steel, steel);
  nothing.load(load).friction(mu);
  refused(nothing, "no frame was given");
}

/// Lays a roller of radius 6 and half length 5 on a plane; its axis is level until it is posed.
void lay_roller_that_ends(RollingPair& pair, const char* shape, const std::vector<double>& parameter) {
  pair.load(1500).friction(0).option("pressure_length", 0.2);
  give_shape(pair, 1, shape, parameter);
  const double centre[3] = {0, 0, 0}, axis[3] = {0, 1, 0}, origin[3] = {0, 0, 0}, x[3] = {1, 0, 0}, z[3] = {0, 0, 1};
  ASSERT_EQ(rollcon_body_revolve_profile(pair.body(1), centre, axis, 6), ROLLCON_OK);
  give_shape(pair, 2, "line", {20, 0});
  ASSERT_EQ(rollcon_body_extrude_profile(pair.body(2), origin, x, z), ROLLCON_OK);
}

// The far side of a roller takes no part beyond its near end, a body's end is no rim, and the largest pressure there
// does not depend on the scenes before.
TEST(profile_frames, tilted_rollers_mirrored_give_the_mirrored_result) {
  const struct {
    const char* shape;
    std::vector<double> parameter;
  } shapes[] = {{"arc", {2000, 5}},
                {"line", {5, 0}},
                {"arcs", {-4.999993385, -0.0068125, 0.00325, 1.5, -1e-3, 7, -5e-4, 1.5, -1e-3}}};
  for (const auto& [shape, parameter] : shapes) {
    RollingPair warm(steel, steel);
    lay_roller_that_ends(warm, shape, parameter);
    for (const double tilt : {5e-4, 1e-2, 1e-3}) {
      double pressure[2], approach[2];
      for (const bool mirrored : {false, true}) {
        const auto turn = about_x(mirrored ? -tilt : tilt);
        RollingPair cold(steel, steel);
        lay_roller_that_ends(cold, shape, parameter);
        for (RollingPair* const pair : {&cold, &warm}) {
          pair->pose(1, turn, {0, 0, -6});
          ASSERT_EQ(pair->solve(), ROLLCON_OK) << shape << " at " << tilt << ": " << rollcon_last_caveat();
        }
        const std::string name = std::string(shape) + " tilted by " + std::to_string(tilt);
        pressure[mirrored] = cold.stat("max_pressure");
        approach[mirrored] = cold.solution().approach;
        expect_error(name + ": approach, warm", relative(warm.solution().approach, approach[mirrored]), 5e-3);
        expect_error(name + ": largest pressure, warm", relative(warm.stat("max_pressure"), pressure[mirrored]), 5e-3);
      }
      expect_error("approach, mirrored", relative(approach[1], approach[0]), 1e-3);
      expect_error("largest pressure, mirrored", relative(pressure[1], pressure[0]), 1e-3);
    }
  }
}

TEST(profile_frames, bodies_in_the_other_order_are_refused) {
  for (const bool exchanged : {false, true}) {
    RollingPair pair(steel, steel);
    pair.load(900).friction(mu);
    const int wheel = exchanged ? 1 : 2, rail = 3 - wheel;
    give_shape(pair, wheel, "arc", {250, 15});
    const double centre[3] = {0, 0, 40}, axis[3] = {0, 1, 0}, origin[3] = {0, 0, 0}, x[3] = {1, 0, 0}, z[3] = {0, 0, 1};
    ASSERT_EQ(rollcon_body_revolve_profile(pair.body(wheel), centre, axis, 40), ROLLCON_OK);
    give_shape(pair, rail, "arc", {180, 15});
    ASSERT_EQ(rollcon_body_extrude_profile(pair.body(rail), origin, x, z), ROLLCON_OK);
    if (!exchanged) {
      EXPECT_EQ(pair.solve(), ROLLCON_OK) << rollcon_last_error();
      continue;
    }
    EXPECT_ANY_THROW(pair.solve());
    EXPECT_NE(std::string(rollcon_last_error()).find("exchange the bodies"), std::string::npos) << rollcon_last_error();
  }
}

// A roller that is posed with the tilt found for a load beside its middle carries the load there.
TEST(profile_frames, follow_the_tilt_that_a_moment_asks_for) {
  for (const double beside : {0.5, -1.0}) {
    RollingPair pair(steel, steel), posed(steel, steel);
    for (RollingPair* const p : {&pair, &posed}) lay_roller_that_ends(*p, "arc", {2000, 5});
    pair.pose(1, about_x(0), {0, 0, -6});
    const double moment = -1500 * beside;
    ASSERT_EQ(rollcon_contact_prescribe(pair.handle(), ROLLCON_TILT_1, ROLLCON_BY_FORCE, moment), ROLLCON_OK);
    ASSERT_EQ(pair.solve(), ROLLCON_OK) << rollcon_last_caveat();
    double tilt[2];
    ASSERT_EQ(rollcon_contact_get_tilt(pair.handle(), tilt), ROLLCON_OK);
    posed.pose(1, about_x(tilt[0]), {0, 6 * std::sin(tilt[0]), -6 * std::cos(tilt[0])});
    ASSERT_EQ(posed.solve(), ROLLCON_OK) << rollcon_last_caveat();
    expect_error("moment given", relative(pair.solution().moment[0], moment), 1e-9);
    expect_error("moment of the roller that is posed", relative(posed.solution().moment[0], moment), 1e-2);
    expect_error("approach", relative(posed.solution().approach, pair.solution().approach), 1e-2);
    // Frames that are already there give the same tilt.
    ASSERT_EQ(pair.solve(), ROLLCON_OK);
    double again[2];
    ASSERT_EQ(rollcon_contact_get_tilt(pair.handle(), again), ROLLCON_OK);
    expect_error("tilt, solved again", relative(again[0], tilt[0]), 5e-3);
    ASSERT_EQ(rollcon_contact_prescribe(pair.handle(), ROLLCON_TILT_1, ROLLCON_BY_MOTION, tilt[0]), ROLLCON_OK);
    ASSERT_EQ(pair.solve(), ROLLCON_OK);
    expect_error("moment of the tilt", relative(pair.solution().moment[0], moment), 1e-2);
  }
}

}  // namespace
}  // namespace rollcon
