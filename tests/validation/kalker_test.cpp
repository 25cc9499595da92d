// Compares with Kalker's creepage coefficients: forces of vanishing creepage and spin on elliptic contacts of identical
// half-spaces. Creepages are so small that 0.6 % of the friction bound is used. The frames are quadratic triangles in
// nine rings, because the spin moment of a long ellipse needs them (linear ones: 20 rings).

#include <array>
#include <tuple>

#include "support/linear_theory.hpp"
#include "validation/scenes.hpp"

namespace rollcon::validation {
namespace {

namespace linear = scenes::linear_theory;

constexpr double share = 0.006;  ///< fraction of mu P that the creepage would carry without slip
constexpr int rings = 9;
/// The bounds are by motion: measured were at most 1.1, 1.1 and 1.6 % of the force; 0.02, 0.4 and 1.3 % of the moment.
/// The table has three digits.
constexpr double force_bound[] = {0.0125, 0.012, 0.0175}, moment_bound[] = {2e-4, 0.004, 0.014};

class KalkerCoefficients : public testing::TestWithParam<std::tuple<double, double>> {};

TEST_P(KalkerCoefficients, forces_and_moments_of_linear_theory) {
  const double ratio = std::get<0>(GetParam()), nu = std::get<1>(GetParam());
  const Elastic body{.shear = 82000, .poisson = nu};
  const Hertz hertz = linear::ellipse(ratio, body);
  const linear::Coefficients table = linear::table(ratio, nu);
  const linear::Motions motions(table, hertz, body, share);
  RollingPair pair(body, body);
  pair.frame(graded_disc(hertz.a, hertz.b, rings, ElementType::tri6))
      .gap_quadratic(hertz.A, hertz.B)
      .load(hertz.load)
      .friction(linear::mu)
      .option("convection", "characteristic");
  std::array<scenes::RollingAnswer, 3> found;
  for (std::size_t k = 0; k < 3; ++k) {
    const linear::Motion& motion = motions.all[k];
    pair.creep(motion.creep[0], motion.creep[1], motion.creep[2]);
    EXPECT_EQ(pair.solve(), ROLLCON_OK);
    found[k] = motions.found(pair.solution());
    const auto errors = scenes::rolling_errors(found[k], motions.exact(motion, table));
    char name[80];
    std::snprintf(name, sizeof name, "a/b = %g, nu = %g, %s: ", ratio, nu, motion.name);
    expect_error(name + std::string("force"), errors.force, force_bound[k]);
    expect_error(name + std::string("moment"), errors.moment, moment_bound[k]);
  }
  const linear::Coefficients c = motions.coefficients(found);
  std::printf("C11 %.4g (%.4g), C22 %.4g (%.4g), C23 %.4g and C32 %.4g (%.4g), C33 %.4g (%.4g)\n", c.c11, table.c11,
              c.c22, table.c22, c.c23, c.c32, table.c23, c.c33, table.c33);
}

INSTANTIATE_TEST_SUITE_P(Ellipses, KalkerCoefficients,
                         testing::Combine(testing::Values(0.5, 2.0), testing::Values(0.25)));
INSTANTIATE_TEST_SUITE_P(Ellipses_long, KalkerCoefficients,
                         testing::Combine(testing::Values(0.2, 0.5, 1.0, 2.0, 5.0), testing::Values(0.0, 0.25, 0.5)));

}  // namespace
}  // namespace rollcon::validation
