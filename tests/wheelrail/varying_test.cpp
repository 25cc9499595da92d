/// Tests rails and wheels whose profiles vary: beside those that do not, turned and shifted ones, Hertz's contacts,
/// searches by brute force, and states.

#include <cmath>
#include <numbers>
#include <random>

#include "framing/hertz.hpp"
#include "geometry/profile_shapes.hpp"
#include "geometry/sliced_surface.hpp"
#include "support/first_seed.hpp"
#include "wheel_rail_fixture.hpp"
#include "wheelrail/rail_place.hpp"

namespace rollcon {
namespace {

using Six = std::array<double, 6>;

class varying : public wheels {
 protected:
  static constexpr double load = 50000;

  /// Makes a half-space with a profile of S1002 or 60E1, its z shifted, at each place.
  std::shared_ptr<Body> sliced(const char* shape, const std::vector<double>& place,
                               const std::vector<double>& depth = {}) const {
    auto body = std::make_shared<Body>(context, static_cast<std::int32_t>(BodyKind::halfspace));
    body->set_elastic(0, 2 * 82000 * 1.28, 0.28);
    const double unit = 1;
    for (std::size_t i = 0; i < place.size(); ++i) {
      body->set_profile_shape(shape, 1, &unit);
      if (!depth.empty()) {
        std::vector<double> point;
        for (const Vec2& x : body->profile()->points()) point.insert(point.end(), {x[0], x[1] + depth[i]});
        body->set_profile(static_cast<std::int64_t>(point.size() / 2), point.data(), 0);
      }
      body->add_slice(place[i], 0, nullptr);
    }
    return body;
  }
  std::unique_ptr<WheelRail> make(std::shared_ptr<Body> on_wheel, std::shared_ptr<Body> on_rail,
                                  std::int32_t side = 1) const {
    auto w = std::make_unique<WheelRail>(context, std::move(on_wheel), std::move(on_rail), side);
    // The gauge would count at the slice nearest to 0, which is not the same everywhere.
    const double cant = std::atan(1.0 / 40);
    const RailShape place = place_rail(rail->profile(), {1435, 14, cant});
    w->place_by_origin(place.origin[1], place.origin[2], cant);
    w->set_wheelset(1360, -70, 460);
    w->set_friction(mu);
    w->set_real("accuracy", 0.02);
    w->prescribe_vertical(2, load);
    const double velocity[6] = {2000, 0, 0, 0, 0, -4.3459};
    w->set_velocity(velocity);
    return w;
  }
  static void place(WheelRail& w, double x, double y, double yaw, double pitch) {
    const double position[6] = {x, y, 0, 0, yaw, pitch};
    w.set_position(position);
  }
  static std::vector<double> results(WheelRail& w) {
    const Status status = w.solve();
    EXPECT_TRUE(status == Status::ok || status == Status::rim_contact) << static_cast<int>(status);
    std::vector<double> r(6);
    w.resultant(false, r.data(), r.data() + 3);
    for (std::size_t i = 3; i < 6; ++i) r[i] /= 460;
    r.push_back(load * w.stat("z"));
    return r;
  }
  static double apart(const std::vector<double>& a, const std::vector<double>& b) {
    double off = 0;
    for (std::size_t i = 0; i < a.size(); ++i) off = std::max(off, std::abs(a[i] - b[i]) / load);
    return off;
  }
};

using varying_long = varying;

const std::vector<double> along{-60, -25, 10, 40, 90}, round{-3, -1.5, 0, 0.4, 1.2, 2.5};

TEST_F(varying, equal_slices_answer_as_one_profile) {
  double off = 0;
  const auto plain = make(wheel, rail), on_rail = make(wheel, sliced("60e1", along)),
             on_wheel = make(sliced("s1002", round), rail), both = make(sliced("s1002", round), sliced("60e1", along));
  for (const double y : {-2.0, 1.0, 4.5, 6.5})
    for (const double yaw : {0.0, 0.01}) {
      std::vector<double> expected;
      for (WheelRail* w : {plain.get(), on_rail.get(), on_wheel.get(), both.get()}) {
        place(*w, 13, y, yaw, 0.7);
        const auto found = results(*w);
        if (expected.empty()) expected = found;
        off = std::max(off, apart(found, expected));
      }
    }
  expect_error("equal slices beside one profile, of the load", off, 1e-6);
}

TEST_F(varying, shifted_rails_and_turned_wheels_are_the_same_scene) {
  const double shift = 123.4, turn = 0.5;
  std::vector<double> later = along, behind = round;
  for (double& u : later) u += shift;
  for (double& u : behind) u -= turn;
  const std::vector<double> deep{0, 0.02, 0.3, 0.1, -0.1}, out{0, 0.05, -0.2, 0.1, 0, 0.1};
  const auto a = make(sliced("s1002", round, out), sliced("60e1", along, deep)),
             b = make(sliced("s1002", behind, out), sliced("60e1", later, deep));
  double off = 0, moved = 0;
  for (const double x : {-10.0, 5.0, 33.0}) {
    place(*a, x, 1, 0.005, 0.2);
    place(*b, x + shift, 1, 0.005, 0.2 + turn);
    const auto here = results(*a);
    off = std::max(off, apart(here, results(*b)));
    place(*a, x + 5, 1, 0.005, 0.2);
    moved = std::max(moved, apart(here, results(*a)));
  }
  expect_error("shifted and turned, of the load, met to 1e-6", off, 2e-6);
  EXPECT_GT(moved, 1e-3) << "the slices do not show";
}

TEST_F(varying, a_left_wheel_is_the_mirror_of_a_right_one) {
  const std::vector<double> deep{0, 0.02, 0.3, 0.1, -0.1};
  const auto right = make(wheel, sliced("60e1", along, deep)), left = make(wheel, sliced("60e1", along, deep), -1);
  place(*right, 20, 1.5, 0.004, 0);
  place(*left, 20, -1.5, -0.004, 0);
  const auto a = results(*right);
  auto b = results(*left);
  for (const std::size_t i : {1, 3, 5}) b[i] = -b[i];
  expect_error("mirrored, of the load", apart(a, b), 1e-9);
}

// A round wheel on a wave's crest is a contact of crossed cylinders whose curvatures add up.
TEST_F(varying, waves_have_hertzian_contacts_on_their_crests) {
  const double radius = 460, across = 300, amplitude = 0.05, length = 60, k = 2 * std::numbers::pi / length;
  const double half = 0.1, line[2] = {20, 0};
  const double shape[5] = {-across * std::sin(half), across * (1 - std::cos(half)), -half, 2 * across * half,
                           1 / across};
  for (const bool of_wheel : {false, true}) {
    auto round_wheel = std::make_shared<Body>(context, static_cast<std::int32_t>(BodyKind::halfspace)),
         flat_rail = std::make_shared<Body>(context, static_cast<std::int32_t>(BodyKind::halfspace));
    for (auto* body : {round_wheel.get(), flat_rail.get()}) body->set_elastic(0, 2.1e5, 0.3);
    round_wheel->set_profile_shape("line", 2, line);
    flat_rail->set_profile_shape("arcs", 5, shape);
    double curvature = 1 / radius;
    if (of_wheel) {
      const double order = 40;
      round_wheel->add_wave(amplitude / 10, 2 * std::numbers::pi / order, std::numbers::pi / 2);
      const double r = radius + amplitude / 10;
      curvature = 1 / r + amplitude / 10 * order * order / (r * r);
    } else {
      flat_rail->add_wave(-amplitude, length, std::numbers::pi / 2);
      curvature += amplitude * k * k;
    }
    WheelRail w(context, round_wheel, flat_rail, 1);
    w.place_by_origin(750, 0, 0);
    w.set_wheelset(1360, -70, radius);
    w.set_friction(0.3);
    w.set_real("accuracy", 0.005);
    w.prescribe_vertical(2, 10000);
    const double velocity[6] = {2000, 0, 0, 0, 0, -2000 / radius}, position[6] = {0, 0, 0, 0, 0, 0};
    w.set_velocity(velocity);
    w.set_position(position);
    ASSERT_EQ(w.solve(), Status::ok);
    const HertzContact hertz = hertz_by_load({curvature / 2, 1 / (2 * across), 0}, 2.1e5 / (2 * (1 - 0.09)), 10000);
    const std::string which = of_wheel ? "polygon: " : "corrugation: ";
    expect_error(which + "largest pressure beside Hertz's", w.patch_stat(0, "max_pressure") / hertz.pressure - 1, 0.01);
    const double top = of_wheel ? -amplitude / 10 : -amplitude;
    expect_error(which + "approach beside Hertz's", (w.stat("z") - top) / hertz.approach - 1, 0.01);
  }
}

/// Draws rails with humps and wheels with hollows, and compares first touch with the least gap of a fine grid.
void search_beside_brute_force(int count, std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  double worst = 0, missed = 0;
  for (int draw = 0; draw < count; ++draw) {
    const double step = between(10, 40), tilt = between(-0.08, 0.08), crown = between(30, 400);
    std::vector<ProfileSlice> slice;
    for (int i = -6; i <= 6; ++i) {
      const double u = i * step, r = crown * between(0.95, 1.05), y = between(-0.3, 0.3);
      const double z = tilt * u + between(-1, 1) * step * step / 4000;
      const std::vector<double> arc{y - r * std::sin(0.5), z + r * (1 - std::cos(0.5)), -0.5, r, 1 / r};
      slice.push_back({u, std::make_shared<const ProfileCurve>(profile_of_shape("arcs", arc)), {}});
    }
    const auto slices = std::make_shared<const ProfileSlices>(slice, std::vector<ProfileWave>{}, false, 0);
    const double half[2] = {25, between(-0.1, 0.1)};
    const auto line = std::make_shared<const ProfileCurve>(profile_of_shape("line", half));
    const ContactSearch search({line, {0, 0, -460}, {0, 1, 0}, 460},
                               {slices->slices()[6].curve, {}, {1, 0, 0}, {0, 0, 1}, slices});
    const double yaw = between(-0.02, 0.02), place = between(-2, 2) * step;
    Pose pose;
    pose.rotation = {{{std::cos(yaw), -std::sin(yaw), 0}, {std::sin(yaw), std::cos(yaw), 0}, {0, 0, 1}}};
    pose.translation = {0, between(-4, 4), -20};
    const double found = search.first_touch(pose, place);
    const SlicedSurface surface(slices, {false, {-place, 0, 0}, {1, 0, 0}, {0, 0, 1}, 0});
    SurfaceHint hint;
    double least = INFINITY;
    for (double y = -25; y <= 25; y += 0.5)
      for (double angle = -0.2; angle <= 0.2; angle += 0.004) {
        const double r = 460 + half[1] * y;
        const Vec3 x = pose.place({r * std::sin(angle), y, r * std::cos(angle) - 460});
        if (const auto gap = surface.distance_near(x, {0, 0, 1}, {0, 0, 0}, hint)) least = std::min(least, *gap);
      }
    // The grid is above the least gap by less than its spacing squared over the radii.
    worst = std::max(worst, std::abs(found - least));
    missed = std::max(missed, found - least);
  }
  std::printf("%d draws, greatest difference %.2g\n", count, worst);
  expect_error("gap that the search missed", missed, 1e-3);
  expect_error("gap beside the grid", worst, 0.02);
}

TEST_F(varying, first_touch_is_the_least_gap) {
  search_beside_brute_force(100, 2 + extremes::first_seed());
}
TEST(varying_nightly, first_touch_is_the_least_gap) {
  search_beside_brute_force(10000, 3 + extremes::first_seed());
}

// A rail that rises to a crest, and a wheel with a shallow flat, a chord: forces of steps lag behind the steady ones at
// the same places, and steps by half as much agree with them.
TEST_F(varying_long, steps_over_a_crest_and_a_flat) {
  const double chord = 0.02;
  std::vector<double> turn, deep;
  for (double angle = -0.08; angle < 0.081; angle += 0.01) {
    turn.push_back(angle);
    deep.push_back(std::min(0.0, -460 * (1 - std::cos(chord) / std::cos(angle))));
  }
  for (const bool flat : {false, true}) {
    const auto body = flat ? sliced("s1002", turn, deep)
                           : sliced("60e1", {-80, -40, -20, 0, 20, 40, 80}, {0, 0, -0.1, -0.2, -0.1, 0, 0});
    const auto steady = flat ? make(body, rail) : make(wheel, body),
               steps = flat ? make(body, rail) : make(wheel, body),
               halves = flat ? make(body, rail) : make(wheel, body);
    double off = 0, apart_by_half = 0, largest = 0, change = 0;
    std::vector<double> before;
    for (int i = 0; i <= 12; ++i) {
      const auto solve_at = [&](WheelRail& w, double way, double x) {
        const double turned = flat ? -x / 460 : 0;
        w.set_step(i == 0 || way == 0 ? 0 : 1, way / 2000);
        place(w, flat ? 0 : x, 1, 0, turned);
        const Status status = w.solve();
        EXPECT_TRUE(is_answer(status)) << static_cast<int>(status);
        std::vector<double> force(3);
        w.resultant(false, force.data(), nullptr);
        return force;
      };
      const double x = -12 + i;
      const auto expected = solve_at(*steady, 0, x), found = solve_at(*steps, 1, x);
      if (i > 0) solve_at(*halves, 0.5, x - 0.5);
      const auto finer = solve_at(*halves, 0.5, x);
      off = std::max(off, apart(found, expected) / mu);
      apart_by_half = std::max(apart_by_half, apart(found, finer) / mu);
      if (i > 1) change = std::max(change, apart(found, before) / mu);
      if (i > 0) largest = std::max(largest, std::hypot(found[0], found[1]) / (mu * load));
      before = found;
    }
    std::printf("%s: steps beside steady %.4f, half steps %.4f, change in a step %.4f, force %.3f of friction's\n",
                flat ? "flat" : "crest", off, apart_by_half, change, largest);
    EXPECT_GT(off, 0.05);
    EXPECT_LT(off, 0.4);
    EXPECT_LT(apart_by_half, 0.02);
    EXPECT_LT(change, 0.1);
  }
}

TEST_F(varying, states_come_back_in_mid_passage) {
  const std::vector<double> deep{0, 0.02, 0.3, 0.1, -0.1};
  const auto w = make(wheel, sliced("60e1", along, deep));
  place(*w, 0, 1, 0.002, 0);
  results(*w);
  w->snapshot(0);
  const auto copy = w->copy();
  std::vector<double> first, again, other;
  const auto pass = [](WheelRail& on, std::vector<double>& all) {
    for (double x = 5; x < 40; x += 7) {
      place(on, x, 1, 0.002, 0);
      const auto r = results(on);
      all.insert(all.end(), r.begin(), r.end());
    }
  };
  pass(*w, first);
  w->rollback(0);
  pass(*w, again);
  pass(*copy, other);
  EXPECT_EQ(first, again);
  EXPECT_EQ(first, other);
}

TEST_F(varying, derivatives_by_place_and_turn_are_those_of_the_solves) {
  const std::vector<double> deep{0, 0.02, 0.3, 0.1, -0.1}, out{0, 0.05, -0.2, 0.1, 0, 0.1};
  const auto w = make(sliced("s1002", round, out), sliced("60e1", along, deep));
  w->prescribe_vertical(1, 0);
  w->set_real("accuracy", 0.01);
  const auto solve = [&](double x, double pitch, double z) {
    const double position[6] = {x, 1, z, 0, 0.002, pitch};
    w->set_position(position);
    EXPECT_EQ(w->solve(), Status::ok);
    std::vector<double> f(3);
    w->resultant(false, f.data(), nullptr);
    return f;
  };
  place(*w, 20, 1, 0.002, 0.1);
  const auto by_force = make(sliced("s1002", round, out), sliced("60e1", along, deep));
  place(*by_force, 20, 1, 0.002, 0.1);
  results(*by_force);
  const double z = by_force->stat("z");
  for (const int entry : {0, 5}) {
    const double step = entry == 0 ? 0.05 : 1e-4, dx = entry == 0 ? step : 0, dp = entry == 5 ? step : 0;
    const auto before = solve(20 - dx, 0.1 - dp, z), behind = solve(20 + dx, 0.1 + dp, z);
    solve(20, 0.1, z);
    const Vec3 rate = w->derivative(entry).force;
    double off = 0, size = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double by_solves = (behind[i] - before[i]) / (2 * step);
      off = std::max(off, std::abs(rate[i] - by_solves));
      size = std::max(size, std::abs(by_solves));
    }
    expect_error(entry == 0 ? "derivative by x" : "derivative by pitch", off / size, 1e-3);
  }
}

// Each rate has a limit from which the surfaces run backwards; it is named, and just on this side of it wheels roll.
TEST_F(varying, rates_at_which_surfaces_run_backwards_are_named_with_their_limits) {
  struct Row {
    const char* text;
    std::size_t entry;
    double value, rolling;
  };
  for (const std::int32_t side : {1, -1})
    for (const int step : {0, 1})
      for (const Row& r : {Row{"the rate of z, entry 2 ", 2, -9e5, 0},
                           {"the yaw rate, entry 4 ", 4, -side * 6.0, 0},
                           {"the pitch rate, entry 5 ", 5, 4.5, -4.3459}}) {
        const auto w = make(wheel, sliced("60e1", {-100, -50, 0, 50, 100}, {1, 0.5, 0, -0.5, -1}), side);
        place(*w, 10, 0, 0, 0);
        ASSERT_EQ(w->solve(), Status::ok);
        const Six position{10, 0, w->stat("z"), 0, 0, 0};
        w->set_position(position.data());
        w->prescribe_vertical(1, 0);
        w->set_step(step, 5e-4);
        Six velocity{2000, 0, 0, 0, 0, -4.3459};
        const auto text_at = [&](double value) {
          velocity[r.entry] = value;
          w->set_velocity(velocity.data());
          try {
            w->solve();
          } catch (const Error& e) {
            EXPECT_EQ(e.status(), Status::err_argument);
            return std::string(e.what());
          }
          return std::string();
        };
        const std::string text = text_at(r.value);
        for (const char* words : {r.text, "rollcon_wheelrail_set_velocity"})
          EXPECT_NE(text.find(words), std::string::npos) << text;
        const std::string before = r.value < 0 ? "allowed: above " : "allowed: below ";
        ASSERT_NE(text.find(before), std::string::npos) << text;
        const double limit = std::stod(text.substr(text.find(before) + before.size()));
        EXPECT_LT(std::abs(limit), std::abs(r.value));
        const double digits = 1e-5 * std::abs(limit);
        EXPECT_EQ(text_at(limit + std::copysign(digits, r.rolling - limit)), "");
        EXPECT_NE(text_at(limit - std::copysign(digits, r.rolling - limit)), "");
      }
}

/// Makes a crossing's rail: a wing rail that leads away, beside it a nose that rises (examples/crossing.c).
class Crossing {
 public:
  static constexpr double begins = 560, up = 760, flangeway = 44;
  static double wing_edge(double x) { return flangeway + 12 + 0.1 * (x - begins); }

