#include "mesh/turned_over.hpp"

#include <algorithm>
#include <array>

#include "support/index.hpp"

namespace rollcon {

void turn_over(SurfaceMesh& mesh) {
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const auto nodes = mesh.element(e);
    std::array<std::int32_t, max_element_nodes> before{};
    std::copy(nodes.begin(), nodes.end(), before.begin());
    std::int32_t* node = mesh.connectivity.data() + mesh.offset[at(e)];
    for (int k = 0; k < node_count(mesh.type[at(e)]); ++k) node[k] = before[at(turned_over(mesh.type[at(e)], k))];
  }
}

}  // namespace rollcon
