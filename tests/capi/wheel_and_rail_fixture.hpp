#pragma once
/// Puts a wheel S1002 on a rail 60E1 at positions of the Manchester benchmark (case, right wheel).

#include "fixture.hpp"
#include "space.hpp"

namespace capi_test {

/// Holds what the benchmark prescribes, and CONTACT's answers on elements of 0.2 mm. Units are mm, N and s, x forward,
/// y to the right, z down. Creepages are those of the rail relative to the wheel, forces those on the rail, power in W.
struct Position {
  double y, roll, yaw, z, pitch_rate;  ///< position of the wheelset
  double at[3], angle;                 ///< place and angle of the contact
  double normal, largest_pressure, area;
  double creepage[2], spin, longitudinal, lateral, power;
  double half_length, half_width;  ///< size of a frame
};
constexpr Position positions[] = {{0,
                                   0,
                                   0,
                                   0.1981,
                                   -4.3481181,
                                   {0, 751.8726, 0.1252},
                                   -0.0290,
                                   9997,
                                   338.3,
                                   51.6,
                                   {-5.665e-5, 0},
                                   6.302e-5,
                                   0.2783,
                                   -253.6,
                                   0.4677,
                                   4,
                                   12},
                                  {2,
                                   -1.128e-4,
                                   4.8e-3,
                                   0.1529,
                                   -4.3459197,
                                   {-3.368, 740.9147, 0.6548},
                                   -0.0806,
                                   9799,
                                   744.8,
                                   20.2,
                                   {8.752e-4, 4.818e-3},
                                   1.746e-4,
                                   -517.3,
                                   -2893,
                                   28.39,
                                   4,
                                   12},
                                  {6.5,
                                   -4.376e-3,
                                   15.6e-3,
                                   -3.0468,
                                   -4.2748834,
                                   {5.801, 718.4931, 10.365},
                                   -1.1591,
                                   15440,
                                   2603,
                                   10.0,
                                   {1.828e-2, 3.905e-2},
                                   1.937e-3,
                                   -1987,
                                   -4170,
                                   405.1,
                                   10,
                                   3}};
constexpr double forward_speed = 2000;

/// Makes the scene in other lengths, on the other side of the track, and anywhere.
class wheel_and_rail : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_OK(rollcon_context_create(ROLLCON_ABI, &context));
    make_bodies();
  }
  void TearDown() override {
    rollcon_body_release(wheel);
    rollcon_body_release(rail);
    rollcon_context_release(context);
  }

  void make_bodies() {
    constexpr double shear = 82000, poisson = 0.28;
    const double radius = unit * nominal;
    for (rollcon_body** b : {&wheel, &rail}) {
      rollcon_body_release(*b);
      ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, b));
      ASSERT_OK(rollcon_body_set_elastic(*b, 0, 2 * shear * (1 + poisson) / (unit * unit), poisson));
    }
    const double centre[3] = {0, 0, -radius}, axis[3] = {0, side, 0}, along[3] = {side, 0, 0};
    ASSERT_OK(rollcon_body_set_profile_shape(wheel, "s1002", 1, &unit));
    ASSERT_OK(rollcon_body_revolve_profile(wheel, centre, axis, radius));
    ASSERT_OK(rollcon_body_set_profile_shape(rail, "60e1", 1, &unit));
    const double origin[3] = {0, side * unit * (1435.0 / 2 - gauge_side()), unit * 300 * (1 - std::cos(cant))};
    const double down[3] = {0, side * std::sin(cant), std::cos(cant)};
    ASSERT_OK(rollcon_body_extrude_profile(rail, origin, along, down));
  }

  /// Returns y of the canted rail, turned about its upright top, where it is 14 mm below its highest point; in mm.
  double gauge_side() {
    double low = 0, high = 0, point[2], tangent[2], curvature = 0;
    EXPECT_OK(rollcon_body_get_profile_length(rail, &high));
    high /= 2;
    const double c = std::cos(cant), s = std::sin(cant), top = 300 * (c - 1);
    for (int i = 0; i < 100; ++i) {
      const double middle = (low + high) / 2;
      EXPECT_OK(rollcon_body_get_profile_point(rail, middle, point, tangent, &curvature));
      (point[1] * c - point[0] * s - unit * top > 14 * unit ? low : high) = middle;
    }
    return (point[0] * c + point[1] * s) / unit;
  }

  /// Turns a vector of the wheelset, from mm of the right side, into the scene.
  Vector in_track(double x, double y, double z) const { return {unit * x, side * unit * y, unit * z}; }
  Matrix attitude(const Position& p) const {
    const double cr = std::cos(p.roll), sr = side * std::sin(p.roll), cy = std::cos(p.yaw), sy = side * std::sin(p.yaw);
    return {cy, -sy * cr, sy * sr, sy, cy * cr, -cy * sr, 0, sr, cr};
  }

  /// Makes a contact that overlaps the way the position says, without velocities and frame.
  rollcon_contact* contact_without_frame(const Position& p) {
    const Matrix q = attitude(p);
    const Vector wheel_at = in_track(0, p.y, p.z - nominal) + q * in_track(0, 750, nominal);
    const Vector normal = turn * Vector{0, side * std::sin(-p.angle), std::cos(p.angle)},
                 ahead = turn * Vector{1, 0, 0};
    const Vector origin = turn * in_track(p.at[0], p.at[1], p.at[2]) + shift, moved = turn * wheel_at + shift;
    const double mu = 0.3;
    rollcon_contact* c = nullptr;
    EXPECT_OK(rollcon_contact_create(context, wheel, rail, &c));
    EXPECT_OK(rollcon_contact_set_axes(c, origin.data(), ahead.data(), normal.data()));
    EXPECT_OK(rollcon_contact_set_pose(c, 1, (turn * q).data(), moved.data()));
    EXPECT_OK(rollcon_contact_set_pose(c, 2, turn.data(), shift.data()));
    EXPECT_OK(rollcon_contact_set_friction(c, "coulomb", 1, &mu));
    return c;
  }
  rollcon_contact* contact_at(const Position& p, int nx = 64, int ny = 128) {
    rollcon_contact* c = contact_without_frame(p);
    const double a = unit * p.half_length, b = unit * p.half_width;
    EXPECT_OK(rollcon_contact_frame_rectangle(c, ROLLCON_QUAD4, nx, ny, -a, a, -b, b));
    return c;
  }

  /// Rolls the wheelset forward, turning about its axle; the contact goes with it.
  void roll(rollcon_contact* c, const Position& p, double faster = 1) {
    const Vector forward = turn * Vector{unit * forward_speed, 0, 0}, none{};
    const Vector axle = turn * (attitude(p) * Vector{0, faster * p.pitch_rate, 0});
    const Vector centre = turn * in_track(0, p.y, p.z - nominal) + shift;
    EXPECT_OK(rollcon_contact_set_velocity(c, 0, forward.data(), none.data(), centre.data()));
    EXPECT_OK(rollcon_contact_set_velocity(c, 1, forward.data(), axle.data(), centre.data()));
  }

  static constexpr double nominal = 460;
  const double cant = std::atan(1.0 / 40);
  double unit = 1, side = 1;  ///< length of a millimetre; -1: left wheel
  Matrix turn{1, 0, 0, 0, 1, 0, 0, 0, 1};
  Vector shift{};
  rollcon_context* context = nullptr;
  rollcon_body *wheel = nullptr, *rail = nullptr;
};

}  // namespace capi_test
