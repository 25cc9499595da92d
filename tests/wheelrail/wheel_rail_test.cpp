/// Tests a wheel on its rail from profiles, position and velocity: forces beside CONTACT's on the Manchester benchmark,
/// Hertz's contacts, mirror and units, continuity, what is refused.

#include "wheelrail/wheel_rail.hpp"

#include "manchester.hpp"
#include "support/closed_forms.hpp"
#include "support/context.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

/// Holds CONTACT's answers, case, elements of 0.2 mm; creepages of the rail relative to the wheel, forces on the
/// rail.
struct Row {
  std::int32_t side;
  double y, roll, pitch_rate, z;
  Vec3 reference;
  double angle;
  Vec3 creepage;
  double normal, longitudinal, lateral, moment, pressure;
  /// Bound over the friction limit. CONTACT's slip is that of creepages and spin; over wide patches the rolling radius
  /// varies otherwise: with CONTACT's creepages alone forces are within 1 percent in all rows.
  double force_bound;
};
constexpr Row rows[] = {
    {1,
     0,
     0,
     -4.3481181,
     .1981,
     {0, 751.8726, .1252},
     -.0290,
     {-5.665e-5, 0, 6.302e-5},
     9997,
     .2783,
     -253.6,
     -4605,
     338.3,
     .04},
    {1,
     .5,
     -2.304e-5,
     -4.3474134,
     .1938,
     {-.861, 744.5026, .4289},
     -.0568,
     {4.948e-4, 1.202e-3, 1.233e-4},
     9870,
     -880.0,
     -2579,
     -3202,
     632.5,
     .04},
    {1,
     2,
     -1.128e-4,
     -4.3459197,
     .1529,
     {-3.368, 740.9147, .6548},
     -.0806,
     {8.752e-4, 4.818e-3, 1.746e-4},
     9799,
     -517.3,
     -2893,
     -37.57,
     744.8,
     .01},
    {1,
     6.5,
     -4.376e-3,
     -4.2748834,
     -3.0468,
     {5.801, 718.4931, 10.365},
     -1.1591,
     {1.828e-2, 3.905e-2, 1.937e-3},
     15440,
     -1987,
     -4170,
     -728.2,
     2603,
     .01},
    {-1,
     1,
     -5.049e-5,
     -4.3465752,
     .1840,
     {1.796, -755.2440, .0467},
     .0176,
     {-6.297e-4, 2.400e-3, -3.848e-5},
     10050,
     829.2,
     -2893,
     376.0,
     423.9,
     .01},
};
/// The two patches are 7 mm apart; CONTACT solves them as one with part of what they do to each other.
constexpr Row two_patches = {
    1,      5,     -3.554e-4, -4.3353637, .0015, {-7, 727.0855, 3.0041}, -.2905, {4.174e-3, 1.255e-2, 6.188e-4}, 9619,
    -763.3, -2738, -826.6,    1556,       .04};
constexpr double mu = 0.3;

class wheel_rail : public ::testing::Test {
 protected:
  void SetUp() override {
    context = std::make_shared<Context>();
    make_bodies(1);
  }
  void make_bodies(double in_unit) {
    unit = in_unit;
    for (auto* body : {&wheel, &rail}) {
      *body = std::make_shared<Body>(context, static_cast<std::int32_t>(BodyKind::halfspace));
      (*body)->set_elastic(0, 2 * 82000 * 1.28 / (unit * unit), 0.28);
    }
    wheel->set_profile_shape("s1002", 1, &unit);
    rail->set_profile_shape("60e1", 1, &unit);
  }
  std::unique_ptr<WheelRail> make(std::int32_t side) const {
    auto w = std::make_unique<WheelRail>(context, wheel, rail, side);
    w->set_track(1435 * unit, 14 * unit, std::atan(1.0 / 40));
    w->set_wheelset(1360 * unit, -70 * unit, 460 * unit);
    w->set_friction(mu);
    return w;
  }
  void place(WheelRail& w, const Row& r) const {
    const double position[6] = {0, r.y * unit, r.z * unit, r.roll, 2.4e-3 * r.y, 0},
                 velocity[6] = {2000 * unit, 0, 0, 0, 0, r.pitch_rate};
    w.set_position(position);
    w.set_velocity(velocity);
  }

