#include "bodies/body_mesh.hpp"

#include <set>

namespace rollcon {

std::vector<std::uint8_t> held_elements(const BodyMesh& mesh) {
  std::vector<std::uint8_t> held(static_cast<std::size_t>(mesh.surface.elements()), 7);
  for (std::size_t e = 0; e < held.size(); ++e)
    for (const std::int32_t k : mesh.surface.element(static_cast<std::int64_t>(e)))
      held[e] &= mesh.held[static_cast<std::size_t>(k)];
  return held;
}

std::vector<std::int64_t> contact_elements(const BodyMesh& mesh) {
  constexpr std::uint8_t all_components = 7;
  const std::set<std::int32_t> wanted(mesh.contact_tag.begin(), mesh.contact_tag.end());
  std::set<std::int32_t> loaded;
  for (const FaceLoad& load : mesh.load) loaded.insert(load.tag);
  const std::vector<std::uint8_t> held = held_elements(mesh);
  std::vector<std::int64_t> element;
  for (std::size_t e = 0; e < held.size(); ++e) {
    const std::int32_t tag = mesh.surface.tag[e];
    const bool chosen = wanted.empty() ? held[e] != all_components && loaded.count(tag) == 0
                                       : wanted.count(tag) != 0;
    if (chosen) element.push_back(static_cast<std::int64_t>(e));
  }
  return element;
}

}  // namespace rollcon
