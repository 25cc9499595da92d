// Cases (a) and (b), a circular contact of identical bodies in steady rolling: error of the forces against the
// extrapolated limits, beside what the half-space program CONTACT reaches on grids of the same number of nodes.

#include "support/steady_rolling.hpp"

#include "validation/scenes.hpp"

namespace rollcon::validation {
namespace {

namespace steady_rolling = scenes::steady_rolling;
using steady_rolling::contact_error;

class SteadyRollingOnGrids : public testing::TestWithParam<int> {};

TEST_P(SteadyRollingOnGrids, beside_contact) {
  const int n = GetParam();
  for (const std::string which : {"a", "b"}) {
    RollingPair pair(steady_rolling::steel, steady_rolling::steel);
    steady_rolling::prepare(pair, steady_rolling::grid(n), which);
    for (const char* scheme : {"godunov", "least_squares", "characteristic"}) {
      pair.option("convection", scheme);
      ASSERT_EQ(pair.solve(), ROLLCON_OK);
      const double error = steady_rolling::force_error(pair.solution(), which);
      char name[120];
      std::snprintf(name, sizeof name, "case %s, N = %d, %s: Fx (CONTACT %.2f %%, ratio %.2f)", which.c_str(), n,
                    scheme, 100 * contact_error(which, n), std::abs(error) / contact_error(which, n));
      // First-order upwinding on a grid: no worse than half as much again as CONTACT, whose limit is known to 0.001.
      expect_error(name, error, 1.5 * contact_error(which, n) + 0.001);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(N, SteadyRollingOnGrids, testing::Values(16, 20));
INSTANTIATE_TEST_SUITE_P(N_long, SteadyRollingOnGrids, testing::Values(24, 32, 40));

class SteadyRollingOnRings : public testing::TestWithParam<int> {};

TEST_P(SteadyRollingOnRings, characteristic_scheme_on_frames_fitted_to_the_contact) {
  const int n = GetParam();
  for (const std::string which : {"a", "b"}) {
    RollingPair pair(steady_rolling::steel, steady_rolling::steel);
    steady_rolling::prepare(pair, graded_disc(steady_rolling::radius, steady_rolling::radius, n), which);
    pair.option("convection", "characteristic");
    ASSERT_EQ(pair.solve(), ROLLCON_OK);
    const Solution s = pair.solution();
    const double scale = steady_rolling::mu * steady_rolling::hertz.load;
    const std::string name = "case " + which + ", " + std::to_string(n) + " rings, " +
                             std::to_string(std::lround(pair.stat("nodes_contact"))) + " nodes: ";
    // Second order in the rings, 1.2 % at eight; the limits are known to 0.0008 and 0.0002.
    const double h2 = 64.0 / (n * n);
    expect_error(name + "Fx", steady_rolling::force_error(s, which), 1.2e-2 * h2 + 8e-4);
    if (which == "a") continue;
    expect_error(name + "Fy, in mu Fn", s.force[1] / scale - closed_forms::steady_rolling("b", "fy"), 8e-3 * h2 + 2e-4);
    expect_error(name + "Mz, in mu Fn a",
                 s.moment[2] / (scale * steady_rolling::radius) - closed_forms::steady_rolling("b", "mz"), 2e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(Rings, SteadyRollingOnRings, testing::Values(6, 8));
INSTANTIATE_TEST_SUITE_P(Rings_long, SteadyRollingOnRings, testing::Values(12, 16));

}  // namespace
}  // namespace rollcon::validation
