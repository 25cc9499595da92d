#include "mesh/turned_over.hpp"

#include <array>

namespace rollcon {

std::span<const int> turned_over(ElementType type) {
  static constexpr int tri3[] = {0, 2, 1}, tri6[] = {0, 2, 1, 5, 4, 3}, quad4[] = {0, 3, 2, 1},
                       quad8[] = {0, 3, 2, 1, 7, 6, 5, 4}, quad9[] = {0, 3, 2, 1, 7, 6, 5, 4, 8};
  switch (type) {
    case ElementType::tri3:
      return tri3;
    case ElementType::tri6:
      return tri6;
    case ElementType::quad4:
      return quad4;
    case ElementType::quad8:
      return quad8;
    case ElementType::quad9:
      return quad9;
  }
  return {};
}

void turn_over(SurfaceMesh& mesh) {
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const auto i = static_cast<std::size_t>(e);
    const std::span<const int> order = turned_over(mesh.type[i]);
    std::int32_t* node = mesh.connectivity.data() + mesh.offset[i];
    std::array<std::int32_t, max_element_nodes> before{};
    for (std::size_t k = 0; k < order.size(); ++k) before[k] = node[k];
    for (std::size_t k = 0; k < order.size(); ++k)
      node[k] = before[static_cast<std::size_t>(order[k])];
  }
}

}  // namespace rollcon
