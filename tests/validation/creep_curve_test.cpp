// Compares force against longitudinal creepage from full stick to full slip with tabulated output of the half-space
// program CONTACT (tests/data/creep_curve.csv): force vector and, zero by symmetry, spin moment.

#include "validation/laws.hpp"

namespace rollcon::validation {
namespace {

TEST(CreepCurve, ellipse_from_stick_to_slip) {
  const Elastic steel{.shear = 82000, .poisson = 0.28};
  const double mu = 0.33;
  const Hertz hertz =
      closed_forms::hertz_from_load(.0008, .0002814173138, closed_forms::effective_modulus(steel, steel), 106700);
  RollingPair pair(steel, steel);
  pair.frame(graded_disc(hertz.a, hertz.b, 12))
      .gap_quadratic(hertz.A, hertz.B)
      .load(hertz.load)
      .friction(mu)
      .option("convection", "characteristic");
  double last = 0;
  for (const auto& point : closed_forms::creep_curve()) {
    pair.creep(-point.xi, 0, 0);
    ASSERT_EQ(pair.solve(), ROLLCON_OK);
    const Solution s = pair.solution();
    const auto found = scenes::found_forces(s, mu * hertz.load, std::sqrt(hertz.a * hertz.b));
    const auto errors = scenes::rolling_errors(found, {{point.force_ratio, 0}, 0});
    const double ratio = found.force[0];
    char name[160];
    std::snprintf(name, sizeof name, "xi = %.1e: F/(mu P) = %.5f, CONTACT %.5f", point.xi, ratio, point.force_ratio);
    // CONTACT's own error is 1.5 % in the linear range.
    expect_error(name, errors.force, 1.05e-2);
    expect_error(name + std::string(": moment"), errors.moment, 1.6e-4);
    EXPECT_GT(ratio, last);  // the curve rises
    EXPECT_LE(ratio, 1 + 1e-9);
    last = ratio;
    expect_laws(name, check_laws(s, mu, point.xi));
  }
  // The linear range has 243.30 N at 1e-5 by Kalker's theory.
  pair.creep(-1e-5, 0, 0);
  ASSERT_EQ(pair.solve(), ROLLCON_OK);
  expect_error("force at xi = 1e-5 against linear theory", relative(pair.solution().force[0], 243.30), 2e-2);
}

}  // namespace
}  // namespace rollcon::validation
