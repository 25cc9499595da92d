/// Tests that laws recomputed on a curved frame see what is wrong there: the scene is solved, then judged as if it were
/// another one.

#include "support/extreme_bodies.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using laws::Given;
using laws::Laws;

TEST(stability_bodies, laws_see_a_conformal_scene_that_is_another_one) {
  struct Defect {
    const char* name;
    double Laws::*law;
    std::function<void(Given&)> make;
  };
  const auto lean = [](Given& g) {  // by a thousandth, across the rolling direction
    for (auto& t : g.triad) {
      const Vec3 n = t[2];
      t[2] = {0, n[1] + 1e-3 * n[2], n[2] - 1e-3 * n[1]};
      t[1] = cross(t[2], t[0]);
    }
  };
  const Defect defects[] = {
      {"friction a thousandth less", &Laws::bound, [](Given& g) { g.friction[0] *= 0.999; }},
      {"wider gap", &Laws::separation,
       [](Given& g) {
         for (double& h : g.gap) h *= 1.001;
       }},
      {"normals that lean, gap", &Laws::separation, lean},
      {"normals that lean, loads", &Laws::equilibrium, lean},
      {"normals of the axes", &Laws::equilibrium, [](Given& g) { g.triad.clear(); }},
      {"more force", &Laws::equilibrium, [](Given& g) { g.value[0] *= 1.001; }},
      {"a hundredth more moment", &Laws::equilibrium, [](Given& g) { g.value[3] *= 1.01; }},
      {"another step", &Laws::stick, [](Given& g) { g.step *= 1.01; }},
      {"larger surface", &Laws::equilibrium,
       [](Given& g) {
         for (Vec3& x : g.frame.node) x[2] *= 1.001;
       }},
  };
  constexpr double kept = 1e-8, seen = 1e-5;
  extremes::Scene scene = extremes::scene_in_bore("", {.model = extremes::Model::fem}, 3e-3, 59);
  scene.load(100).force(ROLLCON_LONGITUDINAL, 15).force(ROLLCON_SPIN, 0.5);
  const auto pair = extremes::make_pair(scene);
  extremes::give_scene(*pair, scene);
  // The bore goes on beyond the frame.
  const std::int32_t status = pair->solve();
  ASSERT_TRUE(status == ROLLCON_OK || status == ROLLCON_RIM_CONTACT) << status;
  const Laws right = laws::check(pair->handle(), scene.given);
  EXPECT_LE(right.worst(), kept) << right.worst_name();
  EXPECT_GE(right.turn, scene.turn);
  for (const Defect& defect : defects) {
    Given other = scene.given;
    defect.make(other);
    const double error = laws::check(pair->handle(), other).*defect.law;
    std::printf("%s: %.1e (at least %.0e)\n", defect.name, error, seen);
    EXPECT_GE(error, seen) << defect.name;
  }
}

}  // namespace
}  // namespace rollcon
