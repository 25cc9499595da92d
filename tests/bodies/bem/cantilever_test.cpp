// A cantilever with an end load.

#include <gtest/gtest.h>

#include <cmath>

#include "support/static_solution.hpp"
#include "support/surface_meshes.hpp"
#include "validation/report.hpp"

namespace rollcon {
namespace {

using statics::StaticBody;
using validation::expect_error;
using validation::expect_order;
using validation::observed_order;
using validation::relative;

constexpr double young = 1000, width = 1, height = 1, force = 1;
constexpr double inertia = width * height * height * height / 12;

SurfaceMesh beam(ElementType type, double span, int along, int across) {
  return surfaces::transform(
      surfaces::block(surfaces::brick({along, across, across}, {span, width, height}), type),
      [](const Vec3& x) {
        return x - Vec3{0, width / 2, height / 2};
      });
}

// nu = 0: bending with a parabola of shear solves the equations in three dimensions, with
// sigma_x = -F (L - x) z / I, tau = F / 2I (h^2 / 4 - z^2); cubic displacements, sections warp.
constexpr double span = 4;

double shear_stress(double z) {
  return force / (2 * inertia) * (height * height / 4 - z * z);
}

Vec3 exact_displacement(const Vec3& x) {
  const double shear = young / 2;
  const double slope = force * (span * x[0] - x[0] * x[0] / 2) / (young * inertia);
  const double sag = force * (span * x[0] * x[0] / 2 - x[0] * x[0] * x[0] / 6) / (young * inertia);
  const double z = x[2];
  const double warp = force / (2 * inertia * shear) * (height * height / 4 * z - z * z * z / 3);
  return {warp - slope * z, 0, sag};
}

double exact_beam_error(ElementType type, int across) {
  StaticBody body(beam(type, span, 4 * across, across), young, 0);
  body.hold_tags({1}, 7, exact_displacement).solve();
  const auto end = surfaces::elements_with_tag(body.mesh(), 2);
  const statics::Loaded loaded = statics::load_faces(body.body(), end, [](const Vec3& x) {
    return Vec3{0, 0, shear_stress(x[2])};
  });
  double error = 0, size = 0;
  for (std::size_t k = 0; k < loaded.node.size(); ++k) {
    const Vec3 exact =
        exact_displacement(body.mesh().node[static_cast<std::size_t>(loaded.node[k])]);
    error = std::max(error, length(loaded.u[k] + body.displacement(loaded.node[k]) - exact));
    size = std::max(size, length(exact));
  }
  return error / size;
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

// The pull's reaction; that of the bent beam's shear force drowns in the errors of its bending
// stresses, fifty times larger.
TEST_P(Cantilever, pulled_at_its_end) {
  const ElementType type = GetParam();
  StaticBody body(beam(type, span, 6, 2), young, 0.3);
  body.hold_tags({1}).traction(2, {force / (width * height), 0, 0}).solve();
  const auto reaction = body.resultant({1});
  expect_error(surfaces::name_of(type) + " bar, force at the root",
               length(reaction.force + Vec3{force, 0, 0}) / force,
               is_quadratic(type) ? 6e-3 : 2e-2);
}

INSTANTIATE_TEST_SUITE_P(Bodies, Cantilever, ::testing::ValuesIn(surfaces::all_types),
                         [](const auto& param) { return surfaces::name_of(param.param); });

// Clamped flat, uniform end traction, nu = 0.3: Timoshenko's beam but for the root, whose clamped
// section cannot contract or warp, and the end, where shear is uniform.
TEST(CantileverTheory, sinks_as_a_timoshenko_beam) {
  constexpr double slender = 8, poisson = 0.3, shear = young / (2 * (1 + poisson));
  constexpr double shear_factor = 10 * (1 + poisson) / (12 + 11 * poisson);
  const double expected = force * slender * slender * slender / (3 * young * inertia) +
                          force * slender / (shear_factor * shear * width * height);
  for (const ElementType type : {ElementType::tri6, ElementType::quad8, ElementType::quad9}) {
    StaticBody body(beam(type, slender, 8, 2), young, poisson);
    body.hold_tags({1}).traction(2, {0, 0, force / (width * height)}).solve();
    expect_error(surfaces::name_of(type) + " cantilever against Timoshenko",
                 relative(body.displacement(Vec3{slender, 0, 0})[2], expected), 5e-3);
  }
}

}  // namespace
}  // namespace rollcon
