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
#include "mesh/shape.hpp"
#include "mesh/surface_crossing.hpp"
#include "mesh/surface_shells.hpp"

namespace rollcon {
namespace {

/// Smallest height of an element over its length, and smallest distance of two nodes likewise.
constexpr double smallest_ratio = 1e-10;
/// Smallest Jacobian within an element over its mean: does not see how slender the element is.
constexpr double smallest_jacobian = 1e-6;
constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();

/// Points where the Jacobian is checked. A linear element's normal is linear in each variable, so
/// its corners decide; quadratic ones get a lattice with spacing 1/8 of the element.
struct CheckPoint {
  ReferencePoint at;
  int node = -1;  ///< local node that lies there
  Shape shape;
};

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

/// An element's nodes: how far apart, and how far from the origin.
struct Extent {
  std::array<Vec3, max_element_nodes> point;
  std::size_t n = 0;
  double size = 0, magnitude = 0;
  double nearest = std::numeric_limits<double>::infinity();
  std::size_t near_i = 0, near_j = 0;
};

Extent measure(const SurfaceMesh& mesh, std::int64_t e) {
  Extent x;
  for (std::int32_t k : mesh.element(e)) x.point[x.n++] = mesh.node[static_cast<std::size_t>(k)];
  for (std::size_t i = 0; i < x.n; ++i) {
    for (double c : x.point[i]) x.magnitude = std::max(x.magnitude, std::abs(c));
    for (std::size_t j = 0; j < i; ++j) {
      const double d = length(x.point[i] - x.point[j]);
      x.size = std::max(x.size, d);
      if (d < x.nearest) x.nearest = d, x.near_i = j, x.near_j = i;
    }
  }
  return x;
}

enum class Defect { none, vanishing, turning };

/// Of the check point with the smallest component of the surface Jacobian along the mean normal.
/// noise: rounding of the coordinates over the element's size.
Defect jacobian_defect(const Extent& extent, const std::vector<CheckPoint>& points, double noise,
                       std::size_t& worst) {
  std::vector<Vec3> normal(points.size());
  Vec3 mean{0, 0, 0};
  double largest = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    Vec3 u{0, 0, 0}, v{0, 0, 0};
    for (std::size_t i = 1; i < extent.n; ++i) {
      const Vec3 x = (1 / extent.size) * (extent.point[i] - extent.point[0]);
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
    if (const double c = dot(normal[p], mean) / (scale * scale); c < smallest)
      smallest = c, worst = p;
  if (smallest > std::max(smallest_jacobian, noise / scale)) return Defect::none;
  return length(normal[worst]) <= smallest_jacobian * scale ? Defect::vanishing : Defect::turning;
}

void check_nodes_used(const SurfaceMesh& mesh) {
  std::vector<char> used(mesh.node.size(), 0);
  for (std::int32_t k : mesh.connectivity) used[static_cast<std::size_t>(k)] = 1;
  Tally unused;
  for (std::size_t k = 0; k < used.size(); ++k)
    if (!used[k]) unused.add("node %lld", static_cast<long long>(k) + mesh.index_base);
  unused.fail_if_any("a node belongs to no element", "surface", mesh.index_base);
}

void check_shapes(const SurfaceMesh& mesh) {
  const auto base = static_cast<long long>(mesh.index_base);
  std::map<ElementType, std::vector<CheckPoint>> points;
  Tally coincident, vanishing, turning;
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const ElementType type = mesh.type[static_cast<std::size_t>(e)];
    const auto nodes = mesh.element(e);
    const auto id = static_cast<long long>(e) + base;
    const Extent extent = measure(mesh, e);
    // Coordinates carry the rounding of their magnitude: what is below it cannot be told from zero.
    const double noise = rounding * extent.magnitude / extent.size;
    if (!(extent.nearest > std::max(smallest_ratio, noise) * extent.size)) {
      coincident.add("element %lld (%s), nodes %lld and %lld", id, name(type),
                     nodes[extent.near_i] + base, nodes[extent.near_j] + base);
      continue;
    }
    auto& at = points[type];
    if (at.empty()) at = check_points(type);
    std::size_t worst = 0;
    const Defect defect = jacobian_defect(extent, at, noise, worst);
    if (defect == Defect::none) continue;
    char place[64];
    if (at[worst].node >= 0)
      std::snprintf(place, sizeof place, "at node %lld",
                    nodes[static_cast<std::size_t>(at[worst].node)] + base);
    else
      std::snprintf(place, sizeof place, "at xi = %g, eta = %g", at[worst].at.xi, at[worst].at.eta);
    (defect == Defect::vanishing ? vanishing : turning)
        .add("element %lld (%s) %s", id, name(type), place);
  }
  coincident.fail_if_any("degenerate element: two of its nodes coincide", "surface",
                         mesh.index_base);
  vanishing.fail_if_any(
      "degenerate element: its Jacobian vanishes (no area, a corner of 180 degrees, or a midside "
      "node at a quarter of its edge)",
      "surface", mesh.index_base);
  turning.fail_if_any(
      "degenerate element: its normal turns over within it (folded, concave, or with a midside "
      "node "
      "beyond the quarter of its edge)",
      "surface", mesh.index_base);
}

std::vector<double> nearest_of_own_elements(const SurfaceMesh& mesh) {
  std::vector<double> nearest(mesh.node.size(), std::numeric_limits<double>::infinity());
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const auto nodes = mesh.element(e);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const auto a = static_cast<std::size_t>(nodes[i]), b = static_cast<std::size_t>(nodes[j]);
        const double d = length(mesh.node[a] - mesh.node[b]);
        nearest[a] = std::min(nearest[a], d);
        nearest[b] = std::min(nearest[b], d);
      }
  }
  return nearest;
}

/// Numbers of faces mean nothing to the caller: the message names nodes.
void check_boundary_edges(const SurfaceMesh& mesh) {
  const auto base = static_cast<long long>(mesh.index_base);
  Tally crowded;
  for_each_edge(sorted_sides(corner_cells(mesh)), [&](const Side& s, std::size_t count) {
    if (count > 2)
      crowded.add("nodes %lld and %lld, with %lld faces", s.low() + base, s.high() + base,
                  static_cast<long long>(count));
  });
  crowded.fail_if_any(
      "the body touches itself along an edge: more than two of its boundary faces meet there; join "
      "its parts by a common face or give each its own nodes",
      "volume", mesh.index_base);
}

}  // namespace

void check_surface(const SurfaceMesh& mesh, SurfaceKind kind) {
  if (mesh.elements() == 0) fail(Status::err_mesh, "the surface has no elements");
  if (kind == SurfaceKind::boundary) return check_boundary_edges(mesh);
  check_connectivity(mesh, "surface");
  check_nodes_used(mesh);
  check_shapes(mesh);
  check_coinciding_nodes(mesh.node, nearest_of_own_elements(mesh), mesh.index_base, "surface");

  const std::vector<Side> sides = sorted_sides(corner_cells(mesh));
  check_edges(mesh, sides);
  if (kind == SurfaceKind::open) return check_neighbours(mesh, find_shells(mesh, sides));
  check_closed(mesh, sides);
  check_fans(mesh, sides);
  check_outward(mesh, find_shells(mesh, sides));
  check_crossing(mesh);
}

}  // namespace rollcon
