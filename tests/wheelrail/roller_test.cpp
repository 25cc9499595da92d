/// Tests wheels on rollers: they become rails as their radius grows, have Hertz's contacts, and creep as both surfaces
/// move.

#include <cmath>
#include <numbers>

#include "framing/hertz.hpp"
#include "wheel_rail_fixture.hpp"

namespace rollcon {
namespace {

using Six = std::array<double, 6>;

class rollers : public wheels {
 protected:
  static constexpr double speed = 2000, rate = -4.3459;
  /// Makes S1002 on a roller with the profile 60E1; radius 0: on a rail.
  std::unique_ptr<WheelRail> make(double radius, std::int32_t side = 1) const {
    auto w = std::make_unique<WheelRail>(context, wheel, rail, side);
    w->set_track(1435, 14, 0);
    w->set_wheelset(1360, -70, 460);
    w->set_friction(mu);
    w->set_real("accuracy", 0.02);
    w->prescribe_vertical(2, 10000);
    w->set_roller(radius, radius > 0 ? speed / radius : 0);
    const Six velocity{radius > 0 ? 0 : speed, 0, 0, 0, 0, rate};
    w->set_velocity(velocity.data());
    return w;
  }
  static std::vector<double> results(WheelRail& w, double y, double yaw, double x = 0) {
    const Six position{x, y, 0, 0, yaw, 0};
    w.set_position(position.data());
    EXPECT_EQ(w.solve(), Status::ok);
    std::vector<double> r(6);
    w.resultant(false, r.data(), r.data() + 3);
    for (double& force : r) force /= 10000;
    for (std::size_t i = 3; i < 6; ++i) r[i] /= 460;
    r.push_back(w.stat("friction_power") / 1e5);
    for (const char* name : {"x", "y", "z", "longitudinal_creepage", "lateral_creepage", "spin", "angle"})
      r.push_back(w.patch_stat(0, name));
    r.push_back(w.stat("z"));
    return r;
  }
  static double farthest(const std::vector<double>& a, const std::vector<double>& b) {
    double off = 0;
    for (std::size_t i = 0; i < a.size(); ++i) off = std::max(off, std::abs(a[i] - b[i]));
    return off;
  }
};

// Results change as one over the radius, which is extrapolated from two.
TEST_F(rollers, a_roller_without_end_is_a_rail) {
  for (const auto& [y, yaw] : {std::pair{1.0, 2.4e-3}, {-2.0, -4e-3}, {3.0, 0.0}}) {
    const auto straight = results(*make(0), y, yaw), near = results(*make(1e6), y, yaw);
    auto far = results(*make(2e6), y, yaw);
    const double first = farthest(near, straight);
    for (std::size_t i = 0; i < far.size(); ++i) far[i] += far[i] - near[i];
    expect_error("a radius of 1 km, beside a rail", first, 2e-3);
    EXPECT_GT(first, 1e-6) << "the radius does not show";
    expect_error("radius without end, y = " + std::to_string(y), farthest(far, straight), 1e-6);
  }
}

// A cylinder on a barrel, both turned about parallel axes: Hertz's ellipse of these curvatures.
TEST_F(rollers, a_cylinder_on_a_barrel_is_hertzian) {
  const double flat[2] = {20, 0}, crown[2] = {-300, 25}, radius = 460;
  wheel->set_profile_shape("line", 2, flat);
  rail->set_profile_shape("arc", 2, crown);
  for (const double roller : {150.0, 500.0, 2000.0}) {
    WheelRail w(context, wheel, rail, 1);
    w.set_track(1500, 0, 0);
    w.set_wheelset(1500, 0, radius);
    w.set_friction(0.3);
    w.set_roller(roller, speed / roller);
    const Six position{0, 0, 0, 0, 0, 0}, velocity{0, 0, 0, 0, 0, -speed / radius};
    w.set_position(position.data());
    w.set_velocity(velocity.data());
    w.prescribe_vertical(2, 20000);
    EXPECT_EQ(w.solve(), Status::ok);
    ASSERT_EQ(w.patches(), 1);
    const double modulus = 2 * 82000 * 1.28 / (2 * (1 - 0.28 * 0.28));
    const HertzContact h = hertz_by_load({0.5 * (1 / radius + 1 / roller), 0.5 / 300, 0}, modulus, 20000);
    const std::string name = "roller of " + std::to_string(roller) + ": ";
    expect_error(name + "approach", w.stat("z") / h.approach - 1, 2e-3);
    expect_error(name + "largest pressure", w.patch_stat(0, "max_pressure") / h.pressure - 1, 5e-3);
    expect_error(name + "area", w.patch_stat(0, "area") / (std::numbers::pi * h.larger * h.smaller) - 1, 1e-2);
    expect_error(name + "creepage of equal speeds", w.patch_stat(0, "longitudinal_creepage"), 1e-12);
    Vec3 force{};
    w.resultant(false, force.data(), nullptr);
    expect_error(name + "longitudinal force over that of friction", force[0] / (0.3 * 20000), 0.05);
    const double rolling = force[0];
    // A wheel that is braked by 1 per mille is pushed back by what it runs on.
    const Six braked{0, 0, 0, 0, 0, -0.999 * speed / radius};
    w.set_velocity(braked.data());
    EXPECT_EQ(w.solve(), Status::ok);
    expect_error(name + "creepage of a braked wheel", w.patch_stat(0, "longitudinal_creepage") / 1e-3 - 1, 2e-3);
    w.resultant(false, force.data(), nullptr);
    EXPECT_LT(force[0], rolling - 0.3 * 0.3 * 20000);
  }
}

// Ahead of the axis the wheel touches where both axes and the contact are in one plane, and rolls down.
TEST_F(rollers, a_wheel_may_stand_beside_the_top) {
  const double flat[2] = {20, 0}, crown[2] = {-300, 25}, radius = 460, roller = 500, x = 20;
  wheel->set_profile_shape("line", 2, flat);
  rail->set_profile_shape("arc", 2, crown);
  WheelRail w(context, wheel, rail, 1);
  w.set_track(1500, 0, 0);
  w.set_wheelset(1500, 0, radius);
  w.set_friction(0);
  w.set_roller(roller, speed / roller);
  const Six position{x, 0, 0, 0, 0, 0}, velocity{0, 0, 0, 0, 0, -speed / radius};
  w.set_position(position.data());
  w.set_velocity(velocity.data());
  w.prescribe_vertical(2, 20000);
  EXPECT_EQ(w.solve(), Status::ok);
  Vec3 force{};
  w.resultant(false, force.data(), nullptr);
  const double lean = std::asin(x / (radius + roller));
  expect_error("x of the contact, mm", w.patch_stat(0, "x") - roller * std::sin(lean), 1e-3);
  expect_error("direction of the force", force[0] / -force[2] - std::tan(lean), 1e-5);
  const auto ahead = w.derivative(0);
  const double step = 0.1;
  double by[2];
  for (const int s : {0, 1}) {
    const Six moved{x + (s == 0 ? -step : step), 0, 0, 0, 0, 0};
    w.set_position(moved.data());
    EXPECT_EQ(w.solve(), Status::ok);
    w.resultant(false, force.data(), nullptr);
    by[s] = force[0];
  }
  expect_error("derivative by x", ahead.force[0] / ((by[1] - by[0]) / (2 * step)) - 1, 1e-4);
}

TEST_F(rollers, the_left_is_the_mirror_of_the_right_and_states_come_back) {
  const auto right = make(500), left = make(500, -1);
  auto a = results(*right, 1.5, 2e-3);
  const auto b = results(*left, -1.5, -2e-3);
  for (const std::size_t i : {1U, 3U, 5U, 8U, 11U, 12U, 13U}) a[i] = -a[i];
  expect_error("left beside right", farthest(a, b), 1e-12);
  const auto copied = right->copy();
  right->snapshot(0);
  const auto first = results(*right, 2.5, 1e-3);
  right->rollback(0);
  expect_error("after rollback", farthest(first, results(*right, 2.5, 1e-3)), 0);
  expect_error("in a copy", farthest(first, results(*copied, 2.5, 1e-3)), 0);
}

// A rail again, after it was a roller.
TEST_F(rollers, may_be_rails_again) {
  const auto fresh = make(0), was = make(500);
  results(*was, 1, 1e-3);
  was->set_roller(0, 0);
  const Six velocity{speed, 0, 0, 0, 0, rate};
  was->set_velocity(velocity.data());
  expect_error("a rail that was a roller", farthest(results(*fresh, 1, 1e-3), results(*was, 1, 1e-3)), 1e-6);
}

TEST_F(rollers, refuse_what_makes_no_sense) {
  const auto w = make(500);
  refused([&] { w->set_roller(-1, 1); }, Status::err_argument, {"radius is -1", "> 0, or 0: a rail"});
  refused([&] { w->set_roller(20, 1); }, Status::err_argument,
          {"radius of the roller is 20", "how deep its profile is"});
  refused([&] { w->set_roller(500, NAN); }, Status::err_nonfinite, {"rate"});
  refused([&] { w->set_track(1435, 14, 0.025); }, Status::err_argument,
          {"cant is 0.025 beside a roller", "allowed: 0"});
  const Six there{0, 0, 0, 0, 0, 0};
  w->set_position(there.data());
  EXPECT_EQ(w->solve(), Status::ok) << "what was refused left something behind";
  w->set_roller(500, 0);
  refused([&] { w->solve(); }, Status::err_argument, {"the speed along the roller", "is 0"});
  w->set_roller(500, -4);
  refused([&] { w->solve(); }, Status::err_argument, {"run backwards"});
  w->set_roller(500, 4);
  w->set_int("conformal", 1);
  refused([&] { w->solve(); }, Status::err_unsupported, {"the rail is a roller", "conformal"});
}

}  // namespace
}  // namespace rollcon
