/// Solves random scenes over wide ranges from fixed seeds: each one is solved with the laws satisfied, or ends with a
/// status that says why not. Some run at once, more for every change, others every night.

#include <map>

#include "support/extremes.hpp"
#include "support/first_seed.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

/// Expects right ends; at most so many may end without convergence.
void expect_right_ends(std::uint32_t first, std::uint32_t scenes, int most) {
  constexpr double law_bound = 1e-8;
  std::map<std::int32_t, int> count;
  double worst = 0;
  for (std::uint32_t seed = first; seed < first + scenes; ++seed) {
    const extremes::Scene scene = extremes::random_scene(seed);
    const auto pair = extremes::make_pair(scene);
    extremes::give_scene(*pair, scene);
    const extremes::Ending e = extremes::solve(*pair, scene, false, 300);
    ++count[e.status];
    EXPECT_TRUE(scene.is_right(e.status) || e.status == ROLLCON_NOT_CONVERGED)
        << "seed " << seed << ": status " << e.status << " " << e.message;
    EXPECT_TRUE(e.honest(law_bound)) << "seed " << seed << ": " << e.law.worst_name() << " " << e.law.worst();
    if (e.status == ROLLCON_ERR_LOAD) {
      EXPECT_FALSE(extremes::load_over_friction(scene) < 0.9) << "seed " << seed << ": " << e.message;
    }
    EXPECT_TRUE(e.law.finite) << "seed " << seed;
    if (e.solved()) worst = std::max(worst, e.law.worst());
    if (e.status == ROLLCON_NOT_CONVERGED) std::printf("seed %u: not converged\n", seed);
  }
  std::printf("%u scenes, worst law residual of those solved %.1e (bound %.0e)\n", scenes, worst, law_bound);
  for (const auto& [status, n] : count) std::printf("%5d %s\n", n, rollcon_status_string(status));
  EXPECT_LE(count[ROLLCON_NOT_CONVERGED], most);
}

TEST(stability, random_scenes_end_solved_or_with_a_status) {
  // One in a hundred of the seeds that nobody has tried does not converge, which is the rate of the long test.
  expect_right_ends(extremes::first_seed(), 40, extremes::first_seed() == 1 ? 0 : 2);
}

TEST(stability_long, random_scenes_end_solved_or_with_a_status) {
  expect_right_ends(extremes::first_seed() + 40, 60, 1);
}

TEST(stability_nightly, random_scenes_end_solved_or_with_a_status) {
  expect_right_ends(extremes::first_seed() + 100, 300, 4);
}

}  // namespace
}  // namespace rollcon
