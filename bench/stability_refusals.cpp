// Collects what the library says when it is asked for what it cannot do.

#include <exception>
#include <functional>
#include <utility>

#include "stability.hpp"
#include "support/extremes_base.hpp"

namespace rollcon::bench {
namespace {

using extremes::Scene;

struct Impossible {
  const char* limit;
  std::function<Scene()> scene;
};

Scene of_poisson(double poisson) {
  Scene scene = extremes::base("", "");
  scene.body1 = scenes::HalfspaceBody{extremes::elastic(1e4, poisson)};
  return scene;
}

/// Moves one node of a regular frame.
Scene with_node_moved(ElementType type, std::size_t node, double dx, double dy) {
  Scene scene = extremes::base("", "");
  const auto lines = frames::uniform_lines(-1.3, 1.3, 4);
  SurfaceMesh mesh = frames::rectangle(type, lines, lines);
  mesh.node[node][0] += dx;
  mesh.node[node][1] += dy;
  set_frame(scene, mesh);
  return scene;
}

std::vector<Impossible> impossible() {
  return {
      {"Poisson's ratio above 0.5", [] { return of_poisson(0.51); }},
      {"Poisson's ratio below -1", [] { return of_poisson(-1.2); }},
      {"negative friction", [] { return extremes::base("", "").friction(-0.1); }},
      {"two rigid bodies",
       [] {
         Scene scene = extremes::base("", "");
         scene.body1 = scenes::RigidBody{};
         return scene;
       }},
      {"a negative load", [] { return extremes::base("", "").load(-1); }},
      {"creepage that is not finite", [] { return extremes::base("", "").creep(NAN, 0, 0); }},
      {"a tangential force without friction",
       [] { return extremes::base("", "").friction(0).force(ROLLCON_LONGITUDINAL, 1); }},
      {"a tangential force beyond friction",
       [] {
         Scene scene = extremes::base("", "");
         return scene.load(base_load(scene)).force(ROLLCON_LATERAL, 0.3 * base_load(scene));
       }},
      {"a spin moment beyond friction",
       [] {
         Scene scene = extremes::base("", "");
         return scene.load(base_load(scene)).force(ROLLCON_SPIN, 0.3 * base_load(scene));
       }},
      {"a force and a spin moment beyond friction together",
       [] {
         Scene scene = extremes::base("", "");
         const double most = 0.3 * base_load(scene);
         return scene.load(base_load(scene)).force(ROLLCON_LONGITUDINAL, 0.8 * most).force(ROLLCON_SPIN, 0.5 * most);
       }},
      {"an element folded over", [] { return with_node_moved(ElementType::quad4, 12, 0.9, 0.9); }},
      {"a midside node too far off", [] { return with_node_moved(ElementType::quad8, 29, 0.3, 0.3); }},
      {"two nodes in one place", [] { return with_node_moved(ElementType::tri3, 12, 0.65, 0); }},
  };
}

}  // namespace

std::vector<std::pair<std::string, std::string>> stability_refusals() {
  std::vector<std::pair<std::string, std::string>> said;
  for (const Impossible& what : impossible()) {
    std::string text;
    try {
      const Scene scene = what.scene();
      const auto pair = extremes::make_pair(scene);
      extremes::give_scene(*pair, scene);
      const std::int32_t status = pair->solve();
      text = std::string("(solved) ") + rollcon_status_string(status);
    } catch (const std::exception& error) {
      text = error.what();
    }
    said.emplace_back(what.limit, text);
  }
  return said;
}

}  // namespace rollcon::bench
