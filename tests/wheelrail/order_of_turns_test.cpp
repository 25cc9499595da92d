/// Tests positions whose roll is outside the yaw, which CONTACT has: positions whose yaw is outside are compared with
/// products of matrices that are written out here.

#include <array>
#include <cmath>

#include "wheel_rail_fixture.hpp"
#include "wheelrail/solve_positions.hpp"
#include "wheelrail/wheelset_geometry.hpp"

namespace rollcon {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

Matrix about_x(double a) {
  return {{{1, 0, 0}, {0, std::cos(a), -std::sin(a)}, {0, std::sin(a), std::cos(a)}}};
}
Matrix about_z(double a) {
  return {{{std::cos(a), -std::sin(a), 0}, {std::sin(a), std::cos(a), 0}, {0, 0, 1}}};
}
Matrix times(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) c[i][j] += a[i][k] * b[k][j];
  return c;
}
Matrix transposed(const Matrix& a) {
  Matrix b{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) b[i][j] = a[j][i];
  return b;
}
Vec3 times(const Matrix& a, const Vec3& v) {
  Vec3 r{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) r[i] += a[i][j] * v[j];
  return r;
}

/// Holds roll and yaw that turn a wheelset with the yaw outside like others turn it with the roll outside, and the
/// pitch that is left over.
struct Turns {
  double roll, yaw, pitch;
};
Turns yaw_outside(double roll, double yaw) {
  const Matrix m = times(about_x(roll), about_z(yaw));
  const Turns t{std::asin(m[2][1]), std::atan2(-m[0][1], m[1][1]), 0};
  const Matrix left = times(transposed(times(about_z(t.yaw), about_x(t.roll))), m);
  return {t.roll, t.yaw, std::atan2(left[0][2], left[0][0])};
}

using Six = std::array<double, 6>;
struct State {
  Six position, velocity;
};
/// Returns the place and motion of a wheelset in the order with the yaw outside; they come with the roll outside.
State yaw_outside(const State& given) {
  const double roll = given.position[3], yaw = given.position[4], h = 1e-4;
  const auto at = [&](double t) { return yaw_outside(roll + t * given.velocity[3], yaw + t * given.velocity[4]); };
  const Turns now = at(0), before = at(-h), after = at(h);
  State s = given;
  s.position[3] = now.roll;
  s.position[4] = now.yaw;
  s.velocity[3] = (after.roll - before.roll) / (2 * h);
  s.velocity[4] = (after.yaw - before.yaw) / (2 * h);
  s.velocity[5] += (after.pitch - before.pitch) / (2 * h);
  return s;
}

constexpr double y = 2, roll = -0.03, yaw = 0.04;
constexpr State given{{0, y, 0.1, roll, yaw, 0}, {2000, 3, 0, 0.02, -0.05, -4.3459}};

class order_of_turns : public wheels {
 protected:
  /// Returns a wheel under 10 kN, or at a height at which it carries about as much.
  std::unique_ptr<WheelRail> standing(std::int32_t side, bool roll_outside, How how) const {
    auto w = make(side);
    w->set_real("accuracy", 0.02);
    State s = roll_outside ? given : yaw_outside(given);
    w->set_int("roll_outside", roll_outside ? 1 : 0);
    w->set_velocity(s.velocity.data());
    w->set_position(s.position.data());
    w->prescribe_vertical(static_cast<std::int32_t>(How::by_force), 10000);
    EXPECT_EQ(w->solve(), Status::ok);
    if (how == How::by_force) return w;
    s.position[2] = std::round(1e4 * w->stat("z")) / 1e4;
    w->set_position(s.position.data());
    w->prescribe_vertical(static_cast<std::int32_t>(How::by_motion), 0);
    EXPECT_EQ(w->solve(), Status::ok);
    return w;
  }
};

}  // namespace

TEST_F(order_of_turns, matrices_say_where_the_profile_is) {
  for (const std::int32_t side : {-1, 1}) {
    const auto w = make(side);
    w->set_position(given.position.data());
    for (const std::int32_t outside : {1, 0}) {
      w->set_int("roll_outside", outside);
      w->solve();
      const Matrix m = outside == 1 ? times(about_x(roll), about_z(yaw)) : times(about_z(yaw), about_x(roll));
      const Vec3 own{0, side * (1360 / 2 + 70 + wheel->profile()->at(0).x[0]), 460 + wheel->profile()->at(0).x[1]};
      const Vec3 due = Vec3{0, y, 0.1 - 460} + times(m, own);
      const auto point = w->profile_point(1, 0);
      expect_error("y of the profile's end, mm", point[0] - due[1], 1e-11);
      expect_error("z of the profile's end, mm", point[1] - due[2], 1e-11);
    }
  }
}

