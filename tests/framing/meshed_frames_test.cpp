// Tests frames that the library makes where a body has a mesh: bodies compared with half-spaces and lattices of their
// own, thin bodies, bodies that end; the first, second and fourth example without their frames.

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "support/example1.hpp"
#include "support/example2.hpp"
#include "support/example4.hpp"
#include "support/frames.hpp"
#include "support/rolling_errors.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using closed_forms::Elastic;
using scenes::MeshedBody;
using scenes::RollingPair;
using scenes::Solution;
namespace example1 = scenes::example1;
namespace example2 = scenes::example2;
namespace example4 = scenes::example4;

const Elastic soft{.shear = 2000 / 2.6, .poisson = 0.3};
constexpr double ball = 200, mu = 0.3;

/// Makes a block held at its bottom.
MeshedBody block(const surfaces::ZoneBlock& shape, VolumeType type = VolumeType::hex8) {
  MeshedBody body = scenes::meshed(volumes::zone_block(shape, type), soft);
  body.held_tag = {3};
  body.contact_tag = {1, 2};
  return body;
}

/// Rolls a rigid ball with creepages and spin.
void roll(RollingPair& pair, double load) {
  pair.load(load).friction(mu).speed(10).creep(2e-3, 1e-3, 8e-4).option("frame_accuracy", 0.02);
}

void without_frame(RollingPair& pair, double accuracy) {
  ASSERT_EQ(rollcon_contact_frame_automatic(pair.handle()), ROLLCON_OK);
  pair.option("frame_accuracy", accuracy);
}

void expect_same(const std::string& what, const Solution& found, const Solution& expected, double size, double force,
                 double approach) {
  const double bound = -mu * expected.force[2];
  expect_error(what + ": force vector over mu Fn",
               std::hypot(found.force[0] - expected.force[0], found.force[1] - expected.force[1]) / bound, force);
  expect_error(what + ": spin moment", (found.moment[2] - expected.moment[2]) / (bound * size), force);
  expect_error(what + ": approach", (found.approach - expected.approach) / expected.approach, approach);
}

// The faces of the block are a third of the contact's radius.
TEST(meshed_frames_long, a_ball_on_a_block_of_finite_elements) {
  const surfaces::ZoneBlock shape{.side = 80, .depth = 40, .zone = 6, .n = 10, .grade = 5, .deep = 7};
  RollingPair pair(block(shape), scenes::RigidBody{}, 1);
  roll(pair, 100);
  pair.gap_quadratic(0.5 / ball, 0.5 / ball);
  ASSERT_EQ(pair.solve(), ROLLCON_OK) << rollcon_last_error();
  const Solution s = pair.solution();
  const double radius = std::cbrt(0.75 * 100 * ball / closed_forms::effective_modulus(soft));
  // Frames that end at the edge, of either maker, are compared with one that is wider.
  ASSERT_EQ(rollcon_contact_frame_ellipse(pair.handle(), 16, 12, 1.02 * radius, 1.02 * radius, 0), ROLLCON_OK);
  ASSERT_EQ(pair.solve(), ROLLCON_OK) << rollcon_last_error();
  expect_same("beside an ellipse of the caller's", s, pair.solution(), radius, 0.01, 0.005);
  pair.rectangle(ElementType::quad4, 24, 24, 1.3 * radius, 1.3 * radius);
  ASSERT_EQ(pair.solve(), ROLLCON_OK);
  expect_same("beside a lattice", s, pair.solution(), radius, 0.025, 0.003);
  // The block is not quite a half-space.
  RollingPair half_space(soft, std::nullopt);
  roll(half_space, 100);
  half_space.gap_quadratic(0.5 / ball, 0.5 / ball);
  ASSERT_EQ(half_space.solve(), ROLLCON_OK);
  expect_same("beside a half-space", s, half_space.solution(), radius, 0.04, 0.06);
}

