/// Tests rigid wheelsets on rigid rails: points of contact, rolling-radius difference, equivalent conicity.

#include "wheelrail/wheelset_geometry.hpp"

#include <numbers>

#include "wheel_rail_fixture.hpp"

using namespace rollcon;

namespace {

constexpr double pi = std::numbers::pi;

/// Computes Klingel's wavelength with unit e r, by steps of Runge and Kutta from one turning point to the other.
double half_period(const std::function<double(double)>& difference, double low, double high) {
  const double step = 0.02;
  double y = high, v = 0, t = 0;
  for (;;) {
    const double k1v = -difference(y), k1y = v, k2v = -difference(y + step / 2 * k1y), k2y = v + step / 2 * k1v,
                 k3v = -difference(y + step / 2 * k2y), k3y = v + step / 2 * k2v, k4v = -difference(y + step * k3y),
                 k4y = v + step * k3v;
    const double next_v = v + step / 6 * (k1v + 2 * k2v + 2 * k3v + k4v);
    if (y < 0.5 * (low + high) && next_v >= 0) return t + step * v / (v - next_v);
    y += step / 6 * (k1y + 2 * k2y + 2 * k3y + k4y);
    v = next_v;
    t += step;
  }
}

class wheelset_geometry : public wheels {
 protected:
  using Height = WheelsetGeometry::Height;

  WheelsetGeometry standing() {
    left = make(-1);
    right = make(1);
    return {*left, *right};
  }
  std::unique_ptr<WheelRail> left, right;
};

}  // namespace

TEST(kinematic_motion, springs_of_known_period) {
  expect_error("cone 1:20", kinematic_motion([](double y) { return 0.1 * y; }, 3).conicity / 0.05 - 1, 1e-14);
  // The two cones, steeper on one side, have half a period of each.
  const double flat = 0.04, steep = 0.3;
  const auto two = kinematic_motion([&](double y) { return 2 * (y < 0 ? flat : steep) * y; }, 3);
  const double half = pi / 2 * (1 / std::sqrt(2 * flat) + 1 / std::sqrt(2 * steep));
  expect_error("cones of two slopes", two.conicity / (pi * pi / (2 * half * half)) - 1, 1e-12);
  expect_error("their turning points", two.high * std::sqrt(steep) + two.low * std::sqrt(flat), 1e-12);
  // The motion y'' = -y^3 has a quarter of the period of 1.31102877714606 / amplitude.
  const auto cubic = kinematic_motion([](double y) { return y * y * y; }, 2);
  const double quarter = 1.31102877714606 / 2 * std::sqrt(2.0);
  expect_error("cubic", cubic.conicity / (pi * pi / (8 * quarter * quarter)) - 1, 2.5e-5);
  // A jump of the difference gives parabolas, y = a - d t^2 / 2.
  const auto jump = kinematic_motion([](double y) { return y < 0.1 ? -0.2 : 0.2; }, 3);
  expect_error("jump", jump.conicity / (pi * pi / (8 * 2 * 3 / 0.2)) - 1, 1e-13);
  expect_error("where it jumps", jump.middle - 0.1, 1e-13);
}