  double unit = 1;
  std::shared_ptr<Context> context;
  std::shared_ptr<Body> wheel, rail;
};

std::string name_of(const Row& r) {
  char text[32];
  std::snprintf(text, sizeof text, "%s, y %g", r.side > 0 ? "right" : "left", r.y);
  return text;
}

using wheel_rail_long = wheel_rail;

TEST_F(wheel_rail_long, manchester_positions_and_forces) {
  for (const Row& r : rows) {
    const auto w = make(r.side);
    place(*w, r);
    w->set_real("accuracy", 0.005);
    ASSERT_EQ(w->solve(), Status::ok) << name_of(r);
    ASSERT_EQ(w->patches(), 1) << name_of(r);
    const auto of = [&](const char* what) { return w->patch_stat(0, what); };
    const std::string name = name_of(r);
    expect_error(name + ": reference, mm", length(Vec3{of("x"), of("y"), of("z")} - r.reference), 0.05);
    expect_error(name + ": angle", of("angle") - r.angle, 2e-4);
    const char* creepage[] = {"longitudinal_creepage", "lateral_creepage", "spin"};
    for (std::size_t i = 0; i < 3; ++i)
      expect_error(name + ": " + creepage[i], -of(creepage[i]) - r.creepage[i],
                   2e-3 * std::max(std::abs(r.creepage[i]), 5e-5));
    // The value z is known to 5e-5 mm of 0.016 and more, which is half of the bound.
    expect_error(name + ": normal force", of("normal_force") / r.normal - 1, 0.01);
    expect_error(name + ": longitudinal force over mu Fn",
                 (-of("longitudinal_force") - r.longitudinal) / (mu * r.normal), r.force_bound);
    expect_error(name + ": lateral force over mu Fn", (-of("lateral_force") - r.lateral) / (mu * r.normal), 0.012);
    expect_error(name + ": largest pressure", of("max_pressure") / r.pressure - 1, 0.03);
  }
}

TEST_F(wheel_rail_long, two_patches_give_way_under_each_other) {
  const auto w = make(1);
  place(*w, two_patches);
  w->set_real("accuracy", 0.005);
  ASSERT_EQ(w->solve(), Status::ok);
  ASSERT_EQ(w->patches(), 2);
  const double deep = w->patch_stat(0, "normal_force"), shallow = w->patch_stat(1, "normal_force");
  report("normal force of both, N", deep + shallow);
  // One lattice of 48 x 96 over both, in one plane, has 9110 N; apart they have 9906 N.
  expect_error("sum beside one fine lattice over both", (deep + shallow) / 9110 - 1, 0.01);
}

TEST_F(wheel_rail, vertical_force_finds_the_height) {
  for (const Row& r : rows) {
    const auto w = make(r.side);
    place(*w, r);
    w->prescribe_vertical(2, 10000);
    ASSERT_EQ(w->solve(), Status::ok) << name_of(r);
    expect_error(name_of(r) + ": vertical force", w->stat("vertical_force") / 10000 - 1, 2e-6);
    // CONTACT's height is known to 5e-5 mm. A percent of the force is 6e-4 mm on the flange.
    expect_error(name_of(r) + ": z of the wheelset, mm", w->stat("z") - r.z, r.y > 6 ? 1e-3 : 1e-4);
    double force[3];
    w->resultant(false, force, nullptr);
    expect_error(name_of(r) + ": resultant", force[2] / -10000 - 1, 2e-6);
  }
}

