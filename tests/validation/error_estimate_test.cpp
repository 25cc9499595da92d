// Compares error estimates with true errors by their effectivity (estimate over error), on scenes with known solutions,
// several meshes each. Printed are both, and the bounds of their ratio.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "support/effectivity.hpp"
#include "support/example2.hpp"
#include "validation/scenes.hpp"

namespace rollcon::validation {
namespace {

using namespace scenes;

constexpr const char* normal = "normal force";
constexpr const char* tangential = "tangential force";
constexpr const char* tractions = "tractions";

/// Expects effectivities of one quantity, each in [least, most]. Errors below `accidental` are no measure of how far
/// too large an estimate is: there the upper bound is that of this error.
std::vector<Judged> expect_effectivity(const std::vector<Judgement>& scenes, const char* quantity, double least,
                                       double most, double accidental = 0) {
  std::vector<Judged> found;
  for (const Judgement& scene : scenes)
    for (const Judged& j : scene) {
      if (j.quantity != quantity) continue;
      const double e = j.effectivity(), above = j.error < accidental ? j.estimate / accidental : e;
      const std::string what = j.scene + ", " + j.mesh + ", " + j.scheme + ": " + quantity;
      std::printf("%-66s estimate %8.1e  error %8.1e  effectivity %5.2f  bounds %.2f to %.2f%s\n", what.c_str(),
                  j.estimate, j.error, e, least, most, e >= least && above <= most ? "" : "  FAILS");
      EXPECT_GE(e, least) << what;
      EXPECT_LE(above, most) << what;
      found.push_back(j);
    }
  EXPECT_EQ(found.size(), scenes.size());
  return found;
}

/// Expects estimates to fall from the first mesh to the last like the errors: their orders differ by no more than
/// `slack`.
void expect_rate(const std::vector<Judged>& meshes, double refinement, double slack) {
  const Judged &coarse = meshes.front(), &fine = meshes.back();
  const double estimated = observed_order(coarse.estimate, fine.estimate, refinement, 1);
  const double true_order = observed_order(coarse.error, fine.error, refinement, 1);
  std::printf("%-66s order %.2f of the estimates, %.2f of the errors (bound of the difference %.1f)\n",
              (coarse.scene + ": " + coarse.quantity).c_str(), estimated, true_order, slack);
  EXPECT_GT(estimated, 0.5);
  EXPECT_LE(std::abs(estimated - true_order), slack);
}

TEST(ErrorEstimate_long, normal_force_and_pressures_on_grids) {
  for (const bool quadratic : {false, true})
    for (const bool triangles : {false, true}) {
      std::vector<Judgement> scenes;
      for (const int across : {8, 12, 16, 24, 36})
        scenes.push_back(judge_hertz(judged_grid(1, 1, across, triangles, quadratic)));
      // Quadratic elements' own errors change sign on the way.
      const auto found = expect_effectivity(scenes, normal, 0.4, quadratic ? 4 : 2);
      expect_rate(found, 36.0 / 8, 1);
      expect_effectivity(scenes, tractions, 0.4, 2.5);
    }
}

TEST(ErrorEstimate, normal_force_and_pressures_on_fitted_rings) {
  std::vector<Judgement> scenes;
  for (const int rings : {5, 6, 8, 12, 16}) scenes.push_back(judge_hertz(judged_rings(1, 1, rings)));
  expect_rate(expect_effectivity(scenes, normal, 0.9, 1.1), 16.0 / 5, 0.2);
  expect_effectivity(scenes, tractions, 0.4, 2.5);
}

class ErrorEstimateOfRolling : public testing::TestWithParam<const char*> {};

TEST_P(ErrorEstimateOfRolling, on_fitted_rings) {
  for (const std::string which : {"a", "b"}) {
    std::vector<Judgement> scenes;
    for (const int rings : {8, 12, 16})
      scenes.push_back(judge_steady_rolling(which, judged_rings(5, 5, rings), GetParam()));
    expect_effectivity(scenes, normal, 0.9, 1.1);
    // The error of least squares in case (a) changes its sign on five or six rings.
    expect_effectivity(scenes, tangential, 0.6, 4);
  }
}

TEST_P(ErrorEstimateOfRolling, on_grids) {
  for (const std::string which : {"a", "b"}) {
    std::vector<Judgement> scenes;
    for (const int across : {12, 16, 24})
      scenes.push_back(judge_steady_rolling(which, judged_grid(5, 5, across), GetParam()));
    expect_effectivity(scenes, normal, 0.4, 2);
    expect_effectivity(scenes, tangential, 0.3, 5);
  }
}

TEST_P(ErrorEstimateOfRolling, on_a_strip) {
  std::vector<Judgement> scenes;
  for (const int across : {12, 16, 24, 36}) scenes.push_back(judge_carter(across, false, GetParam()));
  expect_rate(expect_effectivity(scenes, tangential, 0.4, 4), 3, 0.8);
}

/// Says whether the scheme errs little where unlike bodies touch: the error of the characteristic scheme changes its
/// sign near the standard step and with the mesh, and is less there than estimates can tell.
bool errs_little(const std::string& scheme) {
  return scheme == "characteristic";
}

TEST_P(ErrorEstimateOfRolling, of_the_sphere_on_rings) {
  std::vector<Judgement> scenes;
  for (const int rings : {6, 8, 12}) scenes.push_back(judge_example3(rings, GetParam()));
  expect_effectivity(scenes, tangential, 0.4, errs_little(GetParam()) ? 40 : 4);
}

TEST_P(ErrorEstimateOfRolling, of_a_ball_on_a_block) {
  for (const bool finite_elements : {true, false}) {
    if (!rollcon_has_feature(finite_elements ? "fem" : "bem")) continue;
    std::vector<Judgement> scenes;
    for (const int across : {10, 16}) scenes.push_back(judge_block(finite_elements, across, GetParam()));
    expect_effectivity(scenes, normal, 0.3, 3);
    expect_effectivity(scenes, tangential, 0.3, errs_little(GetParam()) ? 40 : 7, errs_little(GetParam()) ? 0.01 : 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Schemes, ErrorEstimateOfRolling, testing::Values("characteristic"),
                         [](const auto& info) { return std::string(info.param); });
INSTANTIATE_TEST_SUITE_P(Schemes_long, ErrorEstimateOfRolling, testing::Values("godunov", "least_squares"),
                         [](const auto& info) { return std::string(info.param); });

TEST(ErrorEstimate_long, from_stick_to_slip) {
  const std::vector<double> axes = creep_curve_axes();
  for (const double xi : {8e-4, 1.6e-3, 2.4e-3}) {
    std::vector<Judgement> scenes;
    for (const int rings : {6, 8})
      scenes.push_back(judge_creep_curve(xi, judged_rings(axes[0], axes[1], rings), "characteristic"));
    expect_effectivity(scenes, tangential, 0.4, 4);
  }
}

TEST(ErrorEstimate_long, of_linear_theory) {
  for (const int direction : {1, 2, 3}) {
    std::vector<Judgement> scenes;
    for (const int rings : {5, 6, 8}) scenes.push_back(judge_linear_theory(direction, rings, "characteristic"));
    expect_effectivity(scenes, tangential, 0.3, 6);
  }
}

// No solution is known here; the finer ring's estimates must be numbers, and less.
TEST(ErrorEstimate_long, on_the_curved_frame_of_a_ring) {
  if (!rollcon_has_feature("fem")) GTEST_SKIP() << "this build has no finite elements";
  namespace example2 = scenes::example2;
  const char* names[] = {"error_estimate_normal", "error_estimate_tangential", "error_estimate_tractions"};
  double last[] = {0.02, 0.2, 0.5};
  for (const int parts : {8, 12}) {
    const auto pair = example2::pair(example2::ring_of(parts), VolumeType::hex8, example2::Ground::half_space);
    // The coarse ring's elements are deep for the contact, which is told.
    ASSERT_EQ(pair->solve(), parts == 8 ? ROLLCON_INACCURATE : ROLLCON_OK);
    for (std::size_t i = 0; i < 3; ++i) {
      const double value = pair->stat(names[i]);
      std::printf("%2d parts: %-30s %8.1e  bounds 0 to %8.1e\n", parts, names[i], value, last[i]);
      EXPECT_GT(value, 0);
      EXPECT_LT(value, last[i]);
      last[i] = value;
    }
  }
}

}  // namespace
}  // namespace rollcon::validation