TEST(kinematic_motion, what_does_not_come_back_is_refused) {
  const auto told = [](const std::function<double(double)>& difference) {
    try {
      kinematic_motion(difference, 3);
    } catch (const Error& e) {
      EXPECT_EQ(e.status(), Status::err_argument);
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_NE(told([](double y) { return -0.1 * y; }).find("amplitude is 3"), std::string::npos);
  EXPECT_NE(told([](double) { return 0.5; }).find("never runs straight on"), std::string::npos);
}

// A cone's slope g on rails of radius R, with c half the distance of the points of contact, gives 2 g y (1 + R g / c),
// because the roll -g y / c of the wheelset moves the contact on round heads.
TEST_F(wheelset_geometry, cones_have_their_angle) {
  constexpr double slope = 0.05;
  const double cone[4] = {-60, 60 * slope, 80, -80 * slope};
  wheel->set_profile(2, cone, 0);
  const auto set = [&](std::int32_t side, double head) {
    auto w = std::make_unique<WheelRail>(context, wheel, rail, side);
    w->set_track(1500, 0.01 * head, 0);
    w->set_wheelset(1360, -70, 460);
    return w;
  };
  for (const double head : {5.0, 300.0}) {
    const double arc[2] = {-head, 0.99 * head};
    rail->set_profile_shape("arc", 2, arc);
    const auto l = set(-1, head), r = set(1, head);
    WheelsetGeometry geometry(*l, *r);
    const auto middle = geometry.at(0, Height::rails);
    const double base = middle.touch[1].y - middle.touch[0].y, radius = middle.touch[1].rolling_radius;
    const double due = slope * (1 + 2 * head * slope / base);
    for (const double amplitude : {0.1, 3.0}) {
      double wavelength = 0;
      const KinematicMotion motion = geometry.motion(amplitude, wavelength);
      const std::string at = "rail head " + std::to_string(head) + ", amplitude " + std::to_string(amplitude);
      expect_error(at + ": conicity over the cone's", motion.conicity / slope - 1, head < 10 ? 5e-4 : 0.025);
      expect_error(at + ": with the rails' radius", motion.conicity / due - 1, 2e-4);
      expect_error(at + ": Klingel's wavelength", wavelength / (2 * pi * std::sqrt(radius * base / (2 * due))) - 1,
                   1e-4);
      expect_error(at + ": middle", motion.middle, 1e-13);
    }
  }
}

// The conicity is often quoted as 0.18.
TEST_F(wheelset_geometry, s1002_on_60e1) {
  WheelsetGeometry geometry = standing();
  double wavelength = 0;
  const KinematicMotion motion = geometry.motion(3, wavelength);
  report("S1002 on 60E1, 1435, 1:40: conicity at 3 mm", motion.conicity);
  report("wavelength, m", 1e-3 * wavelength);
  expect_error("beside 0.18", motion.conicity - 0.18, 2e-3);
  const double half =
      half_period([&](double y) { return geometry.at(y, Height::rails).difference(); }, motion.low, motion.high);
  expect_error("beside the motion in small steps", motion.conicity * 2 * half * half / (pi * pi) - 1, 2e-4);
}

TEST_F(wheelset_geometry, wheels_touch_where_they_begin_to_overlap) {
  WheelsetGeometry geometry = standing();
  for (const double y : {-4.0, -0.3, 1.0, 2.5, 6.0}) {
    const auto stand = geometry.at(y, Height::axle);
    expect_error("heights of both wheels", stand.touch[0].height - stand.touch[1].height, 3e-13);
    for (std::size_t i = 0; i < 2; ++i) {
      WheelRail& w = i == 0 ? *left : *right;
      const double sunk = 1e-5, position[6] = {0, stand.y, stand.z + sunk, stand.roll, 0, 0};
      w.set_position(position);
      w.solve();
      ASSERT_EQ(w.patches(), 1);
      const WheelRail::Touch& touch = stand.touch[i];
      const std::string at = (i == 0 ? "left, y " : "right, y ") + std::to_string(y);
      expect_error(at + ": overlap, mm", w.patch_stat(0, "overlap") - sunk * std::cos(touch.angle), 5e-12);
      expect_error(at + ": y, mm", w.patch_stat(0, "y") - touch.y, 7e-4);
      expect_error(at + ": angle", w.patch_stat(0, "angle") - touch.angle, 4e-6);
      expect_error(at + ": rolling radius, mm", w.patch_stat(0, "rolling_radius") - touch.rolling_radius, 2e-5);
      expect_error(at + ": y of the wheel, mm", w.patch_stat(0, "wheel_y") - touch.wheel_y, 7e-4);
    }
  }
}

// One axle carries both wheels, so the one on the left has to come down by the difference.
TEST_F(wheelset_geometry, radii_may_differ) {
  left = make(-1);
  right = make(1);
  left->set_wheelset(1360, -70, 459);
  WheelsetGeometry geometry(*left, *right);
  for (const double y : {-2.0, 1.0}) {
    const auto stand = geometry.at(y, Height::axle);
    EXPECT_LT(stand.roll, -4e-4) << "down on the left";
    for (WheelRail* w : {left.get(), right.get()}) {
      const double sunk = 1e-5, axle = stand.z - 459.5,
                   position[6] = {0, y, axle + w->radius() + sunk, stand.roll, 0, 0};
      w->set_position(position);
      w->solve();
      ASSERT_EQ(w->patches(), 1);
      expect_error("y " + std::to_string(y) + ": overlap, mm",
                   w->patch_stat(0, "overlap") - sunk * std::cos(w->patch_stat(0, "angle")), 5e-12);
    }
  }
}

TEST_F(wheelset_geometry, a_shifted_track_shifts_all) {
  WheelsetGeometry geometry = standing();
  double nominal = 0, moved = 0;
  const KinematicMotion before = geometry.motion(2, nominal);
  const double deviation[3] = {1.25, 0.5, 0}, rate[3] = {0, 0, 0};
  left->set_rail_deviation(deviation, rate);
  right->set_rail_deviation(deviation, rate);
  const KinematicMotion after = geometry.motion(2, moved);
  expect_error("conicity on a shifted track", after.conicity / before.conicity - 1, 1e-12);
  expect_error("middle", after.middle - 1.25, 1e-12);
  // A rail turned about its gauge point by a little is another one.
  const double turned[3] = {0, 0, 1e-3};
  left->set_rail_deviation(rate, rate);
  right->set_rail_deviation(turned, rate);
  const auto stand = geometry.at(0, Height::axle);
  expect_error("heights on a turned rail", stand.touch[0].height - stand.touch[1].height, 3e-13);
}

TEST_F(wheelset_geometry, bad_input_is_refused) {
  WheelsetGeometry geometry = standing();
  double wavelength = 0;
  refused([&] { geometry.at(150, Height::axle); }, Status::err_argument, {"the shift is 150"});
  refused([&] { geometry.motion(-1, wavelength); }, Status::err_argument, {"amplitude is -1"});
  refused([&] { geometry.motion(200, wavelength); }, Status::err_argument, {"no roll brings both wheels"});
  refused([&] { WheelsetGeometry(*right, *right); }, Status::err_argument, {"left is a wheel on the right"});
  refused([&] { WheelsetGeometry(*left, *left); }, Status::err_argument, {"right is a wheel on the left"});
  WheelRail bare(context, wheel, rail, 1);
  refused([&] { WheelsetGeometry(*left, bare); }, Status::err_state, {"rollcon_wheelrail_set_track"});
}
