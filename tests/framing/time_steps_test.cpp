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

// Steps of 0.15 of the radius end in steady rolling, within what was asked.
TEST(time_steps_on_made_frames_long, from_cattaneo_to_steady_rolling) {
  for (const double part : {0.3, 0.657}) {
    RollingPair pair(soft, soft), steady(soft, soft);
    for (RollingPair* p : {&pair, &steady}) {
      kalker(*p);
      p->tangential_force(ROLLCON_LONGITUDINAL, -part * mu * load);
    }
    steady.option("frame_accuracy", 0.002);
    ASSERT_EQ(steady.solve(), ROLLCON_OK);
    constexpr double asked = 0.01;
    pair.option("frame_accuracy", asked);
    step(pair, ROLLCON_SHIFT_STEP, 1);
    for (int k = 0; k < 30; ++k) step(pair, ROLLCON_ROLLING_STEP, 0.15 * 3.5);
    for (const char* words : {"made by the library", "time: step 31 of 0.525, material travels"})
      EXPECT_NE(pair.plan().find(words), std::string::npos) << pair.plan();
    expect_error("the last step beside steady rolling", pair.solution().creep[0] / steady.solution().creep[0] - 1,
                 asked);
    // Longer steps miss this, and report it.
    ASSERT_EQ(rollcon_contact_set_step(pair.handle(), ROLLCON_ROLLING_STEP, 0.3 * 3.5), ROLLCON_OK);
    for (int k = 0; k < 6; ++k) EXPECT_EQ(pair.solve(), ROLLCON_INACCURATE);
    const double off = std::abs(pair.solution().creep[0] / steady.solution().creep[0] - 1);
    EXPECT_GT(off, asked);
    expect_error("a step twice as long, beside its estimate", off, pair.stat("error_estimate"));
    EXPECT_NE(std::string(rollcon_last_caveat()).find("take shorter steps"), std::string::npos)
        << rollcon_last_caveat();
  }
}

TEST(time_steps_on_made_frames, onset_of_rolling) {
  RollingPair pair(soft, soft);
  kalker(pair);
  pair.tangential_force(ROLLCON_LONGITUDINAL, -0.657 * mu * load);
  step(pair, ROLLCON_SHIFT_STEP, 1);
  step(pair, ROLLCON_ROLLING_STEP, 0.25);
  expect_error("onset of Kalker's transient", std::abs(pair.solution().creep[0]) / 0.001824 - 1, 0.01);
}

// Frames follow a load that comes and goes: steps half as long give the same.
TEST(time_steps_on_made_frames_long, load_that_changes) {
  RollingPair whole(soft, soft), half(soft, soft);
  for (RollingPair* pair : {&whole, &half}) {
    kalker(*pair);
    pair->option("frame_accuracy", 0.02);
  }
  const auto roll = [](RollingPair& pair, double k, double way) {
    pair.load(load * (1 + 0.4 * std::sin(0.6 * k))).creep(-1.5e-3 * std::cos(0.3 * k), 5e-4, 0);
    step(pair, ROLLCON_ROLLING_STEP, way);
  };
  double worst[2] = {0, 0};
  for (int k = 0; k < 25; ++k) {
    roll(whole, 0.5 * k, 0.25);
    roll(half, 0.5 * k - 0.25, 0.125);
    roll(half, 0.5 * k, 0.125);
    const auto f = whole.solution().force, g = half.solution().force;
    for (std::size_t c = 0; k > 4 && c < 2; ++c) worst[c] = std::max(worst[c], std::abs(f[c] - g[c]) / (mu * load));
  }
  expect_error("longitudinal force, of friction's, beside half steps", worst[0], 0.01);
  expect_error("lateral force, likewise", worst[1], 0.01);
  // A step that is done again comes out again.
  const auto b = whole.solution().force;
  ASSERT_EQ(rollcon_contact_repeat_step(whole.handle()), ROLLCON_OK);
  step(whole, ROLLCON_ROLLING_STEP, 0.25);
  expect_error("a repeated step", whole.solution().force[0] / b[0] - 1, 1e-8);
}

// A run that is interrupted goes on as if it had not been, while its frame grows.
TEST(time_steps_on_made_frames, restored) {
  const auto make = [] {
    auto pair = std::make_unique<RollingPair>(soft, soft);
    kalker(*pair);
    pair->option("frame_accuracy", 0.05);
    pair->option("tolerance", 1e-11);
    pair->tangential_force(ROLLCON_LONGITUDINAL, -0.2 * mu * load);
    return pair;
  };
  const auto roll = [](RollingPair& pair, int k) {
    pair.load(load * std::pow(1.3, k));
    step(pair, ROLLCON_ROLLING_STEP, 0.3);
  };
  auto whole = make(), stopped = make();
  for (int k = 0; k < 4; ++k) roll(*whole, k), roll(*stopped, k);
  std::int64_t n = 0;
  ASSERT_EQ(rollcon_contact_past_get(stopped->handle(), 0, nullptr, &n), ROLLCON_OK);
  std::vector<double> past(static_cast<std::size_t>(n));
  ASSERT_EQ(rollcon_contact_past_get(stopped->handle(), n, past.data(), &n), ROLLCON_OK);
  stopped = make();
  ASSERT_EQ(rollcon_contact_past_set(stopped->handle(), n, past.data()), ROLLCON_OK);
  for (int k = 4; k < 12; ++k) roll(*whole, k), roll(*stopped, k);
  for (std::size_t c = 0; c < 3; ++c)
    expect_error("force of the interrupted run",
                 (stopped->solution().force[c] - whole->solution().force[c]) / (mu * load), 1e-10);
  expect_error("its creepage", stopped->solution().creep[0] / whole->solution().creep[0] - 1, 1e-9);
  // Pasts of given frames and of the library's are told apart.
  RollingPair given(soft, soft);
  kalker(given);
  given.rectangle(ElementType::quad4, 8, 8, 4.4, 4.4);
  EXPECT_EQ(rollcon_contact_past_set(given.handle(), n, past.data()), ROLLCON_ERR_ARGUMENT);
}

// An elastic sphere is pressed on a rigid plane by a load that grows from nothing (Spence: half of the radius sticks).
TEST(time_steps_on_made_frames_long, spence_compression) {
  for (const double accuracy : {0.02, 0.01}) {
    RollingPair pair(Elastic{0.5, 0}, std::nullopt);
    pair.gap_quadratic(0.5 / 121.5, 0.5 / 121.5).friction(0.2986);
    pair.option("frame_accuracy", accuracy);
    for (int k = 1; k <= 35; ++k) {
      pair.load(0.47052 * std::pow(k / 35.0, 3));
      step(pair, ROLLCON_SHIFT_STEP, 1);
    }
    const double ratio = std::sqrt(pair.stat("stick_area") / pair.stat("contact_area"));
    expect_error("radius of stick over that of contact", ratio - 0.5, 0.015);
  }
}

TEST(time_steps_on_made_frames, cattaneo_at_loose_accuracy) {
  RollingPair pair(soft, soft);
  kalker(pair);
  pair.option("frame_accuracy", 0.02);
  pair.tangential_force(ROLLCON_LONGITUDINAL, -0.875 * mu * load);
  step(pair, ROLLCON_SHIFT_STEP, 1);
  expect_error("area of stick", pair.stat("stick_area") / pair.stat("contact_area") - 0.25, 0.015);
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
