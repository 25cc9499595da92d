/// Tests that what is beyond sense or beyond the profiles has a status or a text of its own.

#include "wheel_rail_fixture.hpp"

using namespace rollcon;

namespace {

class limits : public wheels {
 protected:
  void SetUp() override {
    wheels::SetUp();
    context->set_log(
        2, [](std::int32_t, const char* text, void* user) { *static_cast<std::string*>(user) += text; }, &told);
  }
  void expect_told(std::initializer_list<const char*> words) const {
    for (const char* w : words) EXPECT_NE(told.find(w), std::string::npos) << told;
  }

  std::string told;
};

}  // namespace

TEST_F(limits, overlaps_that_no_metal_bears_are_too_deep) {
  const auto w = make();
  w->prescribe_vertical(2, 10000);
  ASSERT_EQ(w->solve(), Status::ok);
  const double z = w->stat("z"), overlap = w->patch_stat(0, "overlap");
  w->prescribe_vertical(1, 0);
  place(*w, 2, z + 0.43 - overlap);
  EXPECT_EQ(w->solve(), Status::ok) << "under a thousandth of the radius";
  EXPECT_EQ(told, "");
  place(*w, 2, z + 0.8);
  EXPECT_EQ(w->solve(), Status::too_deep);
  report("overlap over the radius, 0.8 mm too deep", w->patch_stat(0, "overlap") / 460);
  expect_told({"overlap by 0.82", "(460)", "check z and all units"});
  place(*w, 2, z);
  EXPECT_EQ(w->solve(), Status::ok) << "the wheel stays usable";
}

// A third patch begins to touch near y = 4.77. However little it carries, strips fit it.
TEST_F(limits, patches_that_carry_nearly_nothing_are_solved) {
  const auto w = make();
  w->prescribe_vertical(2, 33000);
  double least = 33000;
  for (double y = 4.765; y < 4.785; y += 0.001) {
    const double position[6] = {0, y, 0, 0, 0, 0};
    w->set_position(position);
    told.clear();
    EXPECT_EQ(w->solve(), Status::ok) << y;
    EXPECT_EQ(told, "");
    for (std::int64_t k = 0; k < w->patches(); ++k)
      if (const double force = w->patch_stat(k, "normal_force"); force > 0) least = std::min(least, force);
  }
  report("least normal force of a patch", least);
  EXPECT_LT(least, 330);
}

TEST_F(limits, a_wheel_within_the_rail_is_refused) {
  const auto w = make();
  place(*w, 2, 60);
  refused([&] { w->solve(); }, Status::err_argument, {"z is 60 (y is 2)", "a tenth of the wheel's radius (460)"});
  refused([&] { w->patches(); }, Status::err_state, {"no solution"});
}

TEST_F(limits, forces_that_nothing_carries) {
  const auto w = make();
  w->prescribe_vertical(2, 2e6);
  EXPECT_EQ(w->solve(), Status::too_deep);
  expect_error("two meganewton are met nevertheless", w->stat("vertical_force") / 2e6 - 1, 2e-6);
  expect_told({"check the vertical force and all units"});
  w->prescribe_vertical(2, 1e13);
  refused([&] { w->solve(); }, Status::err_load, {"the vertical force 1e+13", "a tenth of its radius"});
  w->prescribe_vertical(2, 10000);
  EXPECT_EQ(w->solve(), Status::ok) << "the wheel stays usable";
}

TEST_F(limits, beside_the_rail_is_not_above_it) {
  const auto w = make();
  place(*w, 2, -5);
  EXPECT_EQ(w->solve(), Status::no_contact);
  EXPECT_EQ(told, "");
  const double beside[6] = {0, 150, 0, 0, 0, 0};
  w->set_position(beside);
  EXPECT_EQ(w->solve(), Status::derailed);
  expect_told({"beside its rail (y is 150)"});
}

