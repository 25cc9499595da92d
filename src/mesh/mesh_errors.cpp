#include "mesh/mesh_errors.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "support/index.hpp"

namespace rollcon {

const char* name(ElementType type) {
  static constexpr std::pair<ElementType, const char*> names[] = {{ElementType::tri3, "tri3"},
                                                                  {ElementType::tri6, "tri6"},
                                                                  {ElementType::quad4, "quad4"},
                                                                  {ElementType::quad8, "quad8"},
                                                                  {ElementType::quad9, "quad9"}};
  for (const auto& [known, text] : names)
    if (known == type) return text;
  return "?";
}

const char* name(VolumeType type) {
  static constexpr std::pair<VolumeType, const char*> names[] = {
      {VolumeType::tet4, "tet4"},       {VolumeType::tet10, "tet10"}, {VolumeType::wedge6, "wedge6"},
      {VolumeType::wedge15, "wedge15"}, {VolumeType::hex8, "hex8"},   {VolumeType::hex20, "hex20"}};
  for (const auto& [known, text] : names)
    if (known == type) return text;
  return "?";
}

template <class Elements>
void check_connectivity(const Names<Elements>& names, std::int64_t count) {
  Tally range, repeated, twice;
  std::vector<std::pair<std::array<std::int32_t, 8>, std::int64_t>> corners;
  corners.reserve(names.mesh.type.size());
  for (std::int64_t e = 0; e < names.mesh.elements(); ++e) {
    const auto nodes = names.mesh.element(e);
    const auto out = std::find_if(nodes.begin(), nodes.end(), [&](std::int32_t k) { return k < 0 || k >= count; });
    if (out != nodes.end())
      range.add("element %lld (%s), node %lld of %d..%lld", names.element(e), names.type(e), names.node(*out),
                names.base, names.node(count - 1));
    for (auto k = nodes.begin(); k != nodes.end(); ++k)
      if (std::find(nodes.begin(), k, *k) != k) {
        repeated.add("element %lld (%s), node %lld", names.element(e), names.type(e), names.node(*k));
        break;
      }
    // Equal corners make equal elements, whatever their order of interpolation.
    std::array<std::int32_t, 8> corner;
    corner.fill(-1);
    std::copy_n(nodes.begin(), corner_count(names.mesh.type[at(e)]), corner.begin());
    std::sort(corner.begin(), corner.end());
    corners.emplace_back(corner, e);
  }
  std::sort(corners.begin(), corners.end());
  for (std::size_t i = 1; i < corners.size(); ++i)
    if (corners[i - 1].first == corners[i].first)
      twice.add("elements %lld and %lld", names.element(corners[i - 1].second), names.element(corners[i].second));
  names.refuse(range, "an element refers to a node that does not exist");
  names.refuse(repeated, "a node is repeated within an element");
  names.refuse(twice, "the same element is given twice");
}

template void check_connectivity(const Names<SurfaceMesh>&, std::int64_t);
template void check_connectivity(const Names<VolumeElements>&, std::int64_t);

NodeExtent measure_nodes(std::span<const Vec3> point) {
  NodeExtent extent;
  extent.own.fill(extent.nearest);
  for (std::size_t i = 0; i < point.size(); ++i) {
    for (const double c : point[i]) extent.magnitude = std::max(extent.magnitude, std::abs(c));
    for (std::size_t j = 0; j < i; ++j) {
      const double d = length(point[i] - point[j]);
      extent.size = std::max(extent.size, d);
      extent.own[i] = std::min(extent.own[i], d);
      extent.own[j] = std::min(extent.own[j], d);
      if (d < extent.nearest) extent.nearest = d, extent.near_i = j, extent.near_j = i;
    }
  }
  return extent;
}

std::vector<CheckPoint> check_points(ElementType type) {
  const bool triangle = corner_count(type) == 3;
  const int steps = is_quadratic(type) ? 8 : 1;
  const auto nodes = reference_nodes(type);
  std::vector<CheckPoint> points;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= (triangle ? steps - i : steps); ++j) {
      CheckPoint p;
      const double u = static_cast<double>(i) / steps, v = static_cast<double>(j) / steps;
      p.at = triangle ? ReferencePoint{u, v} : ReferencePoint{2 * u - 1, 2 * v - 1};
      for (std::size_t k = 0; k < nodes.size(); ++k)
        if (nodes[k].xi == p.at.xi && nodes[k].eta == p.at.eta) p.node = static_cast<int>(k);
      evaluate_shape(type, p.at.xi, p.at.eta, p.shape);
      points.push_back(p);
    }
  return points;
}

}  // namespace rollcon
