// Tests frictionless contact: an elastic sphere on a rigid plane, on all kinds of frames; elliptic contacts with
// semi-axes a/b from 0.02 to 50, on one grid with 24 elements across both axes, stretched with the ellipse.

#include <algorithm>

#include "validation/scenes.hpp"

namespace rollcon::validation {
namespace {

const Elastic sphere{.shear = 1e4 / 2.6, .poisson = 0.3}, steel{.shear = 82000, .poisson = 0.28};
constexpr double curvature = 1.0 / (2 * 50);
const Hertz exact = closed_forms::hertz_from_load(curvature, curvature, closed_forms::effective_modulus(sphere), 298.6);

Solution press(const SurfaceMesh& mesh, bool by_force) {
  RollingPair pair(sphere, std::nullopt);
  pair.frame(mesh).gap_quadratic(curvature, curvature).friction(0);
  by_force ? pair.load(exact.load) : pair.approach(exact.approach);
  EXPECT_EQ(pair.solve(), ROLLCON_OK);
  return pair.solution();
}

/// Compares with Hertz at given approach.
void expect_hertz(const std::string& name, const Solution& s, const Hertz& hertz) {
  const FittedEllipse fit = fit_hertz(s, hertz.a, hertz.b);
  expect_error(name + ": force", relative(-s.force[2], hertz.load), 3e-3);
  expect_error(name + ": peak pressure (fit)", relative(fit.p0, hertz.p0), 1e-2);
  expect_error(name + ": semi-axis a (fit)", relative(fit.a, hertz.a), 1e-2);
  expect_error(name + ": semi-axis b (fit)", relative(fit.b, hertz.b), 1e-2);
}

void expect_circle(const std::string& name, const SurfaceMesh& mesh) {
  const Solution s = press(mesh, false);
  expect_hertz(name, s, exact);
  const double highest = *std::max_element(s.pressure.begin(), s.pressure.end());
  expect_error(name + ": peak pressure (largest nodal value)", relative(highest, exact.p0), 1e-2);
}

/// Makes a grid with so many elements across the contact.
SurfaceMesh grid(ElementType type, int across) {
  const double reach = exact.a * 28.0 / 24.0;
  const auto lines = frames::uniform_lines(-reach, reach, across * 28 / 24);
  return frames::rectangle(type, lines, lines);
}

SurfaceMesh rings(int n, double reach) {
  const auto radii = frames::contact_radii(exact.a, n, reach * exact.a);
  return frames::ring_disc(ElementType::tri3, radii, frames::ring_counts(radii));
}

TEST(HertzCircle, on_grids_of_24_nodes_across) {
  for (const ElementType type : surfaces::all_types)
    expect_circle(surfaces::name_of(type), grid(type, is_quadratic(type) ? 12 : 24));
}

TEST(HertzCircle_long, frames_of_the_paper) {
  expect_circle("673 quad4", frames::o_grid(ElementType::quad4, 16, 6, 1.3 * exact.a, 1.3 * exact.a));
  expect_circle("1985 quad8", frames::o_grid(ElementType::quad8, 16, 6, 1.3 * exact.a, 1.3 * exact.a));
  expect_circle("703 tri3", frames::paper_disc(ElementType::tri3, 1.3 * exact.a));
}

TEST(HertzCircle, rings_graded_to_the_edge) {
  expect_circle("tri3 rings", rings(12, 1.2));
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
  // The edge of the contact falls between nodes, so the order is one at worst, and more when errors cancel.
  expect_order("force, quad4 grid", observed_order(e1, e2, 4, 1), 1.0);
}

TEST(HertzCircle_long, force_converges_on_graded_rings) {
  double error[2];
  for (int i = 0; i < 2; ++i) {
    error[i] = relative(-press(rings(6 << i, 1.25), false).force[2], exact.load);
    report("force, graded rings " + std::to_string(6 << i), error[i]);
  }
  // The tractions are linear on rings that resolve the square root at the edge.
  expect_order("force, graded rings", observed_order(error[0], error[1], 2, 1), 1.5);
}

class HertzEllipse : public testing::TestWithParam<double> {};

TEST_P(HertzEllipse, peak_pressure_axes_and_force) {
  const double ratio = GetParam();
  const Hertz hertz = closed_forms::hertz_from_axes(std::sqrt(ratio), 1 / std::sqrt(ratio), 1000,
                                                    closed_forms::effective_modulus(steel, steel));
  constexpr double reach = 28.0 / 24.0;
  RollingPair pair(steel, steel);
  pair.rectangle(ElementType::quad4, 28, 28, reach * hertz.a, reach * hertz.b)
      .gap_quadratic(hertz.A, hertz.B)
      .friction(0)
      .approach(hertz.approach);
  ASSERT_EQ(pair.solve(), ROLLCON_OK);
  char name[40];
  std::snprintf(name, sizeof name, "a/b = %g", ratio);
  expect_hertz(name, pair.solution(), hertz);
}

INSTANTIATE_TEST_SUITE_P(AxisRatio, HertzEllipse, testing::Values(0.02, 0.5, 10.0));
INSTANTIATE_TEST_SUITE_P(AxisRatio_long, HertzEllipse, testing::Values(0.1, 0.2, 1.0, 2.0, 5.0, 50.0));

TEST(HertzClosedForm, matches_published_vectors) {
  struct Row {
    double A, B, load, e_star, a, b, p0, approach;
  };
  // The rows were recomputed from the closed form by an independent program; identical bodies, mm, N, MPa.
  const Row rows[] = {{.0008, .0002814173138, 106700, 113888.8889, 6.303597, 12.607194, 641.0603, .0765171},
                      {.01, .01, 9.1954, 344.827586, .99999992, .99999992, 4.3904808, .019999997},
                      {.001, .005, 10000, 113888.8889, 4.02895850, 1.39401596, 850.1212, .025948909},
                      {.0005, .025, 10000, 113888.8889, 6.23462653, .51648999, 1482.7537, .026104332}};
  for (const Row& r : rows) {
    const Hertz h = closed_forms::hertz_from_load(r.A, r.B, r.e_star, r.load);
    expect_error("a", relative(h.a, r.a), 2e-7);
    expect_error("b", relative(h.b, r.b), 2e-7);
    expect_error("p0", relative(h.p0, r.p0), 2e-7);
    expect_error("approach", relative(h.approach, r.approach), 4e-7);
  }
}

TEST(HertzClosedForm, slender_ellipse_tends_to_the_line) {
  const Hertz h = closed_forms::hertz_from_axes(1, 1e4, 100, 1e5);
  // The mid-section of a slender ellipse has p0 = E* A a (line contact of curvature A = 1/2R).
  expect_error("line limit of A", relative(h.A, h.p0 / (1e5 * h.a)), 1e-6);
}

}  // namespace
}  // namespace rollcon::validation
