#include "mesh/mesh_errors.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace rollcon {

const char* name(ElementType type) {
  switch (type) {
    case ElementType::tri3:
      return "tri3";
    case ElementType::tri6:
      return "tri6";
    case ElementType::quad4:
      return "quad4";
    case ElementType::quad8:
      return "quad8";
    case ElementType::quad9:
      return "quad9";
  }
  return "?";
}

const char* name(VolumeType type) {
  switch (type) {
    case VolumeType::tet4:
      return "tet4";
    case VolumeType::tet10:
      return "tet10";
    case VolumeType::wedge6:
      return "wedge6";
    case VolumeType::wedge15:
      return "wedge15";
    case VolumeType::hex8:
      return "hex8";
    case VolumeType::hex20:
      return "hex20";
  }
  return "?";
}

void check_connectivity(const SurfaceMesh& mesh, const char* where) {
  const int base = mesh.index_base;
  Tally range, repeated, twice;
  std::vector<std::pair<std::array<std::int32_t, 4>, std::int64_t>> corners;
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const auto nodes = mesh.element(e);
    const ElementType type = mesh.type[static_cast<std::size_t>(e)];
    const auto id = static_cast<long long>(e + base);
    for (std::int32_t k : nodes)
      if (k < 0 || k >= mesh.nodes()) {
        range.add("element %lld (%s), node %lld of %d..%lld", id, name(type),
                  static_cast<long long>(k) + base, base,
                  static_cast<long long>(mesh.nodes() - 1 + base));
        break;
      }
    for (std::size_t i = 1; i < nodes.size(); ++i)
      if (std::find(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(i), nodes[i]) !=
          nodes.begin() + static_cast<std::ptrdiff_t>(i)) {
        repeated.add("element %lld (%s), node %lld", id, name(type),
                     static_cast<long long>(nodes[i]) + base);
        break;
      }
    // The same corners are the same element, whatever its order of interpolation.
    std::array<std::int32_t, 4> corner{-1, -1, -1, -1};
    std::copy_n(nodes.begin(), corner_count(type), corner.begin());
    std::sort(corner.begin(), corner.end());
    corners.emplace_back(corner, e);
  }
  std::sort(corners.begin(), corners.end());
  for (std::size_t i = 1; i < corners.size(); ++i)
    if (corners[i - 1].first == corners[i].first)
      twice.add("elements %lld and %lld", static_cast<long long>(corners[i - 1].second + base),
                static_cast<long long>(corners[i].second + base));
  range.fail_if_any("an element refers to a node that does not exist", where, base);
  repeated.fail_if_any("a node is repeated within an element", where, base);
  twice.fail_if_any("the same element is given twice", where, base);
}

}  // namespace rollcon