  static void add_slice(Body& rail, double x) {
    const double c = std::cos(steep), s = std::sin(steep), floor = 8,
                 left = std::max(0.0, 1 - (x - begins) / (up - begins));
    const Head wing{13, 300, 70}, nose{5, 60, 12 + 0.1 * (x - begins)};
    std::vector<double> chain{wing_edge(x) + wing.corner * (1 - s), wing.drop() - 2, -steep};
    double feature[4] = {-1, -1, 0, 0};
    if (x >= begins) {
      const double depth = 6 * left * left, more = (depth + nose.drop() - wing.drop() + 2) / s;
      const double across = flangeway + (nose.corner + wing.corner) * (1 - s) - 2 * floor * s,
                   down = 0.5 * (across / c - more);
      chain = {nose.corner * (1 - s), depth + nose.drop(), -steep};
      feature[0] = 0;
      feature[1] = nose.add_to(chain);
      chain.insert(chain.end(), {down, 0, 2 * floor * steep, -1 / floor, down + more, 0});
      feature[2] = feature[1] + 2 * down + more + 2 * floor * steep;
    }
    feature[3] = feature[2] + wing.add_to(chain);
    rail.set_profile_shape("arcs", static_cast<std::int32_t>(chain.size()), chain.data());
    rail.add_slice(x, 4, feature);
  }

