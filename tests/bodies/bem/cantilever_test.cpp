// A cantilever with an end load.

#include <gtest/gtest.h>

#include "support/static_cases.hpp"
#include "validation/report.hpp"

namespace rollcon {
namespace {

using statics::StaticBody;
using validation::expect_error;
using validation::expect_order;
using validation::observed_order;
using validation::relative;

namespace beam = statics::beam;

StaticBody body(ElementType type, double span, int along, int across, double poisson) {
  return {surfaces::block(beam::shape(span, along, across), type), beam::young, poisson};
}

double exact_beam_error(ElementType type, int across) {
  StaticBody cantilever = body(type, beam::span, 4 * across, across, 0);
  return beam::error(cantilever);
}

class Cantilever : public ::testing::TestWithParam<ElementType> {};

TEST_P(Cantilever, converges_to_the_exact_bending_with_shear) {
  const ElementType type = GetParam();
  const bool quadratic = is_quadratic(type);
  const int coarse = quadratic ? 1 : 2;
  const double e1 = exact_beam_error(type, coarse), e2 = exact_beam_error(type, 2 * coarse);
  const std::string what = surfaces::name_of(type) + " cantilever";
  expect_error(what + ", coarse", e1, quadratic ? 0.03 : 0.45);
  expect_error(what + ", fine", e2, quadratic ? 0.002 : 0.11);
  expect_order(what, observed_order(e1, e2, 2, 1), quadratic ? 2.2 : 1.8);
}

// The pull's reaction; that of the bent beam's shear force drowns in the errors of its bending stresses, fifty times
// larger.
TEST_P(Cantilever, pulled_at_its_end) {
  const ElementType type = GetParam();
  StaticBody bar = body(type, beam::span, 6, 2, 0.3);
  bar.hold_tags({1}).traction(2, {beam::force / (beam::width * beam::height), 0, 0}).solve();
  const auto reaction = bar.resultant({1});
  expect_error(surfaces::name_of(type) + " bar, force at the root",
               length(reaction.force + Vec3{beam::force, 0, 0}) / beam::force, is_quadratic(type) ? 6e-3 : 2e-2);
}

INSTANTIATE_TEST_SUITE_P(Bodies, Cantilever, ::testing::Values(ElementType::tri6, ElementType::quad4),
                         [](const auto& param) { return surfaces::name_of(param.param); });
INSTANTIATE_TEST_SUITE_P(Bodies_long, Cantilever,
                         ::testing::Values(ElementType::tri3, ElementType::quad8, ElementType::quad9),
                         [](const auto& param) { return surfaces::name_of(param.param); });

// Clamped flat, uniform end traction, nu = 0.3: Timoshenko's beam but for the root, whose clamped section cannot
// contract or warp, and the end, where shear is uniform.
TEST(CantileverTheory, sinks_as_a_timoshenko_beam) {
  constexpr double slender = 8, poisson = 0.3;
  for (const ElementType type : {ElementType::tri6, ElementType::quad8, ElementType::quad9}) {
    StaticBody bent = body(type, slender, 8, 2, poisson);
    bent.hold_tags({1}).traction(2, {0, 0, beam::force / (beam::width * beam::height)}).solve();
    expect_error(surfaces::name_of(type) + " cantilever against Timoshenko",
                 relative(bent.displacement(Vec3{slender, 0, 0})[2], beam::timoshenko(slender, poisson)), 5e-3);
  }
}

}  // namespace
}  // namespace rollcon