// The contact is a fifth smaller than that of a half-space, whose frame would have open nodes all around.
TEST(meshed_frames_long, a_layer_thinner_than_its_contact_is_wide) {
  const surfaces::ZoneBlock shape{.side = 14, .depth = 2, .zone = 10, .n = 12, .grade = 1, .deep = 2};
  RollingPair pair(block(shape, VolumeType::hex20), scenes::RigidBody{}, 1);
  roll(pair, 1500);
  pair.gap_quadratic(0.5 / ball, 0.5 / ball);
  ASSERT_EQ(pair.solve(), ROLLCON_OK) << rollcon_last_error();
  const Solution s = pair.solution();
  const double half_space = std::cbrt(0.75 * 1500 * ball / closed_forms::effective_modulus(soft));
  const double radius = std::sqrt(pair.stat("contact_area") / std::acos(-1.0));
  report("radius over that of a half-space", radius / half_space);
  EXPECT_LT(radius, 0.95 * half_space);
  double reach = 0;
  for (std::size_t k = 0; k < s.nodes(); ++k) reach = std::max(reach, std::hypot(s.x[k], s.y[k]));
  expect_error("reach of the frame over the radius", reach / radius - 1, 0.05);
  pair.rectangle(ElementType::quad4, 30, 30, 1.2 * radius, 1.2 * radius);
  ASSERT_EQ(pair.solve(), ROLLCON_OK);
  expect_same("beside a lattice", s, pair.solution(), radius, 0.025, 0.02);
  // The search knows no load if the approach is given, and half-spaces of the same overlap touch elsewhere.
  without_frame(pair, 0.02);
  pair.approach(s.approach);
  ASSERT_EQ(pair.solve(), ROLLCON_OK) << rollcon_last_error();
  expect_error("the force of that approach", pair.solution().force[2] / s.force[2] - 1, 0.02);
  expect_same("by force and by approach", pair.solution(), s, radius, 0.02, 1e-9);
}

// The contact is less than four times as wide as the block's elements are deep, which is told.
TEST(meshed_frames_long, a_roller_ends_on_a_block) {
  const surfaces::ZoneBlock shape{.side = 40, .depth = 20, .zone = 8, .n = 12, .grade = 4, .deep = 6};
  RollingPair pair(block(shape), scenes::RigidBody{}, 1);
  roll(pair, 200);
  pair.creep(2e-3, 1e-3, 0).option("frame_accuracy", 0.05);
  const double line[2] = {3, 0}, origin[3] = {0, 0, 50}, axis[3] = {0, 1, 0};
  ASSERT_EQ(rollcon_body_set_profile_shape(pair.body(2), "line", 2, line), ROLLCON_OK);
  ASSERT_EQ(rollcon_body_revolve_profile(pair.body(2), origin, axis, 50), ROLLCON_OK);
  ASSERT_EQ(pair.solve(), ROLLCON_INACCURATE) << rollcon_last_error();
  const Solution s = pair.solution();
  double most = 0, corner = 0;
  for (std::size_t k = 0; k < s.nodes(); ++k) most = std::max(most, std::abs(s.y[k]));
  double longest = 0;
  for (std::size_t k = 0; k < s.nodes(); ++k)
    if (std::abs(s.y[k]) > most - 1e-6) longest = std::max(longest, std::abs(s.x[k]));
  for (std::size_t k = 0; k < s.nodes(); ++k)
    if (std::abs(s.y[k]) > most - 1e-6 && std::abs(s.x[k]) > longest - 1e-6) corner = std::max(corner, s.pressure[k]);
  expect_error("the frame ends where the roller does", most - 3, 1e-3);
  EXPECT_EQ(corner, 0) << "the contact ends there";
  pair.rectangle(ElementType::quad4, 24, 48, 1.6, 3 * (1 - 1e-9));
  ASSERT_EQ(pair.solve(), ROLLCON_INACCURATE) << rollcon_last_error();
  expect_same("beside a lattice", s, pair.solution(), 2, 0.05, 0.02);
}