TEST_F(order_of_turns, one_place_and_motion_has_one_answer) {
  for (const std::int32_t side : {-1, 1})
    for (const How how : {How::by_motion, How::by_force}) {
      const auto outside = standing(side, true, how), inside = standing(side, false, how);
      Vec3 f, m, f_in, m_in, f_set, m_set;
      outside->resultant(false, f.data(), m.data());
      inside->resultant(false, f_in.data(), m_in.data());
      outside->resultant(true, f_set.data(), m_set.data());
      expect_error("force over its size", length(f - f_in) / length(f), 1e-8);
      expect_error("moment over its size", length(m - m_in) / length(m), 1e-8);
      expect_error("height, mm", outside->stat("z") - inside->stat("z"), 1e-8);
      const Matrix back = transposed(times(about_x(roll), about_z(yaw)));
      expect_error("force in the wheelset's axes", length(f_set - times(back, f)) / length(f), 1e-14);
      expect_error("moment in the wheelset's axes", length(m_set - times(back, m)) / length(m), 1e-14);
      // The order matters here.
      const auto other = standing(side, true, how);
      other->set_int("roll_outside", 0);
      other->solve();
      other->resultant(false, f_in.data(), m_in.data());
      EXPECT_GT(length(f - f_in), 1e-3 * length(f));
    }
}

TEST_F(order_of_turns, lists_of_positions_keep_it) {
  const auto w = standing(1, true, How::by_force);
  double total[position_totals];
  std::int32_t status = -1;
  EXPECT_EQ(solve_positions(*w, {1, given.position.data(), given.velocity.data()}, total, &status), Status::ok);
  Vec3 f, m;
  w->resultant(false, f.data(), m.data());
  expect_error("force beside the single solve", length(f - Vec3{total[0], total[1], total[2]}) / length(f), 1e-6);
}

// The chain rule through the angles of the other order gives the derivatives.
TEST_F(order_of_turns, derivatives_follow_it) {
  const auto w = standing(-1, true, How::by_force), inside = standing(-1, false, How::by_force);
  for (const std::size_t entry : {3U, 4U, 9U, 10U}) {
    const double h = 1e-4;
    State side[2] = {given, given};
    for (std::size_t s = 0; s < 2; ++s) {
      (entry < 6 ? side[s].position : side[s].velocity)[entry % 6] += s == 0 ? -h : h;
      side[s] = yaw_outside(side[s]);
    }
    Vec3 due{};
    for (const std::size_t other : {3U, 4U, 9U, 10U, 11U}) {
      const auto of = [&](const State& s) { return (other < 6 ? s.position : s.velocity)[other % 6]; };
      due = due + (of(side[1]) - of(side[0])) / (2 * h) * inside->derivative(static_cast<std::int32_t>(other)).force;
    }
    const Vec3 own = w->derivative(static_cast<std::int32_t>(entry)).force;
    const std::string at = "entry " + std::to_string(entry);
    expect_error(at + ": force, over its size", length(own - due) / length(due), 1e-5);
    const Vec3 same = inside->derivative(static_cast<std::int32_t>(entry)).force;
    report(at + ": difference of the orders", length(own - same) / length(own));
  }
}

// The rigid wheelset does not yaw there.
TEST_F(order_of_turns, conicity_and_contact_points_are_those_of_either) {
  double conicity[2], roll_at[2];
  for (const std::int32_t on : {0, 1}) {
    const auto left = make(-1), right = make(1);
    left->set_int("roll_outside", on);
    right->set_int("roll_outside", on);
    WheelsetGeometry geometry(*left, *right);
    double wavelength = 0;
    conicity[on] = geometry.motion(3, wavelength).conicity;
    roll_at[on] = geometry.at(2, WheelsetGeometry::Height::axle).roll;
  }
  EXPECT_EQ(conicity[0], conicity[1]);
  EXPECT_EQ(roll_at[0], roll_at[1]);
}

TEST_F(order_of_turns, states_keep_it_and_other_values_are_refused) {
  const auto w = standing(1, true, How::by_motion);
  w->snapshot(0);
  const auto before = w->profile_point(1, 0);
  w->set_int("roll_outside", 0);
  EXPECT_EQ(w->profile_point(1, 0), before);  // results are those of the last solve
  w->rollback(0);
  w->solve();
  EXPECT_EQ(w->profile_point(1, 0), before);
  refused([&] { w->set_int("roll_outside", 2); }, Status::err_option, {"roll_outside", "0 to 1"});
}

}  // namespace rollcon
