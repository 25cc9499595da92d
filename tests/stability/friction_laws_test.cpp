/// Solves random scenes under each law of friction, loads included: they are solved with the law satisfied, or end with
/// a status that says why not.

#include <map>
#include <string>

#include "support/extremes.hpp"
#include "support/first_seed.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

constexpr double law_bound = 1e-8;

/// Expects the laws to hold; at most so many scenes may end without convergence.
void expect_laws_kept(const std::string& law, std::uint32_t first, std::uint32_t scenes, int most) {
  std::map<std::int32_t, int> count;
  double worst = 0, iterations = 0;
  int solved = 0, undecided = 0;
  for (std::uint32_t seed = first; seed < first + scenes; ++seed) {
    const extremes::Scene scene = extremes::law_scene(law, seed);
    const auto pair = extremes::make_pair(scene);
    extremes::give_scene(*pair, scene);
    const extremes::Ending e = extremes::solve(*pair, scene, false, 300);
    // Loads that only friction at rest carries may have no steady solution; nothing but the iteration tells.
    const auto& by_force = scene.given.by_force;
    const bool loads = by_force[0] || by_force[1] || by_force[3];
    if (e.status == ROLLCON_NOT_CONVERGED && loads && !scene.given.law.orthotropic())
      ++undecided;
    else
      ++count[e.status];
    EXPECT_TRUE(scene.is_right(e.status) || e.status == ROLLCON_NOT_CONVERGED)
        << law << ", seed " << seed << ": status " << e.status << " " << e.message;
    EXPECT_TRUE(e.honest(law_bound)) << law << ", seed " << seed << ": " << e.law.worst_name() << " " << e.law.worst()
                                     << " " << extremes::describe(scene);
    if (e.status == ROLLCON_ERR_LOAD) {
      EXPECT_FALSE(extremes::loads_over_friction(scene) < 0.9) << law << ", seed " << seed << ": " << e.message;
    }
    EXPECT_TRUE(e.law.finite) << law << ", seed " << seed;
    if (e.solved()) worst = std::max(worst, e.law.worst()), iterations += e.iterations, ++solved;
    if (e.status == ROLLCON_NOT_CONVERGED)
      std::printf("%s, seed %u: not converged, loads %.3f of those of fast sliding, %s\n", law.c_str(), seed,
                  extremes::loads_over_friction(scene), extremes::describe(scene).c_str());
  }
  std::printf("%s: %u scenes, worst law residual of those solved %.1e (bound %.0e), %.1f iterations\n", law.c_str(),
              scenes, worst, law_bound, iterations / std::max(1, solved));
  if (undecided > 0) std::printf("%5d not converged under loads and friction that falls\n", undecided);
  EXPECT_LE(undecided, scenes / 10);
  for (const auto& [status, n] : count) std::printf("%5d %s\n", n, rollcon_status_string(status));
  EXPECT_LE(count[ROLLCON_NOT_CONVERGED], most);
}

class friction_laws : public testing::TestWithParam<const char*> {};
class friction_laws_long : public testing::TestWithParam<const char*> {};
class friction_laws_nightly : public testing::TestWithParam<const char*> {};

TEST_P(friction_laws, random_scenes_end_solved_or_with_a_status) {
  expect_laws_kept(GetParam(), extremes::first_seed(), 20, 1);
}

TEST_P(friction_laws_long, random_scenes_end_solved_or_with_a_status) {
  // No principle of greatest power stands behind slip against the traction.
  expect_laws_kept(GetParam(), extremes::first_seed() + 20, 30, std::string(GetParam()) == "orthotropic" ? 1 : 4);
}

TEST_P(friction_laws_nightly, random_scenes_end_solved_or_with_a_status) {
  expect_laws_kept(GetParam(), extremes::first_seed() + 50, 450, std::string(GetParam()) == "orthotropic" ? 6 : 14);
}

constexpr const char* all[] = {"orthotropic", "orthotropic_collinear", "linear", "rational", "exponential"};
INSTANTIATE_TEST_SUITE_P(laws, friction_laws, testing::ValuesIn(all));
INSTANTIATE_TEST_SUITE_P(laws_long, friction_laws_long, testing::ValuesIn(all));
INSTANTIATE_TEST_SUITE_P(laws_nightly, friction_laws_nightly, testing::ValuesIn(all));

}  // namespace
}  // namespace rollcon