// The gap is measured on the ball's faces, and between them.
TEST(meshed_frames, a_rigid_mesh_on_a_half_space) {
  const auto lines = frames::uniform_lines(-5, 5, 20);
  MeshedBody rigid;
  rigid.mesh = surfaces::transform(frames::rectangle(ElementType::quad4, lines, lines), [](const Vec3& x) {
    return Vec3{x[0], -x[1], (x[0] * x[0] + x[1] * x[1]) / (2 * ball)};
  });
  RollingPair pair(scenes::HalfspaceBody{soft}, rigid, 1);
  roll(pair, 100);
  pair.option("frame_accuracy", 0.005);
  ASSERT_EQ(pair.solve(), ROLLCON_OK) << rollcon_last_error();
  RollingPair quadratic(soft, std::nullopt);
  roll(quadratic, 100);
  quadratic.gap_quadratic(0.5 / ball, 0.5 / ball).option("frame_accuracy", 0.005);
  ASSERT_EQ(quadratic.solve(), ROLLCON_OK);
  expect_same("beside a quadratic gap", pair.solution(), quadratic.solution(), 2, 0.005, 0.002);
}

TEST(meshed_frames, faces_that_look_away_are_told) {
  const surfaces::ZoneBlock shape{.side = 40, .depth = 20, .zone = 8, .n = 8, .grade = 3, .deep = 4};
  RollingPair pair(block(shape), scenes::RigidBody{}, 1);
  roll(pair, 500);
  pair.gap_quadratic(0.5 / ball, 0.5 / ball).axes({0, 0, 0}, {1, 0, 0}, {0, 0, -1});
  EXPECT_EQ(rollcon_contact_solve(pair.handle()), ROLLCON_ERR_ARGUMENT);
  EXPECT_NE(std::string(rollcon_last_error()).find("nowhere finite"), std::string::npos) << rollcon_last_error();
  pair.axes({0, 0, 0}, {1, 0, 0}, {0, 0, 1});
  EXPECT_EQ(pair.solve(), ROLLCON_OK) << "the contact stays usable";
}

// The log tells a body that bends out of its plane where its mesh does not show that, but not what was tried on the
// way.
TEST(meshed_frames, frames_that_are_tried_write_nothing) {
  surfaces::Ring shape = example1::bem_ring(6);
  auto pair = example1::pair(shape, ElementType::quad4, "characteristic");
  std::string log;
  ASSERT_EQ(rollcon_body_prepare(pair->body(1)), ROLLCON_OK);  // tells of slender elements
  ASSERT_EQ(rollcon_context_set_log(
                pair->context(), ROLLCON_LOG_WARNING,
                [](std::int32_t, const char* text, void* to) { *static_cast<std::string*>(to) += text; }, &log),
            ROLLCON_OK);
  without_frame(*pair, 0.05);
  for (const double load : {0.05, 1.0, 0.3}) {
    pair->load(load * example1::load).tangential_force(ROLLCON_LONGITUDINAL, 0.03 * load * example1::load);
    EXPECT_EQ(pair->solve(), ROLLCON_OK) << rollcon_last_caveat();
    EXPECT_EQ(log, "");
  }
  pair->tangential_force(ROLLCON_LATERAL, 0.07 * example1::load * 0.3);
  EXPECT_EQ(pair->solve(), ROLLCON_INACCURATE);
  const std::string caveat = rollcon_last_caveat();
  EXPECT_NE(caveat.find("a force along its axis y bends it"), std::string::npos) << caveat;
  EXPECT_NE(log.find("a force along its axis y bends it"), std::string::npos) << log;
  EXPECT_NE(pair->plan().find("a force along its axis y bends it"), std::string::npos) << pair->plan();
}