 private:
  static constexpr double steep = 75 * std::numbers::pi / 180;
  struct Head {
    double corner, crown, width;
    double turn() const { return std::asin((width / 2 - corner) / (crown - corner)); }
    double drop() const { return (crown - corner) * (1 - std::cos(turn())) + corner * (1 - std::cos(steep)); }
    double add_to(std::vector<double>& chain) const {
      const double side = corner * (steep - turn()), top = 2 * crown * turn();
      chain.insert(chain.end(), {side, 1 / corner, top, 1 / crown, side, 1 / corner});
      return 2 * side + top;
    }
  };
};

// A force that jumped would change as much in half a step.
TEST_F(varying, a_crossings_nose_takes_the_load_without_jumps) {
  const auto body = std::make_shared<Body>(context, static_cast<std::int32_t>(BodyKind::halfspace));
  body->set_elastic(0, 2.1e5, 0.28);
  for (double x = 600; x <= 660; x += 20) Crossing::add_slice(*body, x);
  const double speed = 10000, first = 627, last = 635;
  std::array<double, 4> change[2]{};  // forces along x and y, on wing rail and on nose
  double nose_first = 0, wing_last = 0, off = 0;
  for (const std::size_t halved : {0, 1}) {
    const double way = halved == 0 ? 1 : 0.5;
    const auto w = make(wheel, body);
    w->place_by_origin(725, 0, 0);
    double rate = 0, z = 0;
    std::array<double, 4> before{};
    for (double x = first; x <= last; x += way) {
      w->set_step(x > first ? 1 : 0, way / speed);
      place(*w, x, 0, 0, 0);
      const Six velocity{speed, 0, rate, 0, 0, -speed / 460};
      w->set_velocity(velocity.data());
      ASSERT_TRUE(is_answer(w->solve())) << x;
      rate = x > first ? speed * (w->stat("z") - z) / way : 0;
      z = w->stat("z");
      std::vector<double> force(3);
      w->resultant(false, force.data(), nullptr);
      std::array<double, 4> now{force[0], force[1], 0, 0};
      for (std::int32_t k = 0; k < static_cast<std::int32_t>(w->patches()); ++k) {
        const double share = w->patch_stat(k, "share");
        now[w->patch_stat(k, "y") - 725 < Crossing::flangeway ? 3 : 2] += share * w->patch_stat(k, "normal_force");
      }
      off = std::max(off, std::abs(std::abs(force[2]) - load) / load);
      if (x == first) nose_first = now[3];
      if (x == last) wing_last = now[2];
      for (std::size_t i = 0; i < 4 && x > first + 1; ++i)
        change[halved][i] = std::max(change[halved][i], std::abs(now[i] - before[i]));
      before = now;
    }
  }
  EXPECT_EQ(nose_first, 0);
  EXPECT_EQ(wing_last, 0);
  expect_error("vertical force beside the load", off, 1e-5);
  const char* const of[] = {"Fx", "Fy", "wing rail", "nose"};
  for (std::size_t i = 0; i < 4; ++i) {
    std::printf("%s: largest change %.0f in steps of 1 mm, %.0f of 0.5 mm\n", of[i], change[0][i], change[1][i]);
    EXPECT_GT(change[0][i], 0.01 * load) << of[i] << " hardly changes";
    EXPECT_LT(change[1][i], 0.6 * change[0][i]) << of[i];
  }
}

TEST_F(varying, tables_and_conformal_patches_refuse) {
  const auto w = make(wheel, sliced("60e1", along));
  place(*w, 0, 1, 0, 0);
  w->set_int("conformal", 1);
  refused([&] { w->solve(); }, Status::err_unsupported, {"rail", "varies", "conformal"});
  w->set_int("conformal", 0);
  EXPECT_EQ(w->solve(), Status::ok);
}

}  // namespace
}  // namespace rollcon
