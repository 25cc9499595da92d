#pragma once
/// Reports the findings of mesh checks: the first offender and the number of offenders.

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "mesh/shape.hpp"
#include "mesh/surface_mesh.hpp"
#include "mesh/volume_mesh.hpp"
#include "support/error.hpp"

namespace rollcon {

const char* name(ElementType type);
const char* name(VolumeType type);

/// Counts the offenders and remembers the first; fails at the end of the sweep.
struct Tally {
  long long count = 0;
  std::string first;

  template <class... Args>
  void add(const char* format, Args... args) {
    if (count++ > 0) return;
    char text[256];
    std::snprintf(text, sizeof text, format, args...);
    first = text;
  }
  /// Fails if anything was counted. `where` is "frame", "surface" or "volume"; `base` is what the caller's numbers
  /// count from.
  void fail_if_any(const char* what, const char* where, std::int32_t base) const {
    if (count > 0)
      fail(Status::err_mesh, "%s; %lld such in the %s; first: %s (counting from %d)", what, count, where, first.c_str(),
           base);
  }
};

/// Gives the numbers and names that the caller knows, for a surface or the inside of a volume.
template <class Elements>
struct Names {
  const Elements& mesh;
  std::int32_t base;  ///< first number of the caller
  const char* where;  ///< "frame", "surface" or "volume"
  long long node(std::int64_t k) const { return k + base; }
  long long element(std::int64_t e) const { return e + base; }
  const char* type(std::int64_t e) const { return name(mesh.type[static_cast<std::size_t>(e)]); }
  void refuse(const Tally& found, const char* what) const { found.fail_if_any(what, where, base); }
};

/// Checks that nodes are in range, no node comes twice in an element, and no element twice. It runs before anything is
/// computed.
template <class Elements>
void check_connectivity(const Names<Elements>& names, std::int64_t nodes);
extern template void check_connectivity(const Names<SurfaceMesh>&, std::int64_t);
extern template void check_connectivity(const Names<VolumeElements>&, std::int64_t);

template <class Elements>
void check_nodes_used(const Names<Elements>& names, std::int64_t nodes) {
  std::vector<char> used(static_cast<std::size_t>(nodes), 0);
  for (const std::int32_t k : names.mesh.connectivity) used[static_cast<std::size_t>(k)] = 1;
  Tally unused;
  for (std::size_t k = 0; k < used.size(); ++k)
    if (!used[k]) unused.add("node %lld", names.node(static_cast<std::int64_t>(k)));
  names.refuse(unused, "a node belongs to no element");
}

/// Holds how far apart an element's nodes are, and how far from the origin.
struct NodeExtent {
  double size = 0, magnitude = 0;
  double nearest = std::numeric_limits<double>::infinity();  ///< distance of near_i and near_j
  std::size_t near_i = 0, near_j = 0;
  std::array<double, max_volume_nodes> own;  ///< distance of the nearest other node, by node
};
NodeExtent measure_nodes(std::span<const Vec3> point);

/// Is a point where a surface element's Jacobian is checked. A linear element's Jacobian is linear in each variable, so
/// its corners decide; quadratic ones get a lattice with spacing 1/8 of the element.
struct CheckPoint {
  ReferencePoint at;
  int node = -1;  ///< local node that lies there
  Shape shape;
};
std::vector<CheckPoint> check_points(ElementType type);

/// Coordinates carry the rounding of their magnitude: what is below this cannot be told from zero.
constexpr double coordinate_rounding = 16 * std::numeric_limits<double>::epsilon();
/// Smallest height of an element over its length, and smallest distance of two nodes over it.
constexpr double smallest_ratio = 1e-10;

/// One surface element: its nodes, which do not coincide, the rounding of the coordinates over its size, and where its
/// Jacobian is looked at.
struct ShapeToCheck {
  std::int64_t element;
  std::span<const Vec3> node;
  double size, noise;
  const std::vector<CheckPoint>& points;
};
/// Calls look(ShapeToCheck) for all elements whose nodes are apart, and refuses the others. point_of(node) tells
/// coordinates. Returns for each node the distance to the nearest other node of its elements.
template <class PointOf, class Look>
std::vector<double> look_at_shapes(const Names<SurfaceMesh>& names, PointOf point_of, Look look) {
  const SurfaceMesh& mesh = names.mesh;
  std::vector<double> nearest(mesh.node.size(), std::numeric_limits<double>::infinity());
  std::map<ElementType, std::vector<CheckPoint>> points;
  Tally coincident;
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const ElementType type = mesh.type[static_cast<std::size_t>(e)];
    const auto nodes = mesh.element(e);
    std::array<Vec3, max_element_nodes> all;
    for (std::size_t i = 0; i < nodes.size(); ++i) all[i] = point_of(static_cast<std::size_t>(nodes[i]));
    const std::span<const Vec3> point(all.data(), nodes.size());
    const NodeExtent extent = measure_nodes(point);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      double& own = nearest[static_cast<std::size_t>(nodes[i])];
      own = std::min(own, extent.own[i]);
    }
    const double noise = coordinate_rounding * extent.magnitude / extent.size;
    if (extent.nearest > std::max(smallest_ratio, noise) * extent.size) {
      auto& looked_at = points[type];
      if (looked_at.empty()) looked_at = check_points(type);
      look(ShapeToCheck{e, point, extent.size, noise, looked_at});
    } else {
      coincident.add("element %lld (%s), nodes %lld and %lld", names.element(e), name(type),
                     names.node(nodes[extent.near_i]), names.node(nodes[extent.near_j]));
    }
  }
  names.refuse(coincident, "degenerate element: two of its nodes coincide");
  return nearest;
}

}  // namespace rollcon
