#include "mesh/surface_crossing.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "mesh/box.hpp"
#include "mesh/mesh_errors.hpp"
#include "mesh/topology.hpp"

namespace rollcon {
namespace {

bool meet(const Box& a, const Box& b) {
  for (std::size_t c = 0; c < 3; ++c)
    if (a.low[c] > b.high[c] || b.low[c] > a.high[c]) return false;
  return true;
}

/// A triangle or quadrilateral with straight edges, and how far the element may be from it.
struct Facet {
  std::span<const std::int32_t> node;
  std::int64_t element;
  Box box;
  double slack;
};

// Where an edge from a to b runs through a triangle: both ends lie off its plane by more than the slack, on different
// sides.
bool pierces(const Vec3& a, const Vec3& b, const Vec3& p, const Vec3& q, const Vec3& r, double slack) {
  const Vec3 normal = cross(q - p, r - p);
  const double size = length(normal);
  if (!(size > 0)) return false;
  const double from = dot(normal, a - p) / size, to = dot(normal, b - p) / size;
  if (!(std::min(from, to) < -slack && std::max(from, to) > slack)) return false;
  const Vec3 x = a + (from / (from - to)) * (b - a);
  const Vec3 corner[3] = {p, q, r};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 side = corner[(i + 1) % 3] - corner[i];
    if (dot(normal, cross(side, x - corner[i])) < 0) return false;
  }
  return true;
}

bool edges_pierce(const SurfaceMesh& mesh, const Facet& from, const Facet& through, double slack) {
  const auto at = [&](std::int32_t k) { return mesh.node[static_cast<std::size_t>(k)]; };
  const auto& n = through.node;
  for (std::size_t i = 0; i < from.node.size(); ++i) {
    const Vec3 a = at(from.node[i]), b = at(from.node[(i + 1) % from.node.size()]);
    for (std::size_t k = 2; k < n.size(); ++k)
      if (pierces(a, b, at(n[0]), at(n[k - 1]), at(n[k]), slack)) return true;
  }
  return false;
}

bool share_node(std::span<const std::int32_t> a, std::span<const std::int32_t> b) {
  return std::any_of(a.begin(), a.end(), [&](std::int32_t k) { return std::find(b.begin(), b.end(), k) != b.end(); });
}

// Quadratic parts stray from straight ones by a quarter of the sagitta of their edges at most; quadrilaterals by the
// height of their fourth corner.
double stray(const SurfaceMesh& mesh, std::span<const std::int32_t> facet, std::int64_t element) {
  constexpr double rounding = 1e-6;
  const auto at = [&](std::int32_t k) { return mesh.node[static_cast<std::size_t>(k)]; };
  const ElementType type = mesh.type[static_cast<std::size_t>(element)];
  const auto nodes = mesh.element(element);
  const auto corners = static_cast<std::size_t>(corner_count(type));
  double slack = rounding * length(at(facet[1]) - at(facet[0]));
  if (facet.size() == 4) {
    const Vec3 normal = cross(at(facet[1]) - at(facet[0]), at(facet[2]) - at(facet[0]));
    if (const double size = length(normal); size > 0)
      slack += std::abs(dot(normal, at(facet[3]) - at(facet[0]))) / size;
  }
  for (std::size_t i = 0; is_quadratic(type) && i < corners; ++i) {
    const Vec3 middle = 0.5 * (at(nodes[i]) + at(nodes[(i + 1) % corners]));
    slack = std::max(slack, length(at(nodes[corners + i]) - middle));
  }
  return slack;
}

}  // namespace

void check_crossing(const SurfaceMesh& mesh) {
  const LinearCells cells = split_elements(mesh);
  std::vector<Facet> facet;
  Box all;
  for (std::int64_t c = 0; c < cells.size(); ++c) {
    const auto node = cells[c];
    const std::int64_t element = cells.element[static_cast<std::size_t>(c)];
    facet.push_back({node, element, box_of(mesh.node, node), stray(mesh, node, element)});
    all.add(facet.back().box);
  }
  // Along the longest side only neighbours in that direction can meet.
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (all.size()[i] > all.size()[axis]) axis = i;
  std::sort(facet.begin(), facet.end(),
            [&](const Facet& a, const Facet& b) { return a.box.low[axis] < b.box.low[axis]; });
  Tally crossing;
  const auto base = static_cast<long long>(mesh.index_base);
  for (std::size_t i = 0; i < facet.size(); ++i)
    for (std::size_t j = i + 1; j < facet.size() && facet[j].box.low[axis] <= facet[i].box.high[axis]; ++j) {
      const Facet &a = facet[i], &b = facet[j];
      if (a.element == b.element || !meet(a.box, b.box)) continue;
      if (share_node(mesh.element(a.element), mesh.element(b.element))) continue;
      const double slack = a.slack + b.slack;
      if (edges_pierce(mesh, a, b, slack) || edges_pierce(mesh, b, a, slack))
        crossing.add("elements %lld and %lld", std::min(a.element, b.element) + base,
                     std::max(a.element, b.element) + base);
    }
  crossing.fail_if_any("the surface runs through itself: elements without a common node cross", "surface",
                       mesh.index_base);
}

}  // namespace rollcon
