/// Tests steps in time of a wheel on its rail: shift against Cattaneo, rolling to the steady state, patches that hand
/// on what they carry, and pasts that are saved and restored.

#include <cmath>

#include "contact/contact.hpp"
#include "wheel_rail_fixture.hpp"
#include "wheelrail/solve_positions.hpp"

namespace rollcon {
namespace {

using Six = std::array<double, 6>;

class wheel_steps : public wheels {
 protected:
  static constexpr double load = 10000, rate = -4.3459, speed = 2000;

  std::unique_ptr<WheelRail> make(std::int32_t side = 1) const {
    auto w = wheels::make(side);
    w->set_real("accuracy", 0.02);
    w->prescribe_vertical(2, load);
    return w;
  }
  static Vec3 force_of(const WheelRail& w) {
    Vec3 f{};
    w.resultant(false, f.data(), nullptr);
    return f;
  }
  /// Makes a step that rolls by a way, at this y; returns forces, moments, height and power.
  static std::vector<double> roll(WheelRail& w, double y, double way, double slower = 0) {
    w.set_step(1, way / speed);
    place(w, y);
    const Six velocity{speed, 0, 0, 0, 0, rate * (1 - slower)};
    w.set_velocity(velocity.data());
    const Status status = w.solve();
    EXPECT_TRUE(status == Status::ok || status == Status::inaccurate) << static_cast<int>(status);
    std::vector<double> r(6);
    w.resultant(false, r.data(), r.data() + 3);
    r.push_back(w.stat("z"));
    r.push_back(w.stat("friction_power"));
    return r;
  }
  static double farthest(const std::vector<double>& a, const std::vector<double>& b) {
    double off = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
      off = std::max(off, std::abs(a[i] - b[i]) / std::max(std::abs(b[i]), 1.0));
    return off;
  }
};

// A ball is pressed on a plane and then shifted, at no speed, along and across.
TEST_F(wheel_steps, cattaneo) {
  const double radius = 460, ball[2] = {radius, 25}, plane[2] = {40, 0};
  wheel->set_profile_shape("arc", 2, ball);
  rail->set_profile_shape("line", 2, plane);
  for (const std::size_t along : {0U, 1U}) {
    WheelRail w(context, wheel, rail, 1);
    w.set_track(1500, 0, 0);
    w.set_wheelset(1500, 0, radius);
    w.set_friction(mu);
    w.set_real("accuracy", 0.005);
    w.prescribe_vertical(2, load);
    w.set_step(2, 1);
    const Six there{0, 0, 0, 0, 0, 0};
    w.set_position(there.data());
    w.set_velocity(there.data());
    ASSERT_EQ(w.solve(), Status::ok);
    expect_error("force along a contact that is pressed, over friction's", force_of(w)[along] / (mu * load), 1e-3);
    const double a = std::sqrt(w.patch_stat(0, "area") / std::acos(-1.0));
    const double whole = 3 * mu * load / (16 * a) * 2 * (2 - 0.28) / 82000, wanted = 0.875;
    Six shift{};
    shift[along] = whole * (1 - std::pow(1 - wanted, 2.0 / 3));
    w.set_velocity(shift.data());
    ASSERT_EQ(w.solve(), Status::ok);
    expect_error("force of Cattaneo's shift, over friction's", force_of(w)[along] / (mu * load) + wanted, 5e-3);
    const double stuck = w.contact(0)->stat("stick_area") / w.patch_stat(0, "area");
    expect_error("area that sticks, over the whole", stuck - 0.25, 0.01);
    expect_error("shift as creepage",
                 w.patch_stat(0, along == 0 ? "longitudinal_creepage" : "lateral_creepage") / shift[along] - 1, 1e-3);
    EXPECT_EQ(w.stat("steps"), 2);
  }
}

TEST_F(wheel_steps, end_in_steady_rolling) {
  const auto w = make(), steady = make();
  for (const double slower : {5e-4, 2e-3}) {
    w->reset();
    steady->set_step(0, 0);
    place(*steady, 1);
    const Six velocity{speed, 0, 0, 0, 0, rate * (1 - slower)};
    steady->set_velocity(velocity.data());
    ASSERT_EQ(steady->solve(), Status::ok);
    const Vec3 limit = force_of(*steady);
    double first = 0;
    for (int i = 0; i < 40; ++i) {
      roll(*w, 1, 0.8, slower);
      if (i == 0) first = length(force_of(*w) - limit) / (mu * load);
    }
    EXPECT_GT(first, 0.05) << "nothing is transient";
    expect_error("steps from rest end in the steady forces, over friction's",
                 length(force_of(*w) - limit) / (mu * load), 0.02);
    const auto last = force_of(*w);
    roll(*w, 1, 0.8, slower);
    expect_error("the next step changes nothing", length(force_of(*w) - last) / (mu * load), 1e-6);
    // Steps from the steady state stay there.
    roll(*steady, 1, 0.8, slower);
    expect_error("a step from the steady state stays there", length(force_of(*steady) - limit) / (mu * load), 0.02);
  }
}

// Steps end in a state whose difference from the steady solution on their own grid is of second order in their length.
TEST_F(wheel_steps, end_in_the_steady_state_of_their_grid) {
  std::vector<double> off;
  for (const double way : {0.4, 0.2}) {
    const auto w = make();
    for (int i = 0; i < std::lround(12 / way); ++i) roll(*w, 1, way, 2e-3);
    Contact& grid = *w->contact(0);
    Vec3 of_steps{}, steady{};
    grid.resultant(InAxes::local, of_steps.data(), nullptr);
    grid.scene.set_step(0, 0);
    EXPECT_EQ(grid.solve(), Status::ok);
    grid.resultant(InAxes::local, steady.data(), nullptr);
    off.push_back(length(of_steps - steady) / (mu * load));
  }
  expect_error("steps of 0.4 mm beside the steady state of their grid, over friction's", off[0], 4e-3);
  expect_error("steps of 0.2 mm", off[1], off[0] / 2.5);
}

// Steps that are half as long find nearly the same forces, also where patches part or merge.
TEST_F(wheel_steps, patches_that_part_and_merge_hand_their_past_on) {
  for (const auto& [from, to] : {std::pair{4.6, 5.6}, {5.6, 4.6}}) {
    const auto w = make(), finer = make();
    constexpr int steps = 10;
    double off = 0;
    std::int64_t least = 100, most = 0;
    for (int i = 0; i <= steps; ++i) {
      const double y = from + (to - from) * i / steps, half = from + (to - from) * (i - 0.5) / steps;
      if (i > 0) roll(*finer, half, 0.5, 1e-3);
      const auto r = roll(*w, y, 1, 1e-3), s = roll(*finer, y, 0.5, 1e-3);
      least = std::min(least, w->patches());
      most = std::max(most, w->patches());
      for (std::size_t k = 0; k < 3 && i > 2; ++k) off = std::max(off, std::abs(r[k] - s[k]) / (mu * load));
    }
    EXPECT_GT(most, least) << "nothing parts or merges here";
    expect_error("forces beside those of steps half as long, over friction's", off, 0.03);
  }
}

TEST_F(wheel_steps, are_saved_and_restored) {
  const auto w = make();
  for (int i = 0; i < 2; ++i) roll(*w, 1 + 0.1 * i, 0.5, 1e-3);
  const std::vector<double> past = w->past_numbers();
  w->snapshot(0);
  const auto copied = w->copy();
  std::vector<std::vector<double>> due;
  for (int i = 2; i < 4; ++i) due.push_back(roll(*w, 1 + 0.1 * i, 0.5, 1e-3));
  EXPECT_EQ(w->stat("steps"), 4);
  expect_error("time", w->stat("step_time") - 4 * 0.5 / speed, 1e-15);
  const auto again = [&](const std::string& name, WheelRail& other, double bound = 0) {
    for (int i = 2; i < 4; ++i)
      expect_error(name, farthest(roll(other, 1 + 0.1 * i, 0.5, 1e-3), due[static_cast<std::size_t>(i - 2)]), bound);
  };
  w->rollback(0);
  again("after rollback", *w);
  again("in a copy", *copied);
  const auto fresh = make();
  fresh->past_set(std::ssize(past), past.data());
  // Where lines met the surfaces before changes their last digits.
  again("from saved numbers", *fresh, 1e-10);
  fresh->repeat_step();
  expect_error("repeated", farthest(roll(*fresh, 1.3, 0.5, 1e-3), due[1]), 1e-10);
  auto broken = past;
  broken[20] += 1e-9;
  refused([&] { fresh->past_set(std::ssize(broken), broken.data()); }, Status::err_argument, {"past has changed"});
  refused([&] { make(-1)->past_set(std::ssize(past), past.data()); }, Status::err_argument, {"the other side"});
  refused([&] { make()->past_numbers(); }, Status::err_state, {"no time step was solved yet"});
}

TEST_F(wheel_steps, that_fail_leave_the_one_before) {
  const auto w = make(), other = make();
  for (WheelRail* each : {w.get(), other.get()}) roll(*each, 1, 0.5, 1e-3);
  const double gone[6] = {0, 0, 300, 0, 0, 0};
  w->prescribe_vertical(1, 0);
  w->set_position(gone);
  refused([&] { w->solve(); }, Status::err_argument, {"overlap by"});
  refused([&] { w->repeat_step(); }, Status::err_state, {"there is no step to repeat"});
  w->prescribe_vertical(2, load);
  expect_error("after a step that failed", farthest(roll(*w, 1.1, 0.5, 1e-3), roll(*other, 1.1, 0.5, 1e-3)), 0);
  EXPECT_EQ(w->stat("steps"), 2);
  double totals[9];
  std::int32_t status = 0;
  const Six position{0, 1, 0, 0, 0, 0}, velocity{speed, 0, 0, 0, 0, rate};
  refused(
      [&] {
        solve_positions(*w, {1, position.data(), velocity.data()}, totals, &status);
      },
      Status::err_unsupported, {"positions of a list are steady"});
  refused([&] { w->set_step(1, 0); }, Status::err_argument, {"dt is 0", "> 0"});
  refused([&] { w->set_step(3, 1); }, Status::err_argument, {"kind is 3"});
  w->set_int("conformal", 1);
  refused([&] { w->solve(); }, Status::err_unsupported, {"a step in time", "conformal"});
}

TEST_F(wheel_steps, on_the_left_are_the_mirror_of_those_on_the_right) {
  const auto right = make(), left = make(-1);
  for (int i = 0; i < 3; ++i) {
    auto a = roll(*right, 1 + 0.2 * i, 0.5, 1e-3);
    const auto b = roll(*left, -1 - 0.2 * i, 0.5, 1e-3);
    for (const std::size_t k : {1U, 3U, 5U}) a[k] = -a[k];
    expect_error("left beside right", farthest(a, b), 1e-9);
  }
}

}  // namespace
}  // namespace rollcon
