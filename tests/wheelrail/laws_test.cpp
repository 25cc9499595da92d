/// Tests laws of friction, layers and heat of wheels on rails: each beside a contact of its own with the law, branches
/// along a run, states to the last bit, derivatives, and what is refused.

#include <cmath>
#include <cstdio>
#include <functional>

#include "contact/solver.hpp"
#include "framing/automatic_frames.hpp"
#include "tables/force_table.hpp"
#include "wheel_rail_fixture.hpp"
#include "wheelrail/rail_place.hpp"

namespace rollcon {
namespace {

/// Holds what is set on a wheel on its rail and, with the same calls, on a contact.
struct Law {
  const char* name;
  std::vector<double> parameters;
  double memory = 0, layer = 0, stress = 0;
};
// Speeds of 2000 mm/s, creepages of a thousandth.
const std::vector<Law> laws = {
    {"linear", {0.15, 0.2, 10}},
    {"rational", {0.1, 0.25, 5}},
    {"exponential", {0.15, 0.2, 5, 0.05, 20}},
    {"exponential", {0.15, 0.2, 2}, 0.002},
    {"orthotropic", {0.4, 0.2, 0.5}},
    {"temperature", {20, 0.4, 60, 0.2}},
    {"coulomb", {0.3}, 0, 5e-6},
    {"coulomb", {0.3}, 0, 2e-6, 100},
};

template <class Given>
void set_law(Given& on, const Law& law) {
  on.set_friction(law.name, static_cast<std::int32_t>(law.parameters.size()), law.parameters.data());
  on.set_friction_memory(law.memory, 0.1);
  on.set_layer(law.layer, law.stress, 0);
  for (const std::int32_t body : {1, 2}) on.set_heat(body, 50, 3.7, 20);
}

std::string name_of(const Law& law) {
  return std::string(law.name) + (law.memory > 0 ? ", memory" : "") +
         (law.stress > 0  ? ", flowing layer"
          : law.layer > 0 ? ", layer"
                          : "");
}

class wheel_laws : public wheels {
 protected:
  std::unique_ptr<WheelRail> make_with(const Law& law, double accuracy, std::int32_t side = 1) const {
    auto w = make(side);
    set_law(*w, law);
    w->set_real("accuracy", accuracy);
    w->prescribe_vertical(2, 10000);
    return w;
  }
  static std::vector<double> totals(const WheelRail& w) {
    std::vector<double> t(8);
    w.resultant(false, t.data(), t.data() + 3);
    t[6] = w.stat("z");
    t[7] = w.stat("friction_power");
    return t;
  }
  static void pitch(WheelRail& w, double rate) {
    const double velocity[6] = {2000, 0, 0, 0, 0, rate};
    w.set_velocity(velocity);
  }
};

// A contact with frames and a law of its own takes no more from the wheel than poses, velocities and approach.
TEST_F(wheel_laws, are_those_of_a_contact) {
  const Vec3 centre{0, 0, -460}, axis{0, 1, 0};
  const std::shared_ptr<Body> turning = wheel->with_profile_alone(), resting = rail->with_profile_alone();
  turning->revolve_profile(centre.data(), axis.data(), 460);
  const RailShape shape = place_rail(rail->profile(), {1435, 14, std::atan(1.0 / 40)});
  resting->extrude_profile(shape.origin.data(), shape.along.data(), shape.down.data());
  for (const Law& law : laws)
    for (const std::int32_t side : {1, -1}) {
      const auto w = make_with(law, 0.005, side);
      place(*w, 2.0 * side);
      ASSERT_EQ(w->solve(), Status::ok) << name_of(law);
      ASSERT_EQ(w->patches(), 1);
      const double plain_longitudinal = [&] {
        const auto coulomb = make(side);
        coulomb->prescribe_vertical(2, 10000);
        coulomb->set_friction(0.35);
        place(*coulomb, 2.0 * side);
        EXPECT_EQ(coulomb->solve(), Status::ok);
        return coulomb->patch_stat(0, "longitudinal_force");
      }();
      Contact own(context, turning, resting, nullptr, make_frame_maker);
      const Scene& patch = w->contact(0)->scene;
      own.scene.take_over(patch);
      own.scene.set_friction_across(0, nullptr);
      set_law(own.scene, law);
      const Status status = own.solve();
      EXPECT_TRUE(status == Status::ok || status == Status::inaccurate) << name_of(law);
      double force[3];
      own.resultant(InAxes::local, force, nullptr);
      const double normal = w->patch_stat(0, "normal_force");
      const std::string name = name_of(law) + (side > 0 ? ", right" : ", left");
      expect_error(name + ": normal force", -force[2] / normal - 1, 0.003);
      expect_error(name + ": along over mu Fn", (w->patch_stat(0, "longitudinal_force") - force[0]) / (0.3 * normal),
                   0.015);
      expect_error(name + ": across over mu Fn", (w->patch_stat(0, "lateral_force") - side * force[1]) / (0.3 * normal),
                   0.015);
      expect_error(name + ": power", w->stat("friction_power") / own.stat("friction_power") - 1, 0.03);
      EXPECT_GT(std::abs(w->patch_stat(0, "longitudinal_force") - plain_longitudinal), 0.01 * 0.3 * normal)
          << "the law does not show";
    }
}

// The slip speed grows and falls again, through the top of the force: both ways are one branch, without jumps.
TEST_F(wheel_laws, that_fall_follow_one_branch) {
  const Law steep{"rational", {0.05, 0.4, 3}};
  const auto run = make_with(steep, 0.02), fresh = make_with(steep, 0.02);
  const double rolling = -2000 / 458.7;
  double up[40], jump = 0, off = 0, apart = 0;
  for (const bool rising : {true, false})
    for (int i = 0; i < 40; ++i) {
      const int at = rising ? i : 39 - i;
      for (WheelRail* w : {run.get(), fresh.get()}) {
        if (w == fresh.get()) w->reset();
        pitch(*w, rolling * (1 + 2.5e-4 * at));
        place(*w, 0);
        ASSERT_EQ(w->solve(), Status::ok) << at;
      }
      const double now = totals(*run)[0], alone = totals(*fresh)[0];
      if (rising) up[at] = now;
      if (at > 0 && at < 39 && !rising) off = std::max(off, std::abs(now - up[at]));
      if (rising && i > 0) jump = std::max(jump, std::abs(now - up[i - 1]));
      apart = std::max(apart, std::abs(now - alone));
    }
  expect_error("greatest change from step to step", jump / 4500, 0.03);
  expect_error("greatest difference of the ways up and down", off / 4500, 1e-5);
  expect_error("greatest difference of solves from nothing", apart / 4500, 1e-5);
}

TEST_F(wheel_laws, are_restored_to_the_last_bit) {
  for (const Law& law : laws) {
    const auto never = make_with(law, 0.02), tried = make_with(law, 0.02);
    for (const double y : {2.0, 2.1, 5.0, 5.05}) {
      tried->snapshot(0);
      place(*tried, 1);
      set_law(*tried, {"coulomb", {0.1}, 0, 1e-6});
      tried->solve();
      tried->rollback(0);
      const auto copied = tried->copy();
      for (WheelRail* w : {never.get(), tried.get(), copied.get()}) {
        place(*w, y);
        ASSERT_GE(w->solve(), Status::ok) << name_of(law);
      }
      EXPECT_EQ(totals(*tried), totals(*never)) << name_of(law) << ", y " << y;
      EXPECT_EQ(totals(*copied), totals(*never)) << name_of(law) << ", y " << y;
      copied->reset();
      ASSERT_GE(copied->solve(), Status::ok);
      for (const std::size_t c : {0U, 1U})
        expect_error(name_of(law) + ", y " + std::to_string(y) + ": force beside that from nothing",
                     (totals(*copied)[c] - totals(*never)[c]) / 3000, 2e-5);
    }
    const auto before = totals(*tried);
    tried->snapshot(1);
    place(*tried, 1);
    tried->solve();
    tried->rollback(1);
    EXPECT_EQ(totals(*tried), before) << name_of(law);
  }
}

TEST_F(wheel_laws, have_derivatives) {
  for (const Law& law : laws) {
    const auto w = make_with(law, 0.02);
    place(*w, 2);
    ASSERT_EQ(w->solve(), Status::ok);
    place(*w, 2, w->stat("z"));
    w->prescribe_vertical(1, 0);
    const double rate = -4.3459, step = 2e-5 * 2000 / 460;
    pitch(*w, rate);
    ASSERT_EQ(w->solve(), Status::ok);
    const double own = w->derivative(11).force[0];
    double side[2];
    for (const int s : {0, 1}) {
      pitch(*w, rate + (s == 0 ? -step : step));
      ASSERT_EQ(w->solve(), Status::ok);
      side[s] = totals(*w)[0];
    }
    const double difference = (side[1] - side[0]) / (2 * step);
    expect_error(name_of(law) + ": force along by the pitch rate", own / difference - 1, 0.01);
  }
}

// Each point has parameters of its own: a patch that slides everywhere has the coefficient of its inclination and
// speed.
TEST_F(wheel_laws, by_angle_have_their_own_parameters) {
  const double head[] = {0.2, 0.15, 500}, face[] = {0.05, 0.1, 100};
  const double rows[] = {-1.1, face[0], face[1], face[2], -0.9, head[0], head[1], head[2]};
  for (const double y : {1.0, 6.5}) {
    const auto w = make();
    w->set_law_by_angle("rational", 2, 8, rows);
    w->prescribe_vertical(2, 10000);
    pitch(*w, -8);
    place(*w, y);
    ASSERT_EQ(w->solve(), Status::ok);
    for (std::int64_t i = 0; i < w->patches(); ++i) {
      const double* own = w->patch_stat(i, "angle") < -1 ? face : head;
      const double speed = 8 * w->patch_stat(i, "rolling_radius") - 2000;
      const double wanted = own[0] + own[1] / (1 + speed / own[2]);
      const double found = std::hypot(w->patch_stat(i, "longitudinal_force"), w->patch_stat(i, "lateral_force")) /
                           std::abs(w->patch_stat(i, "normal_force"));
      expect_error("y " + std::to_string(y) + ", patch " + std::to_string(i) + ": coefficient", found / wanted - 1,
                   0.01);
    }
  }
}

TEST_F(wheel_laws, heat_shows_in_the_contacts_of_patches) {
  const auto w = make_with(laws[5], 0.02);
  pitch(*w, -4.4);
  place(*w, 2);
  ASSERT_EQ(w->solve(), Status::ok);
  const double middle[] = {0, 0};
  double temperature[2];
  w->contact(0)->temperatures_at(1, middle, temperature);
  EXPECT_GT(temperature[0], 25);
  EXPECT_EQ(temperature[0], temperature[1]);
}

TEST_F(wheel_laws, are_refused_with_the_reason) {
  const auto w = make();
  const double falling[] = {0.1, 0.2, 5}, hot[] = {20, 0.4, 60, 0.2}, much = 11;
  refused([&] { w->set_friction("static", 1, &much); }, Status::err_argument, {"law is 'static'", "'by_angle'"});
  refused([&] { w->set_friction("linear", 2, falling); }, Status::err_argument, {"n is 2", "3 or 5 parameters"});
  refused([&] { w->set_friction("coulomb", 1, &much); }, Status::err_argument, {"11", "0 to 10"});
  refused([&] { w->set_law_by_angle("linear", 2, 7, falling); }, Status::err_argument, {"n is 7", "2 points"});
  refused([&] { w->set_law_by_angle("linear", 0, 7, falling); }, Status::err_argument, {"points is 0"});
  refused([&] { w->set_layer(-1, 0, 0); }, Status::err_argument, {"flexibility is -1"});
  refused([&] { w->set_heat(3, 1, 1, 0); }, Status::err_argument, {"which is 3"});
  w->prescribe_vertical(2, 10000);
  EXPECT_EQ(w->solve(), Status::ok) << "what was refused has changed nothing";
  w->set_friction_memory(1, 0);
  refused([&] { w->solve(); }, Status::err_state, {"rollcon_wheelrail_set_friction_memory", "does not fall"});
  w->set_friction_memory(0, 0);
  w->set_friction("temperature", 4, hot);
  refused([&] { w->solve(); }, Status::err_state, {"wheel does with heat", "rollcon_wheelrail_set_heat"});
  w->set_friction("linear", 3, falling);
  w->set_layer(0, 100, 0);
  refused([&] { w->solve(); }, Status::err_unsupported, {"rollcon_wheelrail_set_layer"});
  w->set_layer(0, 0, 0);
  w->set_table(ForceTable::standard(context));
  refused([&] { w->solve(); }, Status::err_unsupported, {"table", "'coulomb' without a layer"});
  w->set_int("conformal", 1);
  EXPECT_GE(w->solve(), Status::ok) << "conformal patches leave tables aside";
  w->set_int("conformal", 0);
  w->set_table(nullptr);
  EXPECT_EQ(w->solve(), Status::ok);
}

}  // namespace
}  // namespace rollcon
