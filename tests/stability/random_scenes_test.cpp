/// Random scenes over wide ranges from fixed seeds: each one is solved with the laws satisfied, or
/// ends with a status that says why not.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>

#include "support/extremes.hpp"

namespace rollcon {
namespace {

TEST(stability, random_scenes_end_solved_or_with_a_status) {
  constexpr std::uint32_t scenes = 400;
  constexpr double law_bound = 1e-8;
  std::map<std::int32_t, int> count;
  double worst = 0;
  for (std::uint32_t seed = 1; seed <= scenes; ++seed) {
    const extremes::Scene scene = extremes::random_scene(seed);
    const auto pair = extremes::make_pair(scene);
    extremes::give_scene(*pair, scene);
    const extremes::Ending e = extremes::solve(*pair, scene, false, 300);
    ++count[e.status];
    EXPECT_TRUE(std::count(scene.right.begin(), scene.right.end(), e.status) > 0 ||
                e.status == ROLLCON_NOT_CONVERGED)
        << "seed " << seed << ": status " << e.status << " " << e.message;
    EXPECT_TRUE(e.honest(law_bound))
        << "seed " << seed << ": " << e.law.worst_name() << " " << e.law.worst();
    if (e.status == ROLLCON_ERR_LOAD) {
      EXPECT_FALSE(extremes::load_over_friction(scene) < 0.9)
          << "seed " << seed << ": " << e.message;
    }
    EXPECT_TRUE(e.law.finite) << "seed " << seed;
    if (e.solved()) worst = std::max(worst, e.law.worst());
    if (e.status == ROLLCON_NOT_CONVERGED) std::printf("seed %u: not converged\n", seed);
  }
  std::printf("%u scenes, worst law residual of those solved %.1e (bound %.0e)\n", scenes, worst,
              law_bound);
  for (const auto& [status, n] : count) std::printf("%5d %s\n", n, rollcon_status_string(status));
  EXPECT_LE(count[ROLLCON_NOT_CONVERGED], 4);
}

}  // namespace
}  // namespace rollcon
