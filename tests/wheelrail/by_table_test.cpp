/// Tests wheels whose creep forces come from the table that ships with the library.

#include <algorithm>
#include <array>
#include <cmath>

#include "framing/hertz.hpp"
#include "wheel_rail_fixture.hpp"
#include "wheelrail/solve_positions.hpp"

namespace rollcon {
namespace {

class wheels_by_table : public wheels {
 protected:
  std::shared_ptr<const ForceTable> table{ForceTable::standard(context)};
};

// The shifts have one patch and two.
TEST_F(wheels_by_table, forces_are_nearly_those_of_full_solutions) {
  auto full = make(), fast = make(), faster = make();
  fast->set_table(table);
  faster->set_table(table);
  faster->set_int("hertzian", 1);
  for (WheelRail* w : {full.get(), fast.get(), faster.get()}) {
    w->set_real("accuracy", 0.02);
    w->prescribe_vertical(2, 10000);
  }
  for (const double y : {1.0, 2.0, 5.0, 6.5}) {
    for (WheelRail* w : {full.get(), fast.get(), faster.get()}) {
      place(*w, y);
      EXPECT_EQ(w->solve(), Status::ok);
    }
    ASSERT_EQ(full->patches(), fast->patches());
    ASSERT_EQ(full->patches(), faster->patches());
    for (std::int64_t i = 0; i < full->patches(); ++i) {
      const double bound = mu * full->patch_stat(i, "normal_force"),
                   arm = std::sqrt(full->patch_stat(i, "area") / 3.14), creep = 1e-2;
      EXPECT_EQ(full->patch_stat(i, "by_table"), 0);
      for (const WheelRail* w : {fast.get(), faster.get()}) {
        const bool hertzian = w == faster.get();
        // Between tread and flange, where a wheel without yaw touches at other places, patches are solved in full.
        const bool mapped = y != 5;
        EXPECT_EQ(w->patch_stat(i, "by_table"), mapped ? 1 : 0);
        EXPECT_EQ(w->patch_stat(i, "hertzian"), mapped && hertzian ? 1 : 0);
        const auto off = [&](const char* name) { return w->patch_stat(i, name) - full->patch_stat(i, name); };
        const std::string at =
            (hertzian ? "hertzian, y " : "y ") + std::to_string(y) + ", patch " + std::to_string(i) + ": ";
        expect_error(at + "normal force", off("normal_force") / full->patch_stat(i, "normal_force"),
                     hertzian ? 0.03 : 1e-3);
        expect_error(at + "force", std::hypot(off("longitudinal_force"), off("lateral_force")) / bound,
                     hertzian ? 0.03 : 0.015);
        expect_error(at + "moment", off("spin_moment") / (bound * arm), y > 6 ? 0.04 : 0.015);
        expect_error(at + "friction power over mu Fn V / 100", off("friction_power") / (bound * 2000 * creep),
                     hertzian ? 0.15 : 0.02);
        expect_error(at + "area", off("area") / full->patch_stat(i, "area"), hertzian ? 0.06 : 1e-3);
      }
    }
    expect_error("height over overlap", (faster->stat("z") - full->stat("z")) / full->patch_stat(0, "overlap"), 0.04);
  }
}

// Only pressures are solved for, and no field beyond the gap is computed.
TEST_F(wheels_by_table, contacts_have_no_friction) {
  auto w = make();
  w->set_table(table);
  w->prescribe_vertical(2, 10000);
  ASSERT_EQ(w->solve(), Status::ok);
  const auto contact = w->contact(0);
  EXPECT_EQ(contact->stat("tangential_iterations"), 0);
  EXPECT_EQ(contact->stat("operator_applications"), 0);
  EXPECT_EQ(contact->stat("fields_derived"), 0);
  double force[3];
  contact->resultant(InAxes::local, force, nullptr);
  EXPECT_EQ(std::hypot(force[0], force[1]), 0);
  w->set_table(nullptr);
  ASSERT_EQ(w->solve(), Status::ok);
  contact->resultant(InAxes::local, force, nullptr);
  EXPECT_GT(std::hypot(force[0], force[1]), 0);
}

// A ball's wheel and rail head are paraboloids to (size / radius)^2, with Hertz's load in closed form.
TEST_F(wheels_by_table, hertzian_load_of_round_profiles_is_that_of_hertz) {
  const double radius = 300, head[] = {-radius, 0.99 * radius}, line[] = {80, 0};
  rail->set_profile_shape("arc", 2, head);
  wheel->set_profile_shape("line", 2, line);
  auto w = std::make_unique<WheelRail>(context, wheel, rail, 1);
  w->set_track(1500, 0.01 * radius, 0);
  w->set_wheelset(1360, -100, 460);
  w->set_friction(mu);
  w->set_table(table);
  w->set_int("hertzian", 1);
  const double velocity[6] = {2000, 0, 0, 0, 0, -4.3459};
  w->set_velocity(velocity);
  w->prescribe_vertical(2, 10000);
  place(*w, 0);
  ASSERT_EQ(w->solve(), Status::ok);
  ASSERT_EQ(w->patches(), 1);
  const double modulus = 82000 / (1 - 0.28);
  const HertzContact hertz = hertz_by_load({0.5 / 460, 0.5 / radius, 0}, modulus, 10000);
  // Loads of strips are right in the mean over ratios of axes; those of ellipses of this ratio are 2e-4 too large.
  expect_error("overlap", w->patch_stat(0, "overlap") / hertz.approach - 1, 2e-4);
  expect_error("largest pressure", w->patch_stat(0, "max_pressure") / hertz.pressure - 1, 1e-4);
  expect_error("area", w->patch_stat(0, "area") / (3.14159265358979 * hertz.larger * hertz.smaller) - 1, 1e-4);
}

TEST_F(wheels_by_table, hertzian_patches_have_no_solution_of_their_own) {
  auto w = make();
  w->set_table(table);
  w->prescribe_vertical(2, 10000);
  ASSERT_EQ(w->solve(), Status::ok);
  w->set_int("hertzian", 1);
  ASSERT_EQ(w->solve(), Status::ok);
  const auto contact = w->contact(0);
  double force[3];
  refused([&] { contact->resultant(InAxes::local, force, nullptr); }, Status::err_state, {"no solution"});
  refused([&] { w->set_int("hertzian", 2); }, Status::err_option, {"hertzian"});
  w->snapshot(0);
  const double expected = w->patch_stat(0, "lateral_force");
  place(*w, 3);
  ASSERT_EQ(w->solve(), Status::ok);
  w->rollback(0);
  EXPECT_EQ(w->patch_stat(0, "lateral_force"), expected);
  EXPECT_EQ(w->patch_stat(0, "hertzian"), 1);
  w->set_table(nullptr);
  ASSERT_EQ(w->solve(), Status::ok);
  EXPECT_EQ(w->patch_stat(0, "hertzian"), 0);
  contact->resultant(InAxes::local, force, nullptr);
}

TEST_F(wheels_by_table, states_go_back_and_copies_go_on) {
  auto w = make();
  w->set_table(table);
  w->prescribe_vertical(2, 10000);
  ASSERT_EQ(w->solve(), Status::ok);
  w->snapshot(0);
  place(*w, 3);
  ASSERT_EQ(w->solve(), Status::ok);
  const double expected = w->patch_stat(0, "lateral_force");
  w->rollback(0);
  auto other = w->copy();
  w->set_table(nullptr);
  place(*other, 3);
  ASSERT_EQ(other->solve(), Status::ok);
  EXPECT_EQ(other->patch_stat(0, "lateral_force"), expected);
  EXPECT_EQ(other->patch_stat(0, "by_table"), 1);
}

// A table for another Poisson's ratio has none of these patches.
TEST_F(wheels_by_table, what_the_table_does_not_have_is_solved) {
  ForceTable rubber(context);
  EXPECT_THROW(make()->set_table(std::make_shared<const ForceTable>(context)), Error);
  const double poisson = 0.45;
  rubber.set_poissons(1, &poisson);
  rubber.set_ratios(4, 0.5, 2);
  rubber.set_resolution(4, 4, 4);
  rubber.set_frame(6, 6);
  rubber.make(0, 1);
  auto w = make(), full = make();
  w->set_table(std::shared_ptr<const ForceTable>(&rubber, [](const ForceTable*) {}));
  for (WheelRail* each : {w.get(), full.get()}) {
    each->prescribe_vertical(2, 10000);
    ASSERT_EQ(each->solve(), Status::ok);
  }
  EXPECT_EQ(w->patch_stat(0, "by_table"), 0);
  expect_error("lateral force", w->patch_stat(0, "lateral_force") / full->patch_stat(0, "lateral_force") - 1, 1e-6);
}

TEST_F(wheels_by_table, have_no_wear) {
  auto w = make();
  w->set_table(table);
  const std::array<double, 6> position{0, 2, 0.2, 0, 0, 0}, velocity{2000, 0, 0, 0, 0, -4.3459};
  const double rate = 1e-9;
  std::array<double, 9> depth{};
  const WearLaw law("archard", {&rate, 1});
  const auto wear = [&] {
    find_wear(*w, {1, position.data(), velocity.data()}, {.law = law, .points = 9, .wheel = depth.data()}, nullptr);
  };
  refused(wear, Status::err_state, {"wear", "rollcon_wheelrail_set_table"});
  w->set_table(nullptr);
  wear();
  EXPECT_GT(*std::max_element(depth.begin(), depth.end()), 0);
}

}  // namespace
}  // namespace rollcon
