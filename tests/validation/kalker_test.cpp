// Kalker's creepage coefficients: forces of vanishing creepage and spin on elliptic contacts of identical half-spaces.
// Creepages are so small that 0.6 % of the friction bound is used. Quadratic triangles in nine rings: the spin moment
// of a long ellipse needs them (linear ones: 20 rings).

#include <tuple>

#include "validation/scenes.hpp"

namespace rollcon::validation {
namespace {

using closed_forms::Kalker;

constexpr double mu = 0.3;
constexpr double share = 0.006;  ///< of mu P, that the creepage would carry without slip
constexpr int rings = 9;

class KalkerCoefficients : public testing::TestWithParam<std::tuple<double, double>> {};

TEST_P(KalkerCoefficients, within_two_percent) {
  const double ratio = std::get<0>(GetParam()), nu = std::get<1>(GetParam());
  const Elastic body{.shear = 82000, .poisson = nu};
  // ab = 1: the scales G ab, G (ab)^1.5 and G (ab)^2 are all G.
  const Hertz hertz = closed_forms::hertz_from_axes(std::sqrt(ratio), 1 / std::sqrt(ratio), 1000,
                                                    closed_forms::effective_modulus(body, body));
  const Kalker table = closed_forms::kalker_table(ratio, nu);
  const double unit = share * mu * hertz.load / body.shear;

  RollingPair pair(body, body);
  pair.frame(graded_disc(hertz.a, hertz.b, rings, ElementType::tri6))
      .gap_quadratic(hertz.A, hertz.B)
      .load(hertz.load)
      .friction(mu)
      .option("convection", "characteristic");
  auto solve = [&](double xi, double eta, double phi) {
    pair.creep(xi, eta, phi);
    EXPECT_EQ(pair.solve(), ROLLCON_OK);
    return pair.solution();
  };
  const double xi = unit / table.c11, eta = unit / table.c22;
  const double phi = unit / std::max(table.c23, table.c33);
  const Solution along = solve(xi, 0, 0), across = solve(0, eta, 0), spin = solve(0, 0, phi);
  const double c11 = -along.force[0] / (body.shear * xi);
  const double c22 = -across.force[1] / (body.shear * eta);
  const double c32 = across.moment[2] / (body.shear * eta);
  const double c23 = -spin.force[1] / (body.shear * phi);
  const double c33 = -spin.moment[2] / (body.shear * phi);
  char name[160];
  auto check = [&](const char* which, double value, double expected) {
    std::snprintf(name, sizeof name, "a/b = %g, nu = %g: %s = %.4g, table %.4g", ratio, nu, which, value, expected);
    expect_error(name, relative(value, expected), 2e-2);
  };
  check("C11", c11, table.c11);
  check("C22", c22, table.c22);
  check("C23", c23, table.c23);
  check("C32 (moment of lateral creep)", c32, table.c23);
  check("C33", c33, table.c33);
}

INSTANTIATE_TEST_SUITE_P(Ellipses, KalkerCoefficients,
                         testing::Combine(testing::Values(0.5, 2.0), testing::Values(0.25)));
INSTANTIATE_TEST_SUITE_P(Ellipses_long, KalkerCoefficients,
                         testing::Combine(testing::Values(0.2, 0.5, 1.0, 2.0, 5.0), testing::Values(0.0, 0.25, 0.5)));

}  // namespace
}  // namespace rollcon::validation
