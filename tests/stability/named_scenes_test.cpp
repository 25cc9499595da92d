/// Solves the named extreme scenes, from nothing and from a wildly different state of the same contact, with the laws
/// of contact satisfied, recomputed without the solver, or to the status that is right for them.

#include <map>

#include "support/extremes.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using extremes::Ending;
using extremes::Scene;

constexpr double law_bound = 1e-8;
/// Two solutions of residual 1e-10 may differ by this much of the largest traction.
constexpr double warm_bound = 1e-6;

std::string full_name(const Scene& scene) {
  return scene.group + ": " + scene.name;
}

void expect_right(const Scene& scene, const Ending& e, const char* start) {
  EXPECT_TRUE(scene.is_right(e.status)) << full_name(scene) << ", " << start << ": status " << e.status << " "
                                        << e.message;
  if (!e.solved()) return;
  EXPECT_LE(e.law.worst(), law_bound) << full_name(scene) << ", " << start << ": " << e.law.worst_name();
}

/// Takes every second scene from the first one.
void expect_laws_kept(std::size_t first) {
  struct Row {
    int scenes = 0, refused = 0, warm = 0;
    double law = 0, difference = 0, iterations = 0;
  };
  std::map<std::string, Row> table;
  int count = 0;
  const std::vector<Scene> scenes = extremes::named_scenes();
  for (std::size_t i = first; i < scenes.size(); i += 2) {
    const Scene& scene = scenes[i];
    Row& row = table[scene.group];
    const auto pair = extremes::make_pair(scene);
    extremes::give_scene(*pair, scene);
    const Ending cold = extremes::solve(*pair, scene, false, 300);
    expect_right(scene, cold, "cold");
    ++row.scenes;
    row.refused += !cold.solved();
    row.iterations = std::max(row.iterations, cold.iterations);
    if (cold.solved()) row.law = std::max(row.law, cold.law.worst());
    ++count;
    if (scene.given.frame.nodes() > 2000) continue;
    const Scene other = extremes::disturbed(scene, count % 3);
    pair->reset();  // nothing may be predicted from the solution wanted
    extremes::give_loads(*pair, other);
    const std::int32_t before = rollcon_contact_solve(pair->handle());
    EXPECT_NE(before, ROLLCON_ERR_INTERNAL) << full_name(scene);
    extremes::give_loads(*pair, scene);
    const Ending warm = extremes::solve(*pair, scene, false, 300);
    expect_right(scene, warm, "warm");
    EXPECT_EQ(warm.status, cold.status) << full_name(scene);
    if (!warm.solved() || !cold.solved()) continue;
    const double difference = extremes::traction_difference(warm.traction, cold.traction);
    EXPECT_LE(difference, warm_bound) << full_name(scene);
    ++row.warm;
    row.law = std::max(row.law, warm.law.worst());
    row.difference = std::max(row.difference, difference);
  }
  std::printf("%-24s %7s %8s %10s %10s %12s\n", "group", "scenes", "refused", "law", "iterations", "warm - cold");
  for (const auto& [group, row] : table)
    std::printf("%-24s %7d %8d %10.1e %10.0f %12.1e\n", group.c_str(), row.scenes, row.refused, row.law, row.iterations,
                row.difference);
  std::printf("bounds: laws %.0e, warm against cold %.0e\n", law_bound, warm_bound);
}

TEST(stability_long, named_scenes_keep_the_laws) {
  expect_laws_kept(0);
}
TEST(stability_nightly, named_scenes_keep_the_laws) {
  expect_laws_kept(1);
}

TEST(stability_long, units_change_neither_answers_nor_iterations) {
  constexpr double bound = 1e-9;
  std::map<std::string, Ending> first;
  double worst = 0;
  for (const Scene& scene : extremes::named_scenes()) {
    if (scene.group != "units") continue;
    const auto pair = extremes::make_pair(scene);
    extremes::give_scene(*pair, scene);
    Ending e = extremes::solve(*pair, scene);
    ASSERT_EQ(e.status, ROLLCON_OK) << scene.name;
    const std::string bodies = scene.name.substr(scene.name.rfind(',') + 1);
    const auto [place, fresh] = first.try_emplace(bodies, e);
    if (fresh) continue;
    const Ending& reference = place->second;
    EXPECT_EQ(e.iterations, reference.iterations) << scene.name;
    // Another unit of pressure is a factor on all tractions.
    double a = 0, b = 0;
    for (std::size_t k = 2; k < e.traction.size(); k += 3)
      a = std::max(a, -reference.traction[k]), b = std::max(b, -e.traction[k]);
    for (double& t : e.traction) t *= a / b;
    const double difference = extremes::traction_difference(e.traction, reference.traction);
    EXPECT_LE(difference, bound) << scene.name;
    worst = std::max(worst, difference);
  }
  EXPECT_EQ(first.size(), 3u);
  std::printf("units: tractions differ by %.1e (bound %.0e), same iterations\n", worst, bound);
}

TEST(stability, stiffer_and_stiffer_bodies_approach_the_rigid_one) {
  // Tractions on body 1 against ever stiffer bodies tend to those on a rigid one.
  std::vector<double> difference;
  std::vector<std::vector<double>> traction;
  for (int k = 0; k <= 13; ++k) {
    Scene scene = extremes::named_scenes().front();
    const scenes::Elastic soft{.shear = 1e4 / 2.6, .poisson = 0.3};
    scene.body1 = scenes::HalfspaceBody{soft};
    scene.body2 = scenes::HalfspaceBody{{.shear = soft.shear * std::pow(10, k), .poisson = 0.2}};
    if (k == 13) scene.body2 = scenes::RigidBody{};
    const auto pair = extremes::make_pair(scene);
    extremes::give_scene(*pair, scene);
    const Ending e = extremes::solve(*pair, scene);
    ASSERT_EQ(e.status, ROLLCON_OK) << k;
    EXPECT_LE(e.law.worst(), law_bound) << k;
    traction.push_back(e.traction);
  }
  for (int k = 0; k < 13; ++k)
    difference.push_back(extremes::traction_difference(traction[static_cast<std::size_t>(k)], traction.back()));
  constexpr double rounding = 1e-9;
  for (std::size_t k = 1; k < difference.size(); ++k) {
    EXPECT_LT(difference[k], std::max(0.2 * difference[k - 1], rounding)) << "E2/E1 = 1e" << k;
    std::printf("E2/E1 = 1e%zu: tractions differ from those on a rigid body by %.1e\n", k, difference[k]);
  }
}

}  // namespace
}  // namespace rollcon
