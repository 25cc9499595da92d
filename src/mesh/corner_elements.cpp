#include "mesh/corner_elements.hpp"

#include <utility>

#include "support/index.hpp"

namespace rollcon {

SurfaceMesh corner_elements(SurfaceMesh mesh) {
  std::vector<std::int32_t> corner;
  std::vector<std::int64_t> offset{0};
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const auto nodes = mesh.element(e);
    ElementType& type = mesh.type[at(e)];
    corner.insert(corner.end(), nodes.begin(), nodes.begin() + corner_count(type));
    offset.push_back(static_cast<std::int64_t>(corner.size()));
    type = linear_type(type);
  }
  mesh.connectivity = std::move(corner);
  mesh.offset = std::move(offset);
  return mesh;
}

}  // namespace rollcon