// A cylinder ends in the middle of a round rail.
TEST_F(limits, ends_of_profiles_are_told) {
  const double line[2] = {20, 0}, arc[2] = {-80, 79};
  wheel->set_profile_shape("line", 2, line);
  rail->set_profile_shape("arc", 2, arc);
  WheelRail w(context, wheel, rail, 1);
  const double from_gauge = std::sqrt(80 * 80 - 66 * 66), velocity[6] = {1000, 0, 0, 0, 0, -1000 / 300.0};
  w.set_track(1500, 14, 0);
  w.set_wheelset(1300, -100 - from_gauge, 300);
  w.set_friction(mu);
  w.set_velocity(velocity);
  w.prescribe_vertical(2, 50000);
  for (const double y : {0.0, -19.0}) {
    const double position[6] = {0, y, 0, 0, 0, 0};
    w.set_position(position);
    EXPECT_EQ(w.solve(), y < 0 ? Status::rim_contact : Status::ok);
    EXPECT_EQ(w.patch_stat(0, "cut"), y < 0 ? 1 : 0);
  }
  expect_told({"patch 0", "ends where a profile does"});
}

// The flange's root in a turned wheelset: two overlaps count as one patch by 0.69 and as two by the rest. How far they
// give way under each other does not change suddenly where the middles of patches come near each other.
TEST_F(limits, patches_about_to_merge_do_not_jump) {
  const auto w = make();
  w->set_track(1435, 14, 0.025);
  w->set_real("spacing_along", 3);
  w->set_real("spacing_across", 0.5);
  double before = 0;
  for (const double z : {-0.7324, -0.73238, -0.73236}) {
    const double position[6] = {0, 6.589990571, z, 0, 0.01317321, 0};
    w->set_position(position);
    ASSERT_TRUE(is_answer(w->solve()));
    ASSERT_EQ(w->patches(), 3);
    const double force = w->stat("vertical_force");
    if (before > 0) expect_error("change of the vertical force over 20 nm", force / before - 1, 1e-3);
    before = force;
  }
}

// A neighbour of a neck, and the strips beside one, were found on one side alone of these places.
TEST_F(limits, forces_at_necks_do_not_jump) {
  const struct {
    double accuracy, y, yaw, roll, vy, pitch, vyaw, vroll, vz;
  } places[] = {{0.01, 5.25373579527, -0.0013328591137, -0.000420699840, 107.13308921, -2.7515e-4, 0.0933639749,
                 -0.00683624585, -0.31987284808},
                {0.02, 5.35396041667, -0.0044614831569, 0.0002388935256, -24.00035512, -4.3223e-3, 0.0370136139,
                 -0.01782320111, 6.5296534641}};
  for (auto* body : {&wheel, &rail}) (*body)->set_elastic(0, 2.1e5, 0.28);
  for (const auto& p : places) {
    std::array<double, 6> found[2];
    for (const int side : {0, 1}) {
      const auto w = make();
      w->set_track(1435, 14, 0.025);
      w->set_real("accuracy", p.accuracy);
      w->prescribe_vertical(2, 1e5);
      const double position[6] = {0, p.y + (side == 0 ? -1e-6 : 1e-6), 0, p.roll, p.yaw, 0},
                   velocity[6] = {2e4, p.vy, p.vz, p.vroll, p.vyaw, -2e4 / 460 * (1 + p.pitch)};
      w->set_position(position);
      w->set_velocity(velocity);
      ASSERT_EQ(w->solve(), Status::ok);
      w->resultant(false, found[side].data(), found[side].data() + 3);
    }
    for (std::size_t k = 0; k < 6; ++k)
      expect_error("change within 2e-6 mm over the friction limit",
                   (found[1][k] - found[0][k]) / 3e4 / (k < 3 ? 1 : 460), 1e-4);
  }
}

// One height more than the secant method needs is one solve too many, whatever patches are solved on.
TEST_F(limits, heights_of_small_moves_take_three_solves) {
  for (const bool conformal : {false, true}) {
    const auto w = make();
    w->set_real("accuracy", 0.02);
    w->set_int("conformal", conformal ? 1 : 0);
    w->prescribe_vertical(2, 1e5);
    place(*w, 0.5);
    ASSERT_EQ(w->solve(), Status::ok);
    for (const double y : {0.51, 0.52}) {
      place(*w, y);
      const double before = w->stat("solves");
      ASSERT_EQ(w->solve(), Status::ok);
      EXPECT_LE(w->stat("solves") - before, 3) << (conformal ? "conformal" : "strips");
    }
  }
}
