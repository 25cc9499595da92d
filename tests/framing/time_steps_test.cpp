/// Tests time steps on frames that the library makes or that end at the contact's edge: the past goes along with them.

#include "rollcon.h"
#include "support/scene.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using closed_forms::Elastic;
using scenes::RollingPair;

/// Kalker's two spheres have G = 1, nu = 0.28, a = 3.5.
const Elastic soft{1, 0.28};
constexpr double load = 0.4705, mu = 0.4013;

void kalker(RollingPair& pair) {
  pair.gap_quadratic(0.002963, 0.002963).load(load).friction(mu).speed(1);
}

void step(RollingPair& pair, std::int32_t kind, double dt) {
  ASSERT_EQ(rollcon_contact_set_step(pair.handle(), kind, dt), ROLLCON_OK);
  ASSERT_EQ(pair.solve(), ROLLCON_OK);
}

TEST(time_steps_on_made_frames, from_cattaneo_to_carter) {
  RollingPair pair(soft, soft);
  kalker(pair);
  pair.tangential_force(ROLLCON_LONGITUDINAL, -0.657 * mu * load);
  step(pair, ROLLCON_SHIFT_STEP, 1);
  step(pair, ROLLCON_ROLLING_STEP, 0.25);
  const double onset = std::abs(pair.solution().creep[0]);
  for (int k = 0; k < 80; ++k) step(pair, ROLLCON_ROLLING_STEP, 0.25);
  const double last = std::abs(pair.solution().creep[0]);
  for (const char* words : {"made by the library", "time: step 82 of 0.25, material travels"})
    EXPECT_NE(pair.plan().find(words), std::string::npos) << pair.plan();
  expect_error("onset of Kalker's transient", onset / 0.001824 - 1, 0.01);
  expect_error("its steady state", last / 0.003101 - 1, 0.01);
}

// Frames follow a load that comes and goes; a lattice that stays does not.
TEST(time_steps_on_made_frames_long, load_that_changes) {
  RollingPair fixed(soft, soft), steps(soft, soft);
  kalker(fixed);
  kalker(steps);
  fixed.rectangle(ElementType::quad4, 48, 48, 4.4, 4.4);
  double worst[2] = {0, 0};
  for (int k = 0; k < 25; ++k) {
    for (RollingPair* pair : {&fixed, &steps}) {
      pair->load(load * (1 + 0.4 * std::sin(0.6 * k))).creep(-1.5e-3 * std::cos(0.3 * k), 5e-4, 0);
      step(*pair, ROLLCON_ROLLING_STEP, 0.7);
    }
    const auto f = steps.solution().force, g = fixed.solution().force;
    for (std::size_t c = 0; c < 2; ++c) worst[c] = std::max(worst[c], std::abs(f[c] - g[c]) / (mu * load));
  }
  expect_error("longitudinal force against a lattice that stays", worst[0], 0.01);
  expect_error("lateral force, likewise", worst[1], 0.01);
  const auto b = steps.solution().force;
  // A step that is done again comes out again.
  ASSERT_EQ(rollcon_contact_repeat_step(steps.handle()), ROLLCON_OK);
  step(steps, ROLLCON_ROLLING_STEP, 0.7);
  expect_error("a repeated step", steps.solution().force[0] / b[0] - 1, 1e-8);
  // The saved past lies on a frame that stays.
  std::int64_t n = 0;
  EXPECT_EQ(rollcon_contact_past_get(steps.handle(), 0, nullptr, &n), ROLLCON_ERR_STATE);
}

// A step in which the bodies do not touch is one of both frames of the pair; the next one starts from rest.
TEST(time_steps_on_made_frames, first_step_without_contact) {
  RollingPair touching(soft, soft), parted(soft, soft);
  for (RollingPair* pair : {&touching, &parted}) {
    kalker(*pair);
    pair->creep(1e-3, 0, 0);
  }
  for (const std::int32_t kind : {ROLLCON_ROLLING_STEP, ROLLCON_SHIFT_STEP}) {
    parted.load(0);
    ASSERT_EQ(rollcon_contact_set_step(parted.handle(), kind, 0.5), ROLLCON_OK);
    ASSERT_EQ(parted.solve(), ROLLCON_NO_CONTACT);
    ASSERT_EQ(parted.solve(), ROLLCON_NO_CONTACT);
    parted.load(load);
    step(touching, kind, 0.5);
    step(parted, kind, 0.5);
    EXPECT_NEAR(parted.solution().force[0], touching.solution().force[0], 1e-6 * mu * load);
    ASSERT_EQ(rollcon_contact_reset(touching.handle()), ROLLCON_OK);
    ASSERT_EQ(rollcon_contact_reset(parted.handle()), ROLLCON_OK);
  }
}

// Without a load a search closes in on a point: the frame has a size still, which a step may roll by.
TEST(time_steps_on_made_frames, first_step_without_load_over_a_grid) {
  constexpr std::int64_t n = 41;
  constexpr double half = 4;
  std::vector<double> gap;
  for (std::int64_t j = 0; j < n; ++j)
    for (std::int64_t i = 0; i < n; ++i) {
      const double x = half * (2.0 * static_cast<double>(i) / (n - 1) - 1);
      const double y = half * (2.0 * static_cast<double>(j) / (n - 1) - 1);
      gap.push_back(0.01 * (x * x + y * y));
    }
  RollingPair pair(soft, soft);
  ASSERT_EQ(rollcon_contact_set_friction(pair.handle(), "coulomb", 1, &mu), ROLLCON_OK);
  ASSERT_EQ(rollcon_contact_set_gap_grid(pair.handle(), n, -half, half, -half, half, n * n, gap.data()), ROLLCON_OK);
  pair.load(0);
  ASSERT_EQ(rollcon_contact_set_step(pair.handle(), ROLLCON_ROLLING_STEP, 1), ROLLCON_OK);
  EXPECT_EQ(pair.solve(), ROLLCON_NO_CONTACT);
}

// The caller's frames end at the contact's edge.
TEST(time_steps_on_made_frames, frame_of_an_ellipse) {
  RollingPair pair(soft, soft);
  kalker(pair);
  ASSERT_EQ(rollcon_contact_frame_ellipse(pair.handle(), 24, 24, 3.5, 3.5, 0), ROLLCON_OK);
  pair.tangential_force(ROLLCON_LONGITUDINAL, -0.657 * mu * load);
  step(pair, ROLLCON_SHIFT_STEP, 1);
  step(pair, ROLLCON_ROLLING_STEP, 0.25);
  const double onset = std::abs(pair.solution().creep[0]);
  for (int k = 0; k < 80; ++k) step(pair, ROLLCON_ROLLING_STEP, 0.25);
  expect_error("onset of Kalker's transient", onset / 0.001824 - 1, 0.01);
  expect_error("its steady state", std::abs(pair.solution().creep[0]) / 0.003101 - 1, 0.01);
}

}  // namespace
}  // namespace rollcon
