// A cantilever of finite elements with an end load.

#include <gtest/gtest.h>

#include "support/static_cases.hpp"
#include "validation/report.hpp"

namespace rollcon {
namespace {

namespace beam = statics::beam;
using statics::StaticBody;
using validation::expect_error;
using validation::expect_order;
using validation::observed_order;
using validation::relative;

StaticBody body(VolumeType type, double span, int along, int across, double poisson) {
  return {volumes::block(beam::shape(span, along, across), type), beam::young, poisson};
}

double exact_beam_error(VolumeType type, int across) {
  StaticBody cantilever = body(type, beam::span, 4 * across, across, 0);
  return beam::error(cantilever);
}

class FemCantilever : public ::testing::TestWithParam<VolumeType> {};

TEST_P(FemCantilever, converges_to_the_exact_bending_with_shear) {
  const VolumeType type = GetParam();
  const bool quadratic = is_quadratic(type);
  const int coarse = quadratic ? 1 : 4;
  const double e1 = exact_beam_error(type, coarse), e2 = exact_beam_error(type, 2 * coarse);
  const std::string what = volumes::name_of(type) + " cantilever";
  expect_error(what + ", coarse", e1, quadratic ? 0.015 : 0.35);
  expect_error(what + ", fine", e2, quadratic ? 1.5e-3 : 0.1);
  expect_order(what, observed_order(e1, e2, 2, 1), quadratic ? 2.5 : 1.7);
}

TEST_P(FemCantilever, its_root_carries_the_load) {
  StaticBody bent = body(GetParam(), beam::span, 6, 2, 0.3);
  const Vec3 t{0.5, -0.2, 1};
  const Vec3 force = beam::width * beam::height * t, at{beam::span, 0, 0};
  bent.hold_tags({1}).traction(2, t).solve();
  const Resultant reaction = bent.reaction();
  expect_error(volumes::name_of(GetParam()) + " cantilever, force at the root",
               length(reaction.force + force) / length(force), 1e-10);
  expect_error(volumes::name_of(GetParam()) + " cantilever, moment at the root",
               length(reaction.moment + cross(at, force)) / length(cross(at, force)), 1e-10);
}

INSTANTIATE_TEST_SUITE_P(Bodies, FemCantilever, ::testing::Values(VolumeType::hex8, VolumeType::tet10),
                         [](const auto& param) { return volumes::name_of(param.param); });
INSTANTIATE_TEST_SUITE_P(Bodies_long, FemCantilever,
                         ::testing::Values(VolumeType::tet4, VolumeType::wedge6, VolumeType::wedge15,
                                           VolumeType::hex20),
                         [](const auto& param) { return volumes::name_of(param.param); });

// Clamped flat, uniform end traction, nu = 0.3: Timoshenko's beam but for the root, whose clamped section cannot
// contract or warp: 0.9 % stiffer at 8 heights, 0.4 % at 20.
TEST(FemCantileverTheory, sinks_as_a_timoshenko_beam) {
  constexpr double slender = 20, poisson = 0.3;
  for (const VolumeType type : {VolumeType::hex20, VolumeType::wedge15, VolumeType::tet10}) {
    StaticBody bent = body(type, slender, 20, 2, poisson);
    bent.hold_tags({1}).traction(2, {0, 0, beam::force / (beam::width * beam::height)}).solve();
    expect_error(volumes::name_of(type) + " cantilever against Timoshenko",
                 relative(bent.displacement(Vec3{slender, 0, 0})[2], beam::timoshenko(slender, poisson)), 1e-2);
  }
}

}  // namespace
}  // namespace rollcon
