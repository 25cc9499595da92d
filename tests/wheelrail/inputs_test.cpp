/// Tests what a wheel and its track may be given: rails placed by their origin and on springs, curves, tape circles,
/// wheelsets that bend, longitudinal forces. Each is compared with the same place or motion given in another way.

#include <cmath>

#include "wheel_rail_fixture.hpp"
#include "wheelrail/rail_place.hpp"

namespace rollcon {
namespace {

using Six = std::array<double, 6>;

class wheel_inputs : public wheels {
 protected:
  std::unique_ptr<WheelRail> make(std::int32_t side = 1) const {
    auto w = wheels::make(side);
    w->set_real("accuracy", 0.02);
    w->prescribe_vertical(2, 10000);
    return w;
  }
  static std::vector<double> results(WheelRail& w) {
    EXPECT_EQ(w.solve(), Status::ok);
    std::vector<double> r(3);
    w.resultant(false, r.data(), nullptr);
    r.push_back(w.stat("friction_power"));
    for (const char* name : {"x", "y", "z", "normal_force", "longitudinal_creepage", "lateral_creepage", "spin"})
      r.push_back(w.patch_stat(0, name));
    return r;
  }
  /// Expects results that differ by a bound, relative to each (forces: to the load).
  static void expect_same(const std::string& what, const std::vector<double>& a, const std::vector<double>& b,
                          double bound) {
    double off = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
      off = std::max(off, std::abs(a[i] - b[i]) / (i < 3 ? 10000 : std::max(std::abs(b[i]), 1e-3)));
    expect_error(what, off, bound);
  }
};

TEST_F(wheel_inputs, a_rail_lies_where_its_origin_is_put) {
  const double cant = std::atan(1.0 / 40), roll = 0.002;
  const RailShape by_gauge = place_rail(rail->profile(), {1435, 14, cant});
  for (const std::int32_t side : {1, -1}) {
    const auto gauged = make(side), placed = make(side);
    placed->place_by_origin(by_gauge.origin[1], by_gauge.origin[2], cant);
    for (WheelRail* w : {gauged.get(), placed.get()}) place(*w, 1.0 * side);
    expect_same("by origin beside by gauge", results(*placed), results(*gauged), 1e-9);
    const double deviation[3] = {0.1, 0.05, roll}, rate[3] = {1, 2, 1e-3};
    gauged->set_int("roll_about_origin", 1);
    for (WheelRail* w : {gauged.get(), placed.get()}) w->set_rail_deviation(deviation, rate);
    expect_same("rolled about its origin", results(*placed), results(*gauged), 1e-9);
    gauged->set_int("roll_about_origin", 0);
    const auto elsewhere = results(*gauged);
    EXPECT_GT(std::abs(elsewhere[5] / results(*placed)[5] - 1), 1e-7) << "the place of the roll does not show";
  }
}

// Axes that follow a curve turn: beside straight track the wheelset has another yaw rate and forward speed.
TEST_F(wheel_inputs, a_curve_shows_in_the_creepages) {
  const double curvature = 1e-6, turn = 2000 * curvature;
  for (const std::int32_t side : {1, -1}) {
    const auto curved = make(side), straight = make(side);
    curved->set_real("curvature", curvature);
    const Six velocity{2000, 0, 0, 0, turn, -4.3459};
    straight->set_velocity(velocity.data());
    for (WheelRail* w : {curved.get(), straight.get()}) place(*w, 0);
    const auto a = results(*curved);
    expect_same("a curve", a, results(*straight), 1e-9);
    const Six plain{2000, 0, 0, 0, 0, -4.3459};
    straight->set_velocity(plain.data());
    // The outer wheel has a longer way, by the distance from the middle.
    const double slower = a[8] - results(*straight)[8];
    expect_error("longitudinal creepage of the curve", slower / (-side * curvature * 752) - 1, 0.01);
  }
}

TEST_F(wheel_inputs, a_tape_circle_measures_the_radius) {
  const double tape = -10, depth = wheel->profile()->at(wheel->profile()->at_y(tape).back()).x[1];
  ASSERT_GT(std::abs(depth), 0.1);
  const auto taped = make(), plain = make();
  taped->set_tape_circle(tape);
  plain->set_wheelset(1360, -70, 460 - depth);
  expect_same("tape circle", results(*taped), results(*plain), 1e-9);
  expect_error("height of the axle, mm", (taped->stat("z") - 460) - (plain->stat("z") - (460 - depth)), 1e-9);
  refused([&] { taped->set_tape_circle(200); }, Status::err_argument,
          {"tape circle is 200", "where the wheel's profile is"});
  expect_same("after a refusal", results(*taped), results(*plain), 1e-9);
}

// A wheel that is bent stands as one of a rigid wheelset elsewhere, and moves as that does.
TEST_F(wheel_inputs, a_wheelset_may_bend) {
  const double roll = 2e-3, yaw = -1e-3, dy = 0.3, dz = 0.2, arm = 0.5 * 1360 + 70;
  for (const std::int32_t side : {1, -1}) {
    const auto bent = make(side), rigid = make(side);
    // Its axle has the same direction if the rigid wheelset is rolled and yawed as the wheel is.
    const Six displacement{0.1, side * dy, dz, side * roll, side * yaw, 0}, rate{0, side * 5.0, 2, 0, 0, 0};
    bent->set_flexibility(displacement.data(), rate.data());
    const Six level{0, 0, 0, 0, 0, 0};
    bent->set_position(level.data());
    bent->prescribe_vertical(1, 0);
    rigid->prescribe_vertical(1, 0);
    const double cr = std::cos(roll), sr = std::sin(roll), cy = std::cos(yaw), sy = std::sin(yaw);
    // x of the track = yaw roll x of the wheel; the profile's origin is at (0, arm, 460) of both wheelsets.
    const double y = arm + dy - (cy * (cr * arm - sr * 460)), z = 460 + dz - (sr * arm + cr * 460);
    const Six position{0, side * y, z + 0.15, side * roll, side * yaw, 0};
    rigid->set_position(position.data());
    const Six lower{0, 0, 0.15, 0, 0, 0};
    bent->set_position(lower.data());
    const Six velocity{2000, side * 5.0, 2, 0, 0, -4.3459}, own{2000, 0, 0, 0, 0, -4.3459};
    rigid->set_velocity(velocity.data());
    bent->set_velocity(own.data());
    const auto a = results(*bent), b = results(*rigid);
    EXPECT_GT(b[7], 1000);
    expect_error("place along the rail moves by the displacement", a[4] - b[4] - (0.1 + sy * (cr * arm - sr * 460)),
                 1e-9);
    for (const std::size_t i : {0U, 1U, 2U, 7U})
      expect_error("force " + std::to_string(i), (a[i] - b[i]) / 10000, 1e-9);
    for (const std::size_t i : {8U, 9U, 10U}) expect_error("creepage " + std::to_string(i), a[i] - b[i], 1e-9);
    // Rates of turns are those of the wheelset, where nothing is bent yet.
    const Six turning{0, 0, 0, side * 1e-3, side * 2e-3, -0.01}, faster{2000, 0, 0, side * 1e-3, side * 2e-3, -4.3559};
    bent->set_flexibility(level.data(), turning.data());
    rigid->set_velocity(faster.data());
    rigid->set_position(lower.data());
    bent->prescribe_vertical(2, 10000);
    rigid->prescribe_vertical(2, 10000);
    const auto c = results(*bent), d = results(*rigid);
    // Its turns move the wheel about its own middle, those of the wheelset about that of the axle.
    expect_error("longitudinal creepage of yaw", c[8] - d[8] - 2e-3 * arm / 2000, 3e-6);
    expect_error("spin", c[10] - d[10], 1e-7);
  }
}

TEST_F(wheel_inputs, springs_carry_what_the_wheel_presses) {
  const double stiffness[2] = {2e4, 6e4}, force[2] = {300, -9000};
  for (const std::int32_t side : {1, -1})
    for (const double y : {2.0, 6.5})
      for (const bool by_force : {true, false}) {
        const auto w = make(side), rigid = make(side);
        const double own[2] = {side * force[0], force[1]};
        place(*w, side * y, y > 6 ? -0.6 : 0.2);
        w->prescribe_vertical(by_force ? 2 : 1, 10000);
        w->set_rail_springs(stiffness, own);
        const Status status = w->solve();
        ASSERT_GE(status, Status::ok);
        ASSERT_NE(status, Status::not_converged);
        double f[3];
        w->resultant(false, f, nullptr);
        const double d[3] = {w->stat("rail_deflection_y"), w->stat("rail_deflection_z"), 0}, still[3] = {0, 0, 0};
        const double load = std::hypot(f[1], f[2]) + 9300;
        const std::string at = "y " + std::to_string(y) + (by_force ? ", by force" : ", by height");
        expect_error(at + ": springs along y", (stiffness[0] * d[0] + f[1] - own[0]) / load, 3e-6);
        expect_error(at + ": springs along z", (stiffness[1] * d[1] + f[2] - own[1]) / load, 3e-6);
        EXPECT_GT(std::hypot(d[0], d[1]), 1e-3);
        EXPECT_GT(-f[2], 100) << at;
        rigid->set_rail_deviation(d, still);
        place(*rigid, side * y, w->stat("z"));
        rigid->prescribe_vertical(1, 0);
        ASSERT_GE(rigid->solve(), Status::ok);
        double g[3];
        rigid->resultant(false, g, nullptr);
        for (std::size_t c = 0; c < 3; ++c) expect_error(at + ": force beside a deviation", (f[c] - g[c]) / load, 1e-7);
      }
}

TEST_F(wheel_inputs, a_longitudinal_force_finds_its_pitch_rate) {
  for (const std::int32_t side : {1, -1})
    for (const double pull : {1500.0, 0.0, -1000.0}) {
      const auto w = make(side), by_rate = make(side);
      w->prescribe_longitudinal(2, pull);
      for (WheelRail* each : {w.get(), by_rate.get()}) place(*each, side * 1.5);
      results(*w);
      double f[3], g[3];
      w->resultant(true, f, nullptr);
      expect_error("force along, given " + std::to_string(pull), (f[0] - pull) / 10000, 2e-6);
      const Six velocity{2000, 0, 0, 0, 0, w->stat("pitch_rate")};
      by_rate->set_velocity(velocity.data());
      results(*by_rate);
      by_rate->resultant(true, g, nullptr);
      for (std::size_t c = 0; c < 3; ++c) expect_error("force by that rate", (f[c] - g[c]) / 10000, 2e-6);
    }
  const auto w = make();
  w->prescribe_longitudinal(2, 3500);
  refused([&] { w->solve(); }, Status::err_load, {"3500", "no pitch rate"});
  w->prescribe_longitudinal(1, 0);
  EXPECT_EQ(w->solve(), Status::ok);
  EXPECT_EQ(w->stat("pitch_rate"), -4.3459) << "what was refused has changed the velocity";
}

// Height, pitch rate and deflection follow in derivatives.
TEST_F(wheel_inputs, derivatives_keep_what_is_given) {
  const auto w = make();
  const double stiffness[2] = {2e4, 6e4}, force[2] = {0, -10000};
  w->set_rail_springs(stiffness, force);
  w->prescribe_longitudinal(2, 800);
  const Six position{0, 2, 0, -1e-4, 3e-4, 0}, velocity{2000, 1, 0.5, 2e-3, 1e-3, -4.3459};
  const auto solve = [&](std::size_t entry, double by) {
    Six p = position, v = velocity;
    (entry < 6 ? p : v)[entry % 6] += by;
    w->set_position(p.data());
    w->set_velocity(v.data());
    EXPECT_EQ(w->solve(), Status::ok);
    std::vector<double> t(7);
    w->resultant(false, t.data(), t.data() + 3);
    t[6] = w->stat("z");
    return t;
  };
  for (const std::size_t entry : {1U, 3U, 4U, 7U, 10U}) {
    const double by = entry == 1 ? 2e-3 : entry == 7 ? 0.1 : entry == 10 ? 4e-4 : 1e-5;
    const auto a = solve(entry, -by), b = solve(entry, by);
    solve(entry, 0);
    const WheelRail::Derivative d = w->derivative(static_cast<std::int32_t>(entry));
    const double own[] = {d.force[0], d.force[1], d.force[2], d.moment[0], d.moment[1], d.moment[2], d.z};
    double off = 0, scale = 0;
    for (std::size_t c = 0; c < 7; ++c) {
      const double unit = c < 3 ? 3000 : c < 6 ? 3000 * 460.0 : 0.1, difference = (b[c] - a[c]) / (2 * by);
      scale = std::max(scale, std::abs(difference) / unit);
      off = std::max(off, std::abs(own[c] - difference) / unit);
    }
    expect_error("entry " + std::to_string(entry), off / scale, 0.02);
  }
  for (const std::int32_t found : {2, 11}) EXPECT_EQ(w->derivative(found).force, (Vec3{0, 0, 0}));
}

TEST_F(wheel_inputs, are_restored_and_mirrored_to_the_last_bits) {
  const double stiffness[2] = {2e4, 6e4};
  const auto set = [&](WheelRail& w, double side) {
    const double force[2] = {side * 200, -9000};
    w.set_rail_springs(stiffness, force);
    w.prescribe_longitudinal(2, 500);
    w.set_real("curvature", side * 1e-6);
    const Six bend{0, side * 0.1, 0.1, side * 1e-4, side * 1e-4, 0}, rate{0, side, 1, side * 1e-4, side * 1e-4, 1e-4};
    w.set_flexibility(bend.data(), rate.data());
    place(w, side * 2.0);
  };
  const auto right = make(), left = make(-1);
  set(*right, 1);
  set(*left, -1);
  const auto a = results(*right), b = results(*left);
  right->snapshot(0);
  for (const std::size_t i : {0U, 2U, 3U, 4U, 6U, 7U, 8U}) EXPECT_EQ(a[i], b[i]) << i;
  for (const std::size_t i : {1U, 5U, 9U, 10U}) EXPECT_EQ(a[i], -b[i]) << i;
  EXPECT_EQ(right->stat("rail_deflection_y"), -left->stat("rail_deflection_y"));
  const double none[2] = {0, 0};
  const Six still{};
  right->set_rail_springs(none, none);
  right->set_flexibility(still.data(), still.data());
  right->set_real("curvature", 0);
  place(*right, 1);
  results(*right);
  const auto copied = left->copy();
  right->rollback(0);
  place(*right, 2.1);
  place(*left, -2.1);
  place(*copied, -2.1);
  const auto c = results(*right), d = results(*left);
  EXPECT_EQ(results(*copied), d);
  for (const std::size_t i : {0U, 2U, 3U, 4U, 6U, 7U, 8U}) EXPECT_EQ(c[i], d[i]) << i;
}

TEST_F(wheel_inputs, are_refused_by_name) {
  const auto w = make();
  const double soft[2] = {-1, 0}, none[2] = {0, 0};
  const Six turned{0, 0, 0, 0.6, 0, 0}, still{};
  refused([&] { w->set_rail_springs(soft, none); }, Status::err_argument, {"entry 0 of stiffness", "-1"});
  refused([&] { w->set_flexibility(turned.data(), still.data()); }, Status::err_argument,
          {"roll of the displacement", "0.6"});
  refused([&] { w->place_by_origin(750, 0, 0.6); }, Status::err_argument, {"cant is 0.6"});
  refused([&] { w->prescribe_longitudinal(3, 0); }, Status::err_argument, {"how is 3"});
  EXPECT_EQ(w->solve(), Status::ok);
}

}  // namespace
}  // namespace rollcon
