// Tests time steps of bodies with a mesh, and lists of cases beside each other.

#include <algorithm>
#include <cmath>

#include "rollcon.h"
#include "support/frames.hpp"
#include "support/scene.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using scenes::RollingPair;

const closed_forms::Elastic soft_steel{.shear = 1, .poisson = 0.3};

std::unique_ptr<RollingPair> block_under_sphere(bool finite_elements, double bulge) {
  surfaces::Block shape = surfaces::brick({10, 10, 4}, {2, 2, 1});
  shape.map = [=](const Vec3& p) {
    const double x = p[0] - 1, y = p[1] - 1;
    return Vec3{x, y, p[2] - 1 - bulge * p[2] * (x * x + 0.7 * y * y)};
  };
  scenes::MeshedBody body = finite_elements ? scenes::meshed(volumes::block(shape, VolumeType::hex8), soft_steel)
                                            : scenes::meshed(surfaces::block(shape, ElementType::quad4), soft_steel);
  body.held_tag = {5};
  auto pair = std::make_unique<RollingPair>(body, scenes::RigidBody{}, 1);
  pair->frame_from_body(1, 6).gap_quadratic(0.15, 0.12).friction(0.3).load(0.05);
  return pair;
}

double worst_law(const RollingPair& pair) {
  double worst = 0;
  for (const char* name : {"law_normal", "law_friction", "law_slip", "law_equilibrium"})
    worst = std::max(worst, pair.stat(name));
  return worst;
}

TEST(time_steps_of_bodies_long, shift_then_roll_to_the_steady_state) {
  for (const bool fem : {false, true})
    for (const double bulge : {0.0, 0.05}) {
      if (!rollcon_has_feature(fem ? "fem" : "bem")) continue;
      const std::string name = std::string(fem ? "FEM" : "BEM") + (bulge > 0 ? ", curved" : ", flat");
      const auto steady = block_under_sphere(fem, bulge), steps = block_under_sphere(fem, bulge);
      steady->creep(-0.01, 0.003, 0);
      ASSERT_GE(steady->solve(), 0);
      rollcon_contact* const c = steps->handle();
      steps->creep(-1e-3, 3e-4, 0);
      ASSERT_EQ(rollcon_contact_set_step(c, ROLLCON_SHIFT_STEP, 1), ROLLCON_OK);
      ASSERT_GE(steps->solve(), 0);
      double worst = worst_law(*steps);
      steps->creep(-0.01, 0.003, 0);  // over the distance that the steady scheme looks upstream
      ASSERT_EQ(rollcon_contact_set_step(c, ROLLCON_ROLLING_STEP, 0.12), ROLLCON_OK);
      // The rest of the start falls by a factor of 50 to 60 in 20 steps, down to 3e-12 after 140.
      for (int k = 0; k < 80; ++k) {
        ASSERT_GE(steps->solve(), 0);
        worst = std::max(worst, worst_law(*steps));
      }
      expect_error(name + ": laws", worst, 1e-8);
      const auto a = steady->solution().force, b = steps->solution().force;
      expect_error(name + ": force against the steady one",
                   std::hypot(a[0] - b[0], a[1] - b[1]) / std::hypot(a[0], a[1]), 1e-6);
    }
}

TEST(time_steps_of_bodies, another_frame_is_refused_and_the_past_stays) {
  if (!rollcon_has_feature("bem")) GTEST_SKIP() << "not in this build";
  const auto pair = block_under_sphere(false, 0), twin = block_under_sphere(false, 0);
  for (const auto* p : {&pair, &twin}) {
    (*p)->creep(-0.01, 0, 0);
    ASSERT_EQ(rollcon_contact_set_step((*p)->handle(), ROLLCON_ROLLING_STEP, 0.1), ROLLCON_OK);
    for (int k = 0; k < 3; ++k) ASSERT_GE((*p)->solve(), 0);
  }
  const auto lines = frames::uniform_lines(-0.8, 0.8, 8);
  pair->frame(frames::rectangle(ElementType::quad4, lines, lines)).gap_quadratic(0.15, 0.12);
  EXPECT_EQ(rollcon_contact_solve(pair->handle()), ROLLCON_ERR_STATE);
  const std::string words = rollcon_last_error();
  EXPECT_NE(words.find("not that of the step before"), std::string::npos) << words;
  pair->frame_from_body(1, 6).gap_quadratic(0.15, 0.12);
  for (const auto* p : {&pair, &twin}) ASSERT_GE((*p)->solve(), 0);
  expect_error("the step after a refusal", pair->solution().force[0] / twin->solution().force[0] - 1, 1e-8);
}

// All cases are steps from one past, which stays the contact's.
TEST(time_steps_of_bodies, lists_of_cases) {
  RollingPair pair(soft_steel, std::nullopt);
  pair.rectangle(ElementType::quad4, 14, 14, 1, 1).gap_quadratic(0.15, 0.12).friction(0.3).load(0.05);
  pair.creep(-0.005, 0, 0);
  ASSERT_EQ(rollcon_contact_set_step(pair.handle(), ROLLCON_ROLLING_STEP, 0.2), ROLLCON_OK);
  for (int k = 0; k < 3; ++k) ASSERT_GE(pair.solve(), 0);
  const double value[4] = {-0.01, -0.004, 0.002, 0.012};
  double force[12];
  std::int64_t n = 0;
  std::int32_t status[4];
  ASSERT_GE(rollcon_contact_solve_many(pair.handle(), "longitudinal", 4, value, "force", 3, force, &n, status), 0);
  double worst = 0;
  for (int i = 0; i < 4; ++i) {
    pair.creep(value[i], 0, 0);
    ASSERT_GE(pair.solve(), 0);
    worst = std::max(worst, std::abs(pair.solution().force[0] - force[3 * i]) / (0.3 * 0.05));
    ASSERT_EQ(rollcon_contact_repeat_step(pair.handle()), ROLLCON_OK);
  }
  expect_error("cases of a list against steps one by one", worst, 1e-8);
}

}  // namespace
}  // namespace rollcon