// Linear elements of the paper's mesh show 10 % less of the displacements along the axle; quadratic ones of twice the
// length are right, although their reactions miss more of the force.
TEST(meshed_frames_long, the_first_example_tells_what_bends_its_linear_ring) {
  surfaces::Ring quadratic = example1::paper_ring();
  quadratic.around = 28, quadratic.zone_around = quadratic.across = 6, quadratic.deep = 3;
  quadratic.top_layer = 2.4, quadratic.largest = 20;
  const std::string bends = "a force along its axis y bends it";
  for (const bool linear : {true, false}) {
    auto pair = linear ? example1::pair(example1::paper_ring(), ElementType::quad4, "characteristic")
                       : example1::pair(quadratic, ElementType::quad8, "characteristic");
    EXPECT_EQ(pair->solve(), ROLLCON_OK) << rollcon_last_caveat();
    EXPECT_EQ(pair->plan().find(bends), std::string::npos) << pair->plan();
    pair->tangential_force(ROLLCON_LONGITUDINAL, 0)
        .tangential_force(ROLLCON_LATERAL, example1::force_ratio * example1::mu * example1::load);
    const rollcon_status status = pair->solve();
    EXPECT_EQ(status, linear ? ROLLCON_INACCURATE : ROLLCON_OK);
    const bool told = status != ROLLCON_OK && std::string(rollcon_last_caveat()).find(bends) != std::string::npos;
    EXPECT_EQ(told, linear);
    EXPECT_EQ(pair->plan().find(bends) != std::string::npos, linear) << pair->plan();
    double missed = 0;
    ASSERT_EQ(rollcon_body_get_stat(pair->body(1), "imbalance_y", &missed), ROLLCON_OK);
    std::printf("%s: reactions miss %.3f\n", linear ? "quad4" : "quad8", missed);
    EXPECT_LT(missed, 0.1);
  }
}

TEST(meshed_frames_long, first_example) {
  auto pair = example1::pair(example1::paper_ring(), ElementType::quad4, "characteristic");
  for (const double accuracy : {0.05, 0.01}) {
    without_frame(*pair, accuracy);
    ASSERT_EQ(pair->solve(), ROLLCON_OK) << rollcon_last_error();
    const Solution s = pair->solution();
    expect_error("example 1: p0, fine meshes", pair->stat("max_pressure") / example1::fine_p0 - 1, 0.01);
    const auto errors = scenes::rolling_errors(scenes::found_creepage(s, mu * example1::load, example1::arm),
                                               {{example1::fine_creepage, 0}, 0});
    expect_error("example 1: creepage, turned like the force, fine meshes", errors.force, 0.016);
    expect_error("example 1: spin moment", errors.moment, 1e-6);
  }
}

TEST(meshed_frames_long, second_example) {
  if (!rollcon_has_feature("bem")) GTEST_SKIP() << "this build has no boundary elements";
  for (const auto on : {example2::Ground::half_space, example2::Ground::block}) {
    auto pair = example2::pair(example2::ring_of(), VolumeType::hex8, on);
    pair->option("convection", "characteristic");
    ASSERT_EQ(pair->solve(), ROLLCON_OK);
    const Solution on_faces = pair->solution();
    const double p0 = pair->stat("max_pressure");
    for (const double accuracy : {0.05, 0.01}) {
      without_frame(*pair, accuracy);
      ASSERT_EQ(pair->solve(), ROLLCON_OK) << rollcon_last_error();
      const Solution s = pair->solution();
      expect_error("example 2: p0 beside the ring's own faces", pair->stat("max_pressure") / p0 - 1, 0.005);
      expect_error("example 2: creepage likewise", s.creep[0] / on_faces.creep[0] - 1, 0.01);
      expect_error("example 2: approach likewise", s.approach / on_faces.approach - 1, 1e-3);
    }
  }
}

// A mesh twice as fine carries 460.0 N at a creepage of -0.0964 % (docs/examples.md).
TEST(meshed_frames_long, fourth_example) {
  auto pair = example4::pair(ElementType::quad4, "characteristic");
  pair->tangential_force(ROLLCON_LONGITUDINAL, example4::force_ratio * example4::mu * 460);
  for (const double accuracy : {0.05, 0.01}) {
    without_frame(*pair, accuracy);
    ASSERT_EQ(pair->solve(), ROLLCON_OK) << rollcon_last_error();
    const Solution s = pair->solution();
    expect_error("example 4: normal force", -s.force[2] / 460.0 - 1, 0.004);
    expect_error("example 4: creepage", s.creep[0] / -9.64e-4 - 1, 0.01);
    expect_error("example 4: largest pressure", pair->stat("max_pressure") / 54.8 - 1, 0.01);
  }
}

}  // namespace
}  // namespace rollcon