TEST_F(wheel_rail, left_wheels_mirror_right_ones) {
  for (Row r : rows) {
    const auto first = make(r.side), second = make(-r.side);
    place(*first, r);
    const double position[6] = {0, -r.y, r.z, -r.roll, -2.4e-3 * r.y, 0},
                 velocity[6] = {2000, 0, 0, 0, 0, r.pitch_rate};
    second->set_position(position);
    second->set_velocity(velocity);
    ASSERT_EQ(first->solve(), second->solve());
    double f[2][3], m[2][3];
    first->resultant(true, f[0], m[0]);
    second->resultant(true, f[1], m[1]);
    EXPECT_EQ(f[0][0], f[1][0]);
    EXPECT_EQ(f[0][1], -f[1][1]);
    EXPECT_EQ(f[0][2], f[1][2]);
    EXPECT_EQ(m[0][0], -m[1][0]);
    EXPECT_EQ(m[0][1], m[1][1]);
    EXPECT_EQ(m[0][2], -m[1][2]);
    EXPECT_EQ(first->patch_stat(0, "y"), -second->patch_stat(0, "y"));
    EXPECT_EQ(first->patch_stat(0, "spin"), -second->patch_stat(0, "spin"));
  }
}

TEST_F(wheel_rail, units_do_not_matter) {
  std::array<double, 3> found[2];
  for (const int u : {0, 1}) {
    make_bodies(u == 0 ? 1 : 1e-3);
    const auto w = make(1);
    place(*w, rows[2]);
    ASSERT_EQ(w->solve(), Status::ok);
    w->resultant(false, found[u].data(), nullptr);
  }
  for (std::size_t i = 0; i < 3; ++i) expect_error("mm and m", (found[1][i] - found[0][i]) / found[0][2], 1e-8);
}

// A rail that is shifted and turned with the wheelset on it carries the same forces.
TEST_F(wheel_rail, deviations_of_the_rail_are_motions_of_the_wheelset) {
  const Row& r = rows[2];
  const auto nominal = make(1), moved = make(1);
  place(*nominal, r);
  ASSERT_EQ(nominal->solve(), Status::ok);
  const double deviation[3] = {1.5, -0.7, 0}, rate[3] = {0, 0, 0};
  moved->set_rail_deviation(deviation, rate);
  Row with = r;
  with.y += 1.5;
  with.z -= 0.7;
  place(*moved, with);
  const double position[6] = {0, with.y, with.z, r.roll, 2.4e-3 * r.y, 0};
  moved->set_position(position);
  ASSERT_EQ(moved->solve(), Status::ok);
  double f[2][3];
  nominal->resultant(false, f[0], nullptr);
  moved->resultant(false, f[1], nullptr);
  for (int i = 0; i < 3; ++i) expect_error("force on a shifted rail", (f[1][i] - f[0][i]) / f[0][2], 1e-9);
  expect_error("patch moves with it", moved->patch_stat(0, "y") - nominal->patch_stat(0, "y") - 1.5, 1e-9);
}

// A cylinder on an arc has curvatures 1/R and 1/r, Hertz's approach and pressure; rolling without creepage it has no
// force.
TEST_F(wheel_rail, hertz_is_there) {
  const double radius = 300, crown = 80, load = 50000;
  const double line[2] = {20, 0};
  wheel->set_profile_shape("line", 2, line);
  const double parameter[2] = {-crown, 79};
  rail->set_profile_shape("arc", 2, parameter);
  for (const double yaw : {0.0, 0.02}) {
    WheelRail w(context, wheel, rail, 1);
    w.set_track(1500, 14, 0);
    w.set_wheelset(1500 - 2 * 100.0, -100 - (std::sqrt(80 * 80 - 66 * 66)), radius);
    w.set_friction(mu);
    const double position[6] = {0, 0, 0, 0, yaw, 0}, velocity[6] = {1000, 0, 0, 0, 0, -1000 / radius};
    w.set_position(position);
    w.set_velocity(velocity);
    w.prescribe_vertical(2, load);
    w.set_real("accuracy", 0.005);
    ASSERT_EQ(w.solve(), Status::ok);
    const closed_forms::Elastic steel{.shear = 82000, .poisson = 0.28};
    const auto hertz =
        closed_forms::hertz_from_load(0.5 / radius, 0.5 / crown, closed_forms::effective_modulus(steel, steel), load);
    expect_error("approach beside Hertz's", w.patch_stat(0, "overlap") / hertz.approach - 1, 5e-3);
    expect_error("largest pressure", w.patch_stat(0, "max_pressure") / hertz.p0 - 1, 1e-2);
    expect_error("lateral creepage is the yaw", w.patch_stat(0, "lateral_creepage") + yaw, 1e-4);
  }
}

