// Frictionless contact of an elastic sphere with a rigid plane on four kinds of frames.

#include <algorithm>

#include "report.hpp"
#include "support/frames.hpp"
#include "support/hertz_fit.hpp"

namespace rollcon::validation {
namespace {

using closed_forms::Hertz;
using scenes::fit_hertz;
using scenes::FittedEllipse;
using scenes::RollingPair;
using scenes::Solution;

const closed_forms::Elastic sphere{.shear = 1e4 / 2.6, .poisson = 0.3};
constexpr double curvature = 1.0 / (2 * 50);
const Hertz exact = closed_forms::hertz_from_load(curvature, curvature, closed_forms::effective_modulus(sphere), 298.6);

Solution press(const SurfaceMesh& mesh, bool by_force) {
  RollingPair pair(sphere, std::nullopt);
  pair.frame(mesh).gap_quadratic(curvature, curvature).friction(0);
  by_force ? pair.load(exact.load) : pair.approach(exact.approach);
  EXPECT_EQ(pair.solve(), ROLLCON_OK);
  return pair.solution();
}

void expect_hertz(const std::string& name, const SurfaceMesh& mesh) {
  const Solution s = press(mesh, false);
  const FittedEllipse fit = fit_hertz(s, exact.a, exact.b);
  expect_error(name + ": force at given approach", relative(-s.force[2], exact.load), 3e-3);
  expect_error(name + ": peak pressure (fit)", relative(fit.p0, exact.p0), 1e-2);
  expect_error(name + ": semi-axis a (fit)", relative(fit.a, exact.a), 1e-2);
  expect_error(name + ": semi-axis b (fit)", relative(fit.b, exact.b), 1e-2);
  const double highest = *std::max_element(s.pressure.begin(), s.pressure.end());
  expect_error(name + ": peak pressure (largest nodal value)", relative(highest, exact.p0), 1e-2);
}

SurfaceMesh grid(ElementType type, int across) {
  const double reach = exact.a * 28.0 / 24.0;
  const auto lines = frames::uniform_lines(-reach, reach, across * 28 / 24);
  return frames::rectangle(type, lines, lines);
}

TEST(HertzCircle, quad4_grid_24_across) {
  expect_hertz("quad4", grid(ElementType::quad4, 24));
}

TEST(HertzCircle, tri3_grid_24_across) {
  expect_hertz("tri3", grid(ElementType::tri3, 24));
}

TEST(HertzCircle, quad8_grid_24_nodes_across) {
  expect_hertz("quad8", grid(ElementType::quad8, 12));
}

TEST(HertzCircle, quad9_grid_24_nodes_across) {
  expect_hertz("quad9", grid(ElementType::quad9, 12));
}

TEST(HertzCircle, tri6_grid_24_nodes_across) {
  expect_hertz("tri6", grid(ElementType::tri6, 12));
}

TEST(HertzCircle_long, frames_of_the_paper) {
  expect_hertz("673 quad4", frames::o_grid(ElementType::quad4, 16, 6, 1.3 * exact.a, 1.3 * exact.a));
  expect_hertz("1985 quad8", frames::o_grid(ElementType::quad8, 16, 6, 1.3 * exact.a, 1.3 * exact.a));
  expect_hertz("703 tri3", frames::paper_disc(ElementType::tri3, 1.3 * exact.a));
}

TEST(HertzCircle, rings_graded_to_the_edge) {
  const auto radii = frames::contact_radii(exact.a, 12, 1.2 * exact.a);
  const auto counts = frames::ring_counts(radii);
  expect_hertz("tri3 rings", frames::ring_disc(ElementType::tri3, radii, counts));
}

TEST(HertzCircle, approach_at_given_force) {
  const Solution s = press(grid(ElementType::quad4, 24), true);
  expect_error("force found", relative(-s.force[2], exact.load), 1e-9);
  expect_error("approach at given force", relative(s.approach, exact.approach), 3e-3);
}

TEST(HertzCircle_long, force_converges) {
  const Solution coarse = press(grid(ElementType::quad4, 12), false);
  const Solution fine = press(grid(ElementType::quad4, 48), false);
  const double e1 = relative(-coarse.force[2], exact.load);
  const double e2 = relative(-fine.force[2], exact.load);
  report("force, 12 across", e1);
  report("force, 48 across", e2);
  // The edge of the contact falls between nodes: order one at worst, more as errors cancel.
  expect_order("force, quad4 grid", observed_order(e1, e2, 4, 1), 1.0);
}

TEST(HertzCircle_long, force_converges_on_graded_rings) {
  double error[2];
  for (int i = 0; i < 2; ++i) {
    const auto radii = frames::contact_radii(exact.a, 6 << i, 1.25 * exact.a);
    const auto counts = frames::ring_counts(radii);
    const Solution s = press(frames::ring_disc(ElementType::tri3, radii, counts), false);
    error[i] = relative(-s.force[2], exact.load);
    report("force, graded rings " + std::to_string(6 << i), error[i]);
  }
  // Linear tractions on rings that resolve the square root at the edge.
  expect_order("force, graded rings", observed_order(error[0], error[1], 2, 1), 1.5);
}

}  // namespace
}  // namespace rollcon::validation
