// Scenes of the other families under laws of friction other than Coulomb's.

#include <algorithm>
#include <cmath>
#include <string>

#include "support/extremes.hpp"
#include "support/extremes_base.hpp"
#include "support/extremes_draw.hpp"

namespace rollcon::extremes {
namespace {

void draw_orthotropic(Draw& d, Scene& scene, double mu) {
  const double other = d.chance(0.1) ? mu : mu * d.log_between(0.02, 1);
  scene.given.law.parameter = {mu, other, d.between(-3.2, 3.2)};
  if (d.chance(0.5)) std::swap(scene.given.law.parameter[0], scene.given.law.parameter[1]);
}

}  // namespace

Scene law_scene(const std::string& law, std::uint32_t seed) {
  Draw d(seed + 0x2545f49U);
  Scene scene = d.chance(0.3) ? forces_scene(seed) : random_scene(seed);
  laws::Given& g = scene.given;
  const double mu = *std::max_element(g.friction.begin(), g.friction.end());
  g.law.name = law;
  draw_orthotropic(d, scene, mu);
  scene.group = law + ": " + scene.group;
  return scene;
}

}  // namespace rollcon::extremes