TEST_F(wheel_rail, results_are_those_of_the_last_solve) {
  const auto w = make(1);
  place(*w, rows[2]);
  ASSERT_EQ(w->solve(), Status::ok);
  std::array<double, 3> force[2], moment[2];
  w->resultant(true, force[0].data(), moment[0].data());
  const double y = w->patch_stat(0, "y");
  place(*w, rows[3]);
  w->resultant(true, force[1].data(), moment[1].data());
  EXPECT_EQ(force[0], force[1]);
  EXPECT_EQ(moment[0], moment[1]);
  EXPECT_EQ(w->patch_stat(0, "y"), y);
}

// The wheel goes from the tread through both patches on to the flange: the force follows without a jump.
TEST_F(wheel_rail_long, forces_are_continuous) {
  const auto w = make(1);
  w->prescribe_vertical(2, 10000);
  constexpr int steps = 300;
  std::array<double, 3> before{}, last{};
  double worst = 0;
  for (int i = 0; i <= steps; ++i) {
    const double y = 4.7 + 0.7 * i / steps;
    const double position[6] = {0, y, 0, 0, 2.4e-3 * y, 0}, velocity[6] = {2000, 0, 0, 0, 0, -4.34};
    w->set_position(position);
    w->set_velocity(velocity);
    ASSERT_EQ(w->solve(), Status::ok) << y;
    std::array<double, 3> now{};
    w->resultant(false, now.data(), nullptr);
    if (i > 1)
      for (std::size_t c = 0; c < 3; ++c) worst = std::max(worst, std::abs(now[c] - 2 * last[c] + before[c]));
    before = last;
    last = now;
  }
  // Slopes change by up to 15 N a step where patches come and go.
  expect_error("greatest second difference over the friction limit", worst / (mu * 10000), 0.01);
}

TEST_F(wheel_rail, what_is_not_in_contact_is_told) {
  const auto w = make(1);
  Row r = rows[2];
  r.z = -5;
  place(*w, r);
  EXPECT_EQ(w->solve(), Status::no_contact);
  EXPECT_EQ(w->patches(), 0);
  const double beside[6] = {0, 150, 0, 0, 0, 0};
  w->set_position(beside);
  EXPECT_EQ(w->solve(), Status::derailed);
  EXPECT_EQ(w->patches(), 0);
  w->prescribe_vertical(2, 10000);
  try {
    w->solve();
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.status(), Status::err_load);
    EXPECT_NE(std::string(e.what()).find("derailed"), std::string::npos) << e.what();
  }
  place(*w, rows[2]);
  EXPECT_EQ(w->solve(), Status::ok) << "the wheel stays usable";
}

