#include "mesh/traction_nodes.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "mesh/element_sides.hpp"
#include "mesh/surface_geometry.hpp"

namespace rollcon {
namespace {

/// Sets of entries of the connectivity: each starts alone, entries of one node are joined.
class NodeFans {
 public:
  explicit NodeFans(const SurfaceMesh& mesh) : mesh_(mesh), parent_(mesh.connectivity.size()) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  /// Joins the two elements of an edge at its nodes.
  void join_across(const Side& a, const Side& b) {
    join(a.cell, b.cell, a.from);
    join(a.cell, b.cell, a.to);
    if (const std::int32_t mid = midside_node(mesh_, a); mid >= 0) join(a.cell, b.cell, mid);
  }

  /// First entry of the fan that entry i belongs to.
  std::size_t first(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

 private:
  std::size_t entry(std::int64_t e, std::int32_t node) const {
    const auto nodes = mesh_.element(e);
    return static_cast<std::size_t>(mesh_.offset[static_cast<std::size_t>(e)] +
                                    (std::find(nodes.begin(), nodes.end(), node) - nodes.begin()));
  }
  void join(std::int64_t a, std::int64_t b, std::int32_t node) {
    const std::size_t i = first(entry(a, node)), j = first(entry(b, node));
    parent_[std::max(i, j)] = std::min(i, j);
  }

  const SurfaceMesh& mesh_;
  std::vector<std::size_t> parent_;
};

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
