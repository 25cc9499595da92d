#include "mesh/surface_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <vector>

#include "mesh/coinciding_nodes.hpp"
#include "mesh/mesh_errors.hpp"
#include "mesh/surface_shells.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

/// Both the smallest height of an element and the smallest distance of two nodes, over the element's length, must
/// exceed this.
constexpr double smallest_ratio = 1e-10;
/// The smallest Jacobian within an element over its mean must exceed this; it does not see how slender the element is.
constexpr double smallest_jacobian = 1e-6;
constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();

enum class Defect { none, vanishing, turning };

/// Judges the check point with the smallest component of the surface Jacobian along the mean normal; `noise` is the
/// rounding of the coordinates over the element's size.
Defect jacobian_defect(std::span<const Vec3> node, double size, const std::vector<CheckPoint>& points, double noise,
                       std::size_t& worst) {
  std::vector<Vec3> normal(points.size());
  Vec3 mean{0, 0, 0};
  double largest = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    Vec3 u{0, 0, 0}, v{0, 0, 0};
    for (std::size_t i = 1; i < node.size(); ++i) {
      const Vec3 x = (1 / size) * (node[i] - node[0]);
      u = u + points[p].shape.d_xi[i] * x;
      v = v + points[p].shape.d_eta[i] * x;
    }
    normal[p] = cross(u, v);
    mean = mean + (1 / static_cast<double>(points.size())) * normal[p];
    largest = std::max(largest, length(normal[p]));
  }
  worst = 0;
  if (largest <= std::max(smallest_ratio, noise)) return Defect::vanishing;
  const double scale = length(mean);
  if (scale <= smallest_jacobian * largest) return Defect::turning;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < points.size(); ++p)
    if (const double c = dot(normal[p], mean) / (scale * scale); c < smallest) smallest = c, worst = p;
  if (smallest > std::max(smallest_jacobian, noise / scale)) return Defect::none;
  return length(normal[worst]) <= smallest_jacobian * scale ? Defect::vanishing : Defect::turning;
}

/// Returns for each node the distance to the nearest other node of its elements.
std::vector<double> check_shapes(const Names<SurfaceMesh>& names) {
  const SurfaceMesh& mesh = names.mesh;
  std::vector<double> nearest(mesh.node.size(), std::numeric_limits<double>::infinity());
  std::map<ElementType, std::vector<CheckPoint>> points;
  Tally coincident, vanishing, turning;
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const ElementType type = mesh.type[at(e)];
    const auto nodes = mesh.element(e);
    std::array<Vec3, max_element_nodes> all;
    for (std::size_t i = 0; i < nodes.size(); ++i) all[i] = mesh.node[at(nodes[i])];
    const std::span<const Vec3> point(all.data(), nodes.size());
    const NodeExtent extent = measure_nodes(point);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      nearest[at(nodes[i])] = std::min(nearest[at(nodes[i])], extent.own[i]);
    // Coordinates carry the rounding of their magnitude: what is below it cannot be told from zero.
    const double noise = rounding * extent.magnitude / extent.size;
    if (!(extent.nearest > std::max(smallest_ratio, noise) * extent.size)) {
      coincident.add("element %lld (%s), nodes %lld and %lld", names.element(e), name(type),
                     names.node(nodes[extent.near_i]), names.node(nodes[extent.near_j]));
      continue;
    }
    auto& looked_at = points[type];
    if (looked_at.empty()) looked_at = check_points(type);
    std::size_t worst = 0;
    const Defect defect = jacobian_defect(point, extent.size, looked_at, noise, worst);
    if (defect == Defect::none) continue;
    const CheckPoint& there = looked_at[worst];
    char place[64];
    if (there.node >= 0)
      std::snprintf(place, sizeof place, "at node %lld", names.node(nodes[at(there.node)]));
    else
      std::snprintf(place, sizeof place, "at xi = %g, eta = %g", there.at.xi, there.at.eta);
    (defect == Defect::vanishing ? vanishing : turning)
        .add("element %lld (%s) %s", names.element(e), name(type), place);
  }
  names.refuse(coincident, "degenerate element: two of its nodes coincide");
  names.refuse(vanishing,
               "degenerate element: its Jacobian vanishes (no area, "
               "a corner of 180 degrees, or a "
               "midside node at a quarter of its edge)");
  names.refuse(turning,
               "degenerate element: its normal turns over within it "
               "(folded, concave, or with a "
               "midside node beyond the quarter of its edge)");
  return nearest;
}

/// Names nodes in its message, because numbers of faces mean nothing to the caller.
void check_boundary_edges(const SurfaceMesh& mesh) {
  const auto base = static_cast<long long>(mesh.index_base);
  Tally crowded;
  for_each_edge(sorted_sides(corner_cells(mesh)), [&](const Side& s, std::size_t count) {
    if (count > 2)
      crowded.add("nodes %lld and %lld, with %lld faces", s.low() + base, s.high() + base,
                  static_cast<long long>(count));
  });
  crowded.fail_if_any(
      "the body touches itself along an edge: more than two of "
      "its boundary faces meet there; join "
      "its parts by a common face or give each its own nodes",
      "volume", mesh.index_base);
}

}  // namespace

void check_surface(const SurfaceMesh& mesh, SurfaceKind kind) {
  if (mesh.elements() == 0) fail(Status::err_mesh, "the surface has no elements");
  if (kind == SurfaceKind::boundary) return check_boundary_edges(mesh);
  const Names<SurfaceMesh> names{mesh, mesh.index_base, "surface"};
  check_connectivity(names, mesh.nodes());
  check_nodes_used(names, mesh.nodes());
  check_coinciding_nodes(mesh.node, check_shapes(names), mesh.index_base, "surface");

  const std::vector<Side> sides = sorted_sides(corner_cells(mesh));
  check_edges(mesh, sides);
  if (kind == SurfaceKind::open) return check_neighbours(mesh, find_shells(mesh, sides));
  check_closed(mesh, sides);
  check_fans(mesh, sides);
  check_outward(mesh, find_shells(mesh, sides));
}

}  // namespace rollcon