TEST_F(wheel_rail, bad_input_is_refused) {
  WheelRail w(context, wheel, rail, 1);
  const auto refused = [&](auto call, Status status, const char* words) {
    try {
      call();
      FAIL() << words;
    } catch (const Error& e) {
      EXPECT_EQ(e.status(), status);
      EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
    }
  };
  refused([&] { w.solve(); }, Status::err_state, "rollcon_wheelrail_set_track");
  refused([&] { w.patches(); }, Status::err_state, "no solution yet");
  refused([&] { WheelRail(context, wheel, rail, 0); }, Status::err_argument, "allowed: -1 (left), 1 (right)");
  refused([&] { w.set_track(-1, 14, 0); }, Status::err_argument, "gauge is -1");
  refused([&] { w.set_track(1435, 500, 0); }, Status::err_argument, "gauge_height is 500");
  refused([&] { w.set_friction(11); }, Status::err_argument, "is 11; allowed: 0 to 10");
  const double still[6] = {0, 0, 0, 0, 0, 1}, broken[6] = {0, 0, NAN, 0, 0, 0};
  const auto stopped = make(1);
  place(*stopped, rows[2]);
  stopped->set_velocity(still);
  refused([&] { stopped->solve(); }, Status::err_argument, "forward speed");
  refused([&] { w.set_position(broken); }, Status::err_nonfinite, "entry 2 of position");
  const auto bare = std::make_shared<Body>(context, static_cast<std::int32_t>(BodyKind::halfspace));
  refused([&] { WheelRail(context, bare, rail, 1); }, Status::err_state, "no profile");
}

}  // namespace
// The next solve has the profiles and constants that the bodies have then, whatever was called in which order.
TEST_F(wheels, follow_profiles_and_materials_that_are_set_later) {
  const auto pressure = [](WheelRail& w) {
    EXPECT_GE(static_cast<int>(w.solve()), 0);
    return w.patch_stat(0, "max_pressure");
  };
  for (const bool of_wheel : {true, false}) {
    SetUp();
    const auto used = make();
    used->prescribe_vertical(2, 10000);
    const double before = pressure(*used);
    used->snapshot(0);
    const double larger = 1.03;
    (of_wheel ? wheel : rail)->set_profile_shape(of_wheel ? "s1002" : "60e1", 1, &larger);
    refused([&] { used->rollback(0); }, Status::err_state, {"other bodies"});
    const double after = pressure(*used);
    const auto fresh = make();
    fresh->prescribe_vertical(2, 10000);
    EXPECT_NEAR(after, pressure(*fresh), 1e-5 * after);
    EXPECT_NE(after, before);
    EXPECT_NEAR(used->stat("vertical_force"), 10000, 0.1);
    wheel->set_elastic(0, 1000000, 0.28);
    const double stiffer = pressure(*used), copied = pressure(*used->copy());
    EXPECT_GT(stiffer, 1.1 * after);
    EXPECT_NEAR(copied, stiffer, 1e-5 * stiffer);
  }
}

TEST_F(wheels, refuse_profiles_that_are_turned) {
  const auto turned = [](const Body& body, double y, double z) {
    std::vector<double> points;
    for (int i = 0; i < 700; ++i) {
      const Vec2 x = body.profile_point(std::min(body.profile_length() * i / 699, body.profile_length())).x;
      points.insert(points.end(), {y * x[0], z * x[1]});
    }
    return points;
  };
  for (const double z : {1.0, -1.0}) {
    SetUp();
    const auto points = turned(*wheel, z == 1 ? -1 : 1, z);
    wheel->set_profile(700, points.data(), 0);
    refused([&] { make(); }, Status::err_argument, {"wheel's profile", "the flange at lesser y"});
  }
  SetUp();
  const auto points = turned(*rail, 1, -1);
  rail->set_profile(700, points.data(), 0);
  refused([&] { make(); }, Status::err_argument, {"rail's profile", "z down"});
}

TEST_F(wheels, stand_on_a_rail_without_a_side_by_its_origin) {
  const double flat[] = {-40, 0, 0, 0, 40, 0};
  std::vector<double> crown;
  for (int i = -50; i <= 50; ++i) {
    const double t = 0.3 * i / 50;
    crown.insert(crown.end(), {100 * std::sin(t), 100 * (std::cos(t) - 1)});
  }
  rail->set_profile(3, flat, 0);
  wheel->set_profile(101, crown.data(), 0);
  WheelRail w(context, wheel, rail, 1);
  w.set_track(1435, 0, 0);
  w.set_wheelset(1435, 0, 460);
  const double by_angle[] = {-0.5, 0.2, 0.5, 0.2}, velocity[6] = {2000, 0, 0, 0, 0, -2000.0 / 460}, at[6] = {};
  w.set_velocity(velocity);
  w.set_position(at);
  w.prescribe_vertical(2, 10000);
  refused([&] { w.solve(); }, Status::err_state, {"rollcon_wheelrail_set_friction"});
  w.set_friction("by_angle", 4, by_angle);
  EXPECT_GE(static_cast<int>(w.solve()), 0);
  EXPECT_NEAR(w.patch_stat(0, "y"), 717.5, 1e-3);
  EXPECT_NEAR(w.stat("vertical_force"), 10000, 0.1);
}

}  // namespace rollcon
