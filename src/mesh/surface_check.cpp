#include "mesh/surface_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include "mesh/coinciding_nodes.hpp"
#include "mesh/mesh_errors.hpp"
#include "mesh/surface_shells.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

/// Smallest Jacobian within an element over its mean: does not see how slender
/// the element is.
constexpr double smallest_jacobian = 1e-6;

enum class Defect { none, vanishing, turning };

/// Judges the check point with the smallest component of the surface Jacobian along
/// the mean normal. noise: rounding of the coordinates over the element's size.
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
  Tally vanishing, turning;
  const auto look = [&](const ShapeToCheck& shape) {
    std::size_t worst = 0;
    const Defect defect = jacobian_defect(shape.node, shape.size, shape.points, shape.noise, worst);
    if (defect == Defect::none) return;
    const CheckPoint& there = shape.points[worst];
    char place[64];
    if (there.node >= 0)
      std::snprintf(place, sizeof place, "at node %lld", names.node(mesh.element(shape.element)[at(there.node)]));
    else
      std::snprintf(place, sizeof place, "at xi = %g, eta = %g", there.at.xi, there.at.eta);
    (defect == Defect::vanishing ? vanishing : turning)
        .add("element %lld (%s) %s", names.element(shape.element), names.type(shape.element), place);
  };
  std::vector<double> nearest = look_at_shapes(
      names, [&](std::size_t k) { return mesh.node[k]; }, look);
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
  check_outward(mesh, find_shells(mesh, sides));
}

}  // namespace rollcon
