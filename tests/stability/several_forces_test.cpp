/// Solves with two or three tangential loads given at once, from none to a tenth more than friction carries: what is
/// called solved obeys all laws and carries all loads, and what is refused is too much.

#include <map>

#include "support/extremes.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

constexpr double law_bound = 1e-8;

TEST(stability, several_loads_are_carried_or_refused) {
  constexpr std::uint32_t scenes = 200;
  // Rounding and the scheme decide what is nearer than this to the limit.
  constexpr double least_refused = 0.97;
  std::map<std::int32_t, int> count;
  double worst = 0, equilibrium = 0, least = INFINITY, most = 0;
  for (std::uint32_t seed = 1; seed <= scenes; ++seed) {
    const extremes::Scene scene = extremes::forces_scene(seed);
    const auto pair = extremes::make_pair(scene);
    extremes::give_scene(*pair, scene);
    const extremes::Ending e = extremes::solve(*pair, scene, false, 300);
    ++count[e.status];
    EXPECT_TRUE(scene.is_right(e.status) || e.status == ROLLCON_NOT_CONVERGED)
        << seed << ": " << e.status << " " << e.message;
    EXPECT_TRUE(e.honest(law_bound)) << seed << ": " << e.law.worst_name() << " " << e.law.worst();
    if (e.solved()) {
      worst = std::max(worst, e.law.worst());
      equilibrium = std::max(equilibrium, e.law.equilibrium);
      continue;
    }
    const double share = extremes::loads_over_friction(scene);
    EXPECT_FALSE(share < least_refused) << seed << ": " << share << " of what friction carries; " << e.status << " "
                                        << e.message;
    if (e.status == ROLLCON_ERR_LOAD)
      least = std::min(least, share);
    else
      std::printf("seed %u: not converged at %.4f\n", seed, share);
    most = std::max(most, share);
  }
  std::printf(
      "%u scenes, worst law residual %.1e, of loads %.1e (bound %.0e); refused from %.4f to %.4f of what friction "
      "carries (bound %.2f)\n",
      scenes, worst, equilibrium, law_bound, least, most, least_refused);
  for (const auto& [status, n] : count) std::printf("%5d %s\n", n, rollcon_status_string(status));
}

}  // namespace
}  // namespace rollcon
