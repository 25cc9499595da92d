/// Solves named and random extreme scenes with bodies that have meshes: each is solved with the laws of contact
/// satisfied, recomputed without the solver, or ends with the status that is right.

#include <map>

#include "support/extreme_bodies.hpp"
#include "support/first_seed.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using extremes::Ending;
using extremes::Scene;

constexpr double law_bound = 1e-8;

Ending run(const Scene& scene) {
  const auto pair = extremes::make_pair(scene);
  extremes::give_scene(*pair, scene);
  return extremes::solve(*pair, scene);
}

TEST(stability_bodies_long, named_scenes_keep_the_laws) {
  double worst = 0, iterations = 0;
  int solved = 0;
  for (const Scene& scene : extremes::named_body_scenes()) {
    const Ending e = run(scene);
    const std::string name = scene.group + ": " + scene.name;
    EXPECT_TRUE(scene.is_right(e.status) || e.status == ROLLCON_INACCURATE)
        << name << ": status " << e.status << " " << e.message << rollcon_last_caveat();
    if (!e.solved()) continue;
    ++solved;
    EXPECT_LE(e.law.worst(), law_bound) << name << ": " << e.law.worst_name();
    EXPECT_GE(e.law.turn, scene.turn) << name << ": contact does not reach as far (radian)";
    worst = std::max(worst, e.law.worst());
    iterations = std::max(iterations, e.iterations);
  }
  std::printf("%d scenes solved, worst law %.1e (bound %.0e), most iterations %.0f\n", solved, worst, law_bound,
              iterations);
  EXPECT_GE(solved, 120);
}

// The bench runs more of them.
/// Expects right ends; at most so many may end without convergence.
void expect_right_ends(std::uint32_t first, std::uint32_t scenes, int most) {
  std::map<std::int32_t, int> ended;
  double worst = 0;
  for (std::uint32_t seed = first; seed < first + scenes; ++seed) {
    const Scene scene = extremes::random_body_scene(seed);
    const Ending e = run(scene);
    ++ended[e.status];
    EXPECT_TRUE(scene.is_right(e.status) || e.status == ROLLCON_NOT_CONVERGED || e.status == ROLLCON_INACCURATE)
        << seed << ": status " << e.status << " " << e.message;
    if (e.solved()) {
      EXPECT_LE(e.law.worst(), law_bound) << seed << ": " << e.law.worst_name();
      worst = std::max(worst, e.law.worst());
    }
  }
  for (const auto& [status, count] : ended) std::printf("status %d: %d\n", status, count);
  std::printf("worst law %.1e (bound %.0e)\n", worst, law_bound);
  EXPECT_LE(ended[ROLLCON_NOT_CONVERGED], most);
}

TEST(stability_bodies, random_scenes_end_solved_or_with_the_right_status) {
  expect_right_ends(extremes::first_seed() + 135, 15, 0);
}

TEST(stability_bodies_long, random_scenes_end_solved_or_with_the_right_status) {
  expect_right_ends(extremes::first_seed(), 135, 2);
}

}  // namespace
}  // namespace rollcon
