/// Tests the ellipses that stand for patches: their linear theory is that of the patch (docs/wheelrail.md).

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "framing/hertz.hpp"
#include "support/frames.hpp"
#include "wheel_rail_fixture.hpp"
#include "wheelrail/solve_positions.hpp"

namespace rollcon {
namespace {

class calibrated : public wheels {
 protected:
  static constexpr double load = 1e5, speed = 2000, shear = 82000, poisson = 0.28;
  std::shared_ptr<const ForceTable> table{ForceTable::standard(context)};

  std::unique_ptr<WheelRail> make_by_table(bool hertzian = true) const {
    auto w = make();
    w->set_table(table);
    w->set_int("hertzian", hertzian ? 1 : 0);
    w->set_real("accuracy", 0.01);
    return w;
  }
  /// Solves with creepages on top of those of a wheel that rolls on its nominal radius.
  static std::array<double, 3> forces(WheelRail& w, double longitudinal, double lateral, double forward = speed) {
    const double velocity[6] = {forward, lateral * forward, 0, 0, 0, -forward / 460 * (1 - longitudinal)};
    w.set_velocity(velocity);
    EXPECT_EQ(w.solve(), Status::ok);
    return {w.patch_stat(0, "longitudinal_force"), w.patch_stat(0, "lateral_force"), w.patch_stat(0, "spin_moment")};
  }
  /// Puts wheels at the height that the first of them has under the load.
  static double put(std::initializer_list<WheelRail*> all, double y) {
    WheelRail& first = **all.begin();
    first.prescribe_vertical(2, load);
    const double position[6] = {0, y, 0, 0, 0, 0};
    first.set_position(position);
    forces(first, 0, 0);
    const double z = first.stat("z");
    for (WheelRail* w : all) {
      const double found[6] = {0, y, z, 0, 0, 0};
      w->prescribe_vertical(1, 0);
      w->set_position(found);
    }
    return z;
  }
  /// Returns the change of longitudinal creepage at which no force acts along the rail.
  static double free_creepage(WheelRail& w) {
    double at = 0;
    for (int i = 0; i < 4; ++i) {
      const double step = 1e-5, f = forces(w, at, 0)[0];
      at -= f * step / (forces(w, at + step, 0)[0] - f);
    }
    return at;
  }
};

// Round profiles have contacts of Hertz, for which the table is asked directly. Friction is high: what strips have more
// or less than the table in natural rolling counts by its inverse.
TEST_F(calibrated, round_profiles_have_the_tables_forces) {
  constexpr double rough = 3;
  for (const double radius : {5000.0, 1500.0, 460.0, 120.0, 45.0}) {
    const double head[] = {-radius, 0.99 * radius}, line[] = {80, 0}, at = 1e3;
    rail->set_profile_shape("arc", 2, head);
    wheel->set_profile_shape("line", 2, line);
    WheelRail w(context, wheel, rail, 1);
    w.set_track(1584, 0, 0);
    w.set_wheelset(1360, -100, 460);
    w.set_friction(rough);
    w.set_table(table);
    w.set_int("hertzian", 1);
    w.prescribe_vertical(2, at);
    place(w, 0);
    const double modulus = shear / (1 - poisson);
    const HertzContact hertz = hertz_by_load({0.5 / 460, 0.5 / radius, 0}, modulus, at);
    const double a = radius > 460 ? hertz.smaller : hertz.larger, b = radius > 460 ? hertz.larger : hertz.smaller;
    const double unit = rough * at / (shear * a * b);
    const double free = free_creepage(w);
    for (const auto& [along, across] : {std::pair{0.05, 0.0}, {0.0, 0.05}, {0.2, -0.1}, {-0.5, 0.8}}) {
      const std::array<double, 3> found = forces(w, free + along * unit, across * unit);
      const double input[table_inputs] = {shear, poisson, rough, a, b, at, along * unit, across * unit, 0};
      double expected[3];
      table->evaluate(1, input, expected, nullptr);
      EXPECT_EQ(w.patch_stat(0, "hertzian"), 1);
      expect_error("force, a/b = " + std::to_string(a / b) + ", r about " + std::to_string(along),
                   std::hypot(found[0] - expected[0], found[1] - expected[1]) / std::hypot(expected[0], expected[1]),
                   5e-3);
    }
  }
}

// Friction is so high that all of the patch sticks. Strips of accuracy 0.005 have up to 1 % less themselves.
TEST_F(calibrated, small_creepages_have_the_linear_theory_of_the_patch) {
  auto full = make(), fast = make_by_table();
  full->set_real("accuracy", 0.005);
  for (WheelRail* w : {full.get(), fast.get()}) w->set_friction(10);
  for (const double y : {-1.0, 0.0, 1.0, 2.0}) {
    put({full.get(), fast.get()}, y);
    const double step = 1e-5;
    for (const bool lateral : {false, true}) {
      std::array<double, 3> slope[2];
      for (const int s : {0, 1}) {
        WheelRail& w = s == 0 ? *full : *fast;
        const auto before = lateral ? forces(w, 0, -step) : forces(w, -step, 0),
                   behind = lateral ? forces(w, 0, step) : forces(w, step, 0);
        for (std::size_t i = 0; i < 3; ++i) slope[s][i] = (behind[i] - before[i]) / (2 * step);
      }
      const double unit = std::hypot(slope[0][0], slope[0][1]), arm = std::sqrt(full->patch_stat(0, "area") / 3.14);
      const std::string at = std::string("slopes by ") + (lateral ? "lateral" : "longitudinal") + " creepage, y " +
                             std::to_string(y) + ": ";
      expect_error(at + "forces", std::hypot(slope[1][0] - slope[0][0], slope[1][1] - slope[0][1]) / unit, 0.015);
      expect_error(at + "moment", (slope[1][2] - slope[0][2]) / (unit * arm), 0.02);
    }
  }
}

TEST_F(calibrated, wheels_roll_freely_where_full_solutions_do) {
  auto full = make(), fast = make_by_table(), pressed = make_by_table(false);
  full->set_real("accuracy", 0.005);
  for (const double y : {0.5, 1.0, 2.0}) {
    put({full.get(), fast.get(), pressed.get()}, y);
    const double expected = free_creepage(*full);
    for (WheelRail* w : {fast.get(), pressed.get()})
      expect_error("radius of free rolling, micrometres, y " + std::to_string(y),
                   460e3 * (free_creepage(*w) - expected), 3);
  }
}

TEST_F(calibrated, forces_are_those_of_full_solutions_at_all_creepages) {
  auto full = make(), fast = make_by_table();
  full->set_real("accuracy", 0.005);
  for (const double y : {-2.0, 0.0, 1.0, 3.0}) {
    put({full.get(), fast.get()}, y);
    const double area = full->patch_stat(0, "area"), unit = 3 * mu * load / (4 * shear * area),
                 free = free_creepage(*full);
    for (const double r : {0.1, 0.4, 1.0, 3.0})
      for (int k = 0; k < 4; ++k) {
        const double turn = 0.4 + k * std::numbers::pi / 2, along = free + r * unit * std::cos(turn),
                     across = r * unit * std::sin(turn);
        const std::array<double, 3> f = forces(*full, along, across), g = forces(*fast, along, across);
        expect_error("r " + std::to_string(r) + ", y " + std::to_string(y),
                     std::hypot(f[0] - g[0], f[1] - g[1]) / (mu * load),
                     r == 0.1   ? 0.005
                     : r == 1.0 ? 0.03
                                : 0.02);
      }
  }
}

TEST_F(calibrated, forces_are_within_friction_and_end_at_it) {
  auto w = make_by_table();
  w->prescribe_vertical(2, load);
  frames::Random random(11);
  double worst = 0, least = 1;
  for (int n = 0; n < 300; ++n) {
    const double friction = random.between(0.05, 0.6), r = std::pow(10, random.between(-2, 1.5));
    w->set_friction(friction);
    const double position[6] = {0, random.between(-4, 4), 0, random.between(-1e-3, 1e-3), random.between(-5e-3, 5e-3),
                                0};
    w->set_position(position);
    const double turn = random.between(0, 6.28), unit = r * friction * 6e-3;
    const std::array<double, 3> f = forces(*w, unit * std::cos(turn), unit * std::sin(turn));
    const double share = std::hypot(f[0], f[1]) / (friction * w->patch_stat(0, "normal_force"));
    worst = std::max(worst, share);
    if (r > 20) least = std::min(least, share);
  }
  expect_error("force over mu Fn, beyond 1", std::max(worst - 1, 0.0), 1e-6);
  expect_error("force over mu Fn of wheels that slide", 1 - least, 2e-3);
}

// What was solved before does not matter, nor do other threads, other wheels of the table or a saved map.
TEST_F(calibrated, results_do_not_depend_on_the_past) {
  auto one = make_by_table();
  one->prescribe_vertical(2, load);
  for (const double y : {-3.0, 3.5, 5.0, -1.0}) {
    place(*one, y);
    forces(*one, 1e-3, 0);
  }
  one->reset();
  place(*one, 0.7);
  const std::array<double, 3> expected = forces(*one, 1e-3, 0);
  const std::string path = ::testing::TempDir() + "calibrated_ellipse_test.rct";
  table->save(path);
  for (const bool saved : {false, true}) {
    table = saved ? std::shared_ptr<const ForceTable>(ForceTable::load(context, path)) : ForceTable::standard(context);
    auto other = make_by_table();
    other->prescribe_vertical(2, load);
    place(*other, 0.7);
    const std::array<double, 3> found = forces(*other, 1e-3, 0);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(found[i], expected[i]) << saved;
  }
  std::remove(path.c_str());
}

// Wheels that run back are turned by half a turn about the vertical: the wheel on the right of its way is a mirror
// image.
TEST_F(calibrated, rolling_back_is_mirrored) {
  auto full = make(), fast = make_by_table();
  put({full.get(), fast.get()}, 1);
  for (const double forward : {speed, -speed}) {
    const std::array<double, 3> f = forces(*full, 1e-3, 3e-4, forward), g = forces(*fast, 1e-3, 3e-4, forward);
    expect_error("force", std::hypot(f[0] - g[0], f[1] - g[1]) / (mu * load), 0.02);
    expect_error("moment", (f[2] - g[2]) / (mu * load * 5), 0.03);
  }
}

// Between the tread and the flange patches are solved in full; what is added as the table's weight fades is no jump.
TEST_F(calibrated, forces_do_not_jump_at_the_border_of_the_map) {
  auto w = make_by_table();
  w->prescribe_vertical(2, load);
  std::array<double, 3> before{}, f{};
  double by_table = 0, in_full = 0;
  for (double y = 3.4; y < 4.8; y += 0.01) {
    const double position[6] = {0, y, 0, 0, 0, 0};
    w->set_position(position);
    forces(*w, 5e-4, 0);
    w->resultant(false, f.data(), nullptr);
    if (y > 3.405)
      expect_error("y " + std::to_string(y), std::hypot(f[0] - before[0], f[1] - before[1]) / (mu * load), 0.012);
    before = f;
    by_table += w->patch_stat(0, "hertzian");
    in_full += 1 - w->patch_stat(0, "by_table");
  }
  EXPECT_GT(by_table, 0);
  EXPECT_GT(in_full, 0);
}

}  // namespace
}  // namespace rollcon
