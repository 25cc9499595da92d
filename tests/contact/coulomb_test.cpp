/// Coulomb's projection and its derivative against finite differences.

#include "contact/laws/coulomb.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "support/frames.hpp"

namespace rollcon {
namespace {

// Residual lambda_t - P(lambda_t - s; bound = -mu lambda_n), slip already scaled.
void residual(double l1, double l2, double ln, double s1, double s2, double mu, double* r) {
  double t1 = 0, t2 = 0;
  project_on_disk(l1 - s1, l2 - s2, -mu * ln, t1, t2);
  r[0] = l1 - t1;
  r[1] = l2 - t2;
}

TEST(coulomb, linearisation_is_the_derivative_of_the_projection) {
  frames::Random random(3);
  double worst = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const double l1 = random(), l2 = random(), ln = -1.5 - random(), mu = 0.4;
    const double s1 = 2 * random(), s2 = 2 * random();
    const double a1 = l1 - s1, a2 = l2 - s2, bound = -mu * ln;
    if (std::abs(std::hypot(a1, a2) - bound) < 1e-3) continue;
    const TangentialLaw law = linearise_coulomb(a1, a2, mu, bound, true);
    EXPECT_EQ(law.sliding, std::hypot(a1, a2) > bound);
    const double h = 1e-6;
    const double x[5] = {l1, l2, ln, s1, s2};
    for (int column = 0; column < 5; ++column) {
      double plus[5], minus[5], rp[2], rm[2];
      for (int k = 0; k < 5; ++k) plus[k] = minus[k] = x[k];
      plus[column] += h;
      minus[column] -= h;
      residual(plus[0], plus[1], plus[2], plus[3], plus[4], mu, rp);
      residual(minus[0], minus[1], minus[2], minus[3], minus[4], mu, rm);
      for (int row = 0; row < 2; ++row) {
        const double exact = column < 3 ? law.own[row][column] : law.slip[row][column - 3];
        worst = std::max(worst, std::abs((rp[row] - rm[row]) / (2 * h) - exact));
      }
    }
  }
  std::printf("derivative of Coulomb's law: difference %.1e (bound 1e-8)\n", worst);
  EXPECT_LT(worst, 1e-8);
}

TEST(coulomb, a_fixed_point_satisfies_the_linearised_row) {
  // Sliding solution: lambda_t = bound e, slip opposite to it.
  const double mu = 0.3, ln = -2, bound = 0.6, e1 = 0.6, e2 = -0.8, slip = 1.7;
  const double l1 = bound * e1, l2 = bound * e2, s1 = -slip * e1, s2 = -slip * e2;
  for (const bool follows : {true, false}) {
    const TangentialLaw law = linearise_coulomb(l1 - s1, l2 - s2, mu, bound, follows);
    for (int row = 0; row < 2; ++row) {
      const double value = law.own[row][0] * l1 + law.own[row][1] * l2 + law.own[row][2] * ln +
                           law.slip[row][0] * s1 + law.slip[row][1] * s2;
      EXPECT_NEAR(value, law.constant[row], 1e-15);
    }
  }
}

TEST(coulomb, no_friction_means_no_traction) {
  const TangentialLaw law = linearise_coulomb(0, 0, 0, 0, true);
  EXPECT_TRUE(law.sliding);
  EXPECT_EQ(law.own[0][0], 1);
  EXPECT_EQ(law.own[1][1], 1);
  EXPECT_EQ(law.slip[0][0], 0);
}

}  // namespace
}  // namespace rollcon
