// Makes scenes of the stability suite with bodies that have meshes.

#include <array>

#include "stability.hpp"
#include "support/extreme_bodies.hpp"

namespace rollcon::bench {

namespace {

bool has_bodies() {
  return rollcon_has_feature("fem") == 1 && rollcon_has_feature("bem") == 1;
}

}  // namespace

std::vector<extremes::Scene> stability_body_scenes(bool quick) {
  if (!has_bodies()) return {};
  std::vector<extremes::Scene> all = extremes::named_body_scenes();
  if (quick) return all;
  // The largest block is solved once.
  extremes::BlockShape large;
  large.n = {24, 24, 15};
  all.push_back(extremes::scene_on_block("meshes", "finite elements, 10000 nodes", large, scenes::RigidBody{}));
  extremes::ConformalShape bore;
  for (const extremes::Model model : {extremes::Model::fem, extremes::Model::bem}) {
    bore.model = model;
    bore.n = model == extremes::Model::fem ? std::array{18, 48, 6} : std::array{12, 32, 4};
    bore.half_angle = 61;
    all.push_back(extremes::scene_in_bore("to 60 degrees, fine", bore, 3e-3, 59));
    all.back().right.push_back(ROLLCON_RIM_CONTACT);  // its faces end at 61 degrees
  }
  large.model = extremes::Model::bem;
  large.n = {18, 18, 12};
  all.push_back(extremes::scene_on_block("meshes", "boundary elements, 1500 nodes", large, scenes::RigidBody{}));
  return all;
}

extremes::Scene stability_random_body_scene(std::uint32_t seed) {
  return extremes::random_body_scene(seed);
}

std::uint32_t stability_random_body_count(std::uint32_t scenes) {
  return has_bodies() ? scenes * 3 / 20 : 0;
}

}  // namespace rollcon::bench
