/// Solves random scenes in steps of time, rolling and shifted, everything changed from step to step: each step is
/// solved with its laws satisfied, or ends with a status that says why not and leaves the one before unchanged.

#include <algorithm>
#include <map>
#include <random>

#include "support/extreme_bodies.hpp"
#include "support/extremes.hpp"
#include "support/first_seed.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

/// Says what the steps of one scene did.
struct Walk {
  std::map<std::int32_t, int> count;
  double worst = 0, iterations = 0, fallbacks = 0;
  int solved = 0;
};

/// Returns the spacing of the frame.
double spacing_of(const SurfaceMesh& mesh) {
  double low[2] = {1e300, 1e300}, high[2] = {-1e300, -1e300};
  for (const Vec3& x : mesh.node)
    for (std::size_t c = 0; c < 2; ++c) low[c] = std::min(low[c], x[c]), high[c] = std::max(high[c], x[c]);
  return std::sqrt((high[0] - low[0]) * (high[1] - low[1]) / static_cast<double>(mesh.nodes()));
}

void walk(const extremes::Scene& base, std::uint32_t seed, int steps, Walk& to) {
  constexpr double law_bound = 1e-8;
  std::mt19937 draw(seed);
  const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(draw); };
  const auto pair = extremes::make_pair(base);
  extremes::give_scene(*pair, base);
  const double h = spacing_of(base.given.frame);
  double distance = 0;
  bool any = false;  // a step was made
  std::vector<double> before, gap;
  std::function<std::vector<double>(double)> past = [](double) { return std::vector<double>(); };
  for (int k = 0; k < steps; ++k) {
    extremes::Scene scene = base;
    const bool shift = between(0, 1) < 0.3;
    distance = shift ? 0 : h * std::exp(between(std::log(0.2), std::log(40)));
    const double dt = shift ? between(0.5, 2) : distance / scene.given.speed;
    for (std::size_t d = 0; d < 4; ++d) {
      double factor = d == 2 ? between(0.7, 1.4) : between(-1, 1);
      if (shift && d != 2 && !scene.given.by_force[d]) factor *= 5 * h;
      scene.given.value[d] *= factor;
    }
    const double more = between(0.8, 1.2);
    for (double& mu : scene.given.friction) mu *= more;
    extremes::give_loads(*pair, scene);
    ASSERT_EQ(rollcon_contact_set_step(pair->handle(), shift ? ROLLCON_SHIFT_STEP : ROLLCON_ROLLING_STEP, dt), 0);
    // The tractions of the last step that was solved remain the contact's only until the next solve.
    if (any) before = laws::displacements_before(pair->handle(), base.given, distance);
    scene.given.in_time = laws::TimeStep{distance, dt, before, gap};
    const extremes::Ending e = extremes::solve(*pair, scene, false, 300);
    ++to.count[e.status];
    EXPECT_TRUE(e.honest(law_bound)) << "seed " << seed << ", step " << k << ": " << e.law.worst_name() << " "
                                     << e.law.worst() << (shift ? ", shift " : ", rolled ") << distance / h << " h";
    EXPECT_TRUE(e.law.finite) << "seed " << seed;
    EXPECT_TRUE(e.solved() || e.status == ROLLCON_NOT_CONVERGED || e.status == ROLLCON_ERR_LOAD ||
                base.is_right(e.status))
        << "seed " << seed << ", step " << k << ": status " << e.status << " " << e.message;
    if (e.status == ROLLCON_NOT_CONVERGED)
      std::printf("seed %u, step %d: not converged; %s\n", seed, k, extremes::describe(base).c_str());
    if (!e.solved()) return;  // what it leaves is looked at in another test
    any = true;
    ++to.solved;
    to.worst = std::max(to.worst, e.law.worst());
    to.iterations += e.iterations;
    to.fallbacks += e.fallbacks;
    gap.clear();
    if (e.status == ROLLCON_NO_CONTACT) continue;
    gap.resize(base.given.frame.node.size());
    std::int64_t count = 0;
    const auto room = static_cast<std::int64_t>(gap.size());
    ASSERT_EQ(rollcon_contact_get_field(pair->handle(), ROLLCON_FIELD_GAP, ROLLCON_LOCAL, room, gap.data(), &count), 0);
  }
}

void expect_right_steps(std::uint32_t first, std::uint32_t scenes, bool bodies, double most_failures) {
  Walk all;
  for (std::uint32_t seed = first; seed < first + scenes; ++seed)
    walk(bodies ? extremes::random_body_scene(seed) : extremes::random_scene(seed), seed, 5, all);
  std::printf(
      "%u scenes, %d steps solved, worst law residual %.1e (bound 1e-8), %.1f iterations a step, %.3f fallbacks\n",
      scenes, all.solved, all.worst, all.iterations / std::max(all.solved, 1), all.fallbacks / std::max(all.solved, 1));
  for (const auto& [status, n] : all.count) std::printf("%5d %s\n", n, rollcon_status_string(status));
  EXPECT_LE(all.count[ROLLCON_NOT_CONVERGED], std::max(1.0, most_failures * all.solved));
}

TEST(stability, random_scenes_in_time_steps) {
  expect_right_steps(extremes::first_seed(), 10, false, 0.02);
}

TEST(stability, random_bodies_in_time_steps) {
  expect_right_steps(extremes::first_seed(), 8, true, 0.02);
}

TEST(stability_long, random_bodies_in_time_steps) {
  expect_right_steps(extremes::first_seed() + 8, 24, true, 0.02);
}

TEST(stability_nightly, random_bodies_in_time_steps) {
  expect_right_steps(extremes::first_seed() + 32, 36, true, 0.02);
}

TEST(stability_long, random_scenes_in_time_steps) {
  expect_right_steps(extremes::first_seed() + 10, 20, false, 0.02);
}

TEST(stability_nightly, random_scenes_in_time_steps) {
  expect_right_steps(extremes::first_seed() + 30, 370, false, 0.02);
}

}  // namespace
}  // namespace rollcon
