// Frictionless elliptic contacts, semi-axes a/b from 0.1 to 10 and a slender 50:1, on one grid with 24 elements across
// both axes, stretched with the ellipse.

#include "report.hpp"
#include "support/frames.hpp"
#include "support/hertz_fit.hpp"

namespace rollcon::validation {
namespace {

using closed_forms::Elastic;
using closed_forms::Hertz;
using scenes::fit_hertz;
using scenes::FittedEllipse;
using scenes::RollingPair;
using scenes::Solution;

const Elastic steel{.shear = 82000, .poisson = 0.28};

class HertzEllipse : public testing::TestWithParam<double> {};

TEST_P(HertzEllipse, peak_pressure_axes_and_force) {
  const double ratio = GetParam();
  const Hertz exact = closed_forms::hertz_from_axes(std::sqrt(ratio), 1 / std::sqrt(ratio), 1000,
                                                    closed_forms::effective_modulus(steel, steel));
  const auto lines = frames::uniform_lines(-28.0 / 24.0, 28.0 / 24.0, 28);
  RollingPair pair(steel, steel);
  pair.frame(frames::stretch(frames::rectangle(ElementType::quad4, lines, lines), exact.a, exact.b))
      .gap_quadratic(exact.A, exact.B)
      .friction(0)
      .approach(exact.approach);
  ASSERT_EQ(pair.solve(), ROLLCON_OK);
  const Solution s = pair.solution();
  const FittedEllipse fit = fit_hertz(s, exact.a, exact.b);
  char name[40];
  std::snprintf(name, sizeof name, "a/b = %g: ", ratio);
  expect_error(std::string(name) + "force", relative(-s.force[2], exact.load), 3e-3);
  expect_error(std::string(name) + "peak pressure (fit)", relative(fit.p0, exact.p0), 1e-2);
  expect_error(std::string(name) + "semi-axis a (fit)", relative(fit.a, exact.a), 1e-2);
  expect_error(std::string(name) + "semi-axis b (fit)", relative(fit.b, exact.b), 1e-2);
}

INSTANTIATE_TEST_SUITE_P(AxisRatio, HertzEllipse, testing::Values(0.02, 0.5, 10.0));
INSTANTIATE_TEST_SUITE_P(AxisRatio_long, HertzEllipse, testing::Values(0.1, 0.2, 1.0, 2.0, 5.0, 50.0));

TEST(HertzClosedForm, matches_published_vectors) {
  struct Row {
    double A, B, load, e_star, a, b, p0, approach;
  };
  // Recomputed from the closed form by an independent program; identical bodies, mm, N, MPa.
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
  // Mid-section of a slender ellipse: p0 = E* A a (line contact of curvature A = 1/2R).
  expect_error("line limit of A", relative(h.A, h.p0 / (1e5 * h.a)), 1e-6);
}

}  // namespace
}  // namespace rollcon::validation
