#include "mesh/traction_nodes.hpp"

#include <numbers>
#include <numeric>

#include "mesh/node_fans.hpp"
#include "mesh/surface_geometry.hpp"

namespace rollcon {
namespace {

Vec3 normal_at_middle(const SurfaceMesh& mesh, const Side& side) {
  const ElementType type = mesh.type[static_cast<std::size_t>(side.cell)];
  const ReferencePoint at = side_middle(type, side_number(mesh, side));
  return unit_normal(mesh, side.cell, at.xi, at.eta);
}

void join_across_edges(const SurfaceMesh& mesh, double edge_angle, NodeFans& fans) {
  const double largest = (edge_angle + 1e-6) * std::numbers::pi / 180;
  const std::vector<Side> sides = sorted_sides(corner_cells(mesh));
  for_each_edge(sides, [&](const Side& a, std::size_t count) {
    if (count != 2) return;
    const Side& b = *(&a + 1);
    if (mesh.tag[static_cast<std::size_t>(a.cell)] != mesh.tag[static_cast<std::size_t>(b.cell)]) return;
    if (angle_between(normal_at_middle(mesh, a), normal_at_middle(mesh, b)) > largest) return;
    fans.join_across(a, b);
  });
}

}  // namespace

TractionNodes split_at_edges(const SurfaceMesh& mesh, double edge_angle) {
  NodeFans fans(mesh);
  join_across_edges(mesh, edge_angle, fans);

  const std::size_t entries = mesh.connectivity.size();
  TractionNodes result;
  result.start.assign(mesh.node.size() + 1, 0);
  for (std::size_t i = 0; i < entries; ++i)
    if (fans.first(i) == i) ++result.start[static_cast<std::size_t>(mesh.connectivity[i]) + 1];
  std::partial_sum(result.start.begin(), result.start.end(), result.start.begin());

  const auto size = static_cast<std::size_t>(result.start.back());
  result.of.resize(entries);
  result.node.resize(size);
  result.normal.assign(size, Vec3{0, 0, 0});
  std::vector<std::int64_t> next(result.start.begin(), result.start.end() - 1);
  for (std::size_t i = 0; i < entries; ++i) {
    const std::size_t first = fans.first(i);
    const auto node = static_cast<std::size_t>(mesh.connectivity[i]);
    if (first == i) {
      result.of[i] = static_cast<std::int32_t>(next[node]++);
      result.node[static_cast<std::size_t>(result.of[i])] = mesh.connectivity[i];
    }
    result.of[i] = result.of[first];
  }

  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const ElementType type = mesh.type[static_cast<std::size_t>(e)];
    const auto at = reference_nodes(type);
    for (std::size_t i = 0; i < at.size(); ++i) {
      const auto entry = static_cast<std::size_t>(mesh.offset[static_cast<std::size_t>(e)]) + i;
      Vec3& sum = result.normal[static_cast<std::size_t>(result.of[entry])];
      sum = sum + angle_at_node(mesh, e, static_cast<int>(i)) * unit_normal(mesh, e, at[i].xi, at[i].eta);
    }
  }
  for (Vec3& n : result.normal) n = normalized(n);
  return result;
}

}  // namespace rollcon
