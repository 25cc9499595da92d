// Makes scenes of the other families under laws of friction other than Coulomb's.

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

// Draws speeds from where the least slip feels the fall to where hardly any does. Steeper ones have many solutions.
void draw_falling(Draw& d, Scene& scene, double mu) {
  const laws::Given& g = scene.given;
  double creep =
      std::max({std::abs(g.by_force[0] ? 0 : g.value[0]), std::abs(g.by_force[1] ? 0 : g.value[1]), 0.1 * mu, 1e-9});
  const double kept = d.between(0.2, 0.95), first = d.between(0.3, 1);
  const auto speed = [&] { return g.speed * creep * d.log_between(0.5, 100); };
  scene.given.law.parameter = {kept * mu, (1 - kept) * first * mu, speed()};
  if (first < 0.9)
    scene.given.law.parameter.insert(scene.given.law.parameter.end(), {(1 - kept) * (1 - first) * mu, speed()});
  else
    scene.given.law.parameter[1] = (1 - kept) * mu;
}

}  // namespace

Scene law_scene(const std::string& law, std::uint32_t seed) {
  Draw d(seed + 0x2545f49U);
  Scene scene = d.chance(0.3) ? forces_scene(seed) : random_scene(seed);
  laws::Given& g = scene.given;
  const double mu = *std::max_element(g.friction.begin(), g.friction.end());
  g.law.name = law;
  g.law.orthotropic() ? draw_orthotropic(d, scene, mu) : draw_falling(d, scene, mu);
  scene.group = law + ": " + scene.group;
  return scene;
}

}  // namespace rollcon::extremes
