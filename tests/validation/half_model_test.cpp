// Tests a plane of symmetry along the rolling direction: half of the body, held across the plane, carries half of the
// forces.

#include <gtest/gtest.h>

#include "support/volume_meshes.hpp"
#include "validation/scenes.hpp"

namespace rollcon::validation {
namespace {

/// Makes the part y >= least of a block [-1, 1]^2 x [-1, 0] held at its bottom, under a rigid paraboloid; the frame is
/// the faces in the middle of its top.
std::unique_ptr<RollingPair> block(double least, double mu, double creep) {
  const int n = 16, across = least < 0 ? n : n / 2;
  surfaces::Block shape;
  for (int k = 0; k <= n; ++k) shape.line[0].push_back(-1 + 2.0 * k / n);
  for (int k = 0; k <= across; ++k) shape.line[1].push_back(least + (1 - least) * k / across);
  for (int k = 0; k <= n / 2; ++k) shape.line[2].push_back(-1 + 2.0 * k / n);
  shape.zone_from = {n / 4, least < 0 ? n / 4 : 0};
  shape.zone_to = {n - n / 4, across - n / 4};
  shape.zone_tag = 9;
  MeshedBody body = meshed(volumes::block(shape, VolumeType::hex8), {.shear = 1 / 2.6, .poisson = 0.3});
  body.held_tag = {5};
  if (least == 0) body.slide.push_back({.tag = 3, .dof_mask = ROLLCON_DOF_Y});
  body.contact_tag = {9};
  auto pair = std::make_unique<RollingPair>(body, RigidBody{}, 1);
  pair->frame_from_body(1, 9).gap_quadratic(0.1, 0.1);
  pair->friction(mu).approach(0.02).speed(1).creep(creep, 0, 0);
  return pair;
}

class HalfModels : public ::testing::TestWithParam<double> {};

TEST_P(HalfModels, carries_half_of_the_forces) {
  const auto whole = block(-1, 0.3, GetParam()), half = block(0, 0.3, GetParam());
  whole->solve();
  half->solve();
  const auto w = whole->solution(), h = half->solution();
  for (const std::size_t c : {std::size_t{0}, std::size_t{2}})
    expect_error("force " + std::to_string(c + 1), std::abs(2 * h.force[c] / w.force[c] - 1), 1e-6);
}

TEST(HalfModel, is_for_the_condensed_form) {
  const auto half = block(0, 0.3, 1e-3);
  half->option("procedure", "system=monolithic");
  try {
    half->solve();
    FAIL() << "a half model was solved in monolithic form";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("plane of symmetry"), std::string::npos) << error.what();
  }
  half->option("procedure", "");
  EXPECT_EQ(half->solve(), ROLLCON_COARSE) << "few nodes touch";
}

INSTANTIATE_TEST_SUITE_P(creepages, HalfModels, ::testing::Values(0.0, 1e-5, 1e-3, 0.1));

}  // namespace
}  // namespace rollcon::validation
