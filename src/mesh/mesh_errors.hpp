#pragma once
/// Reports the findings of mesh checks: the first offender and the number of offenders.

#include <array>
#include <cstdint>
#include <cstdio>
#include <limits>
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

}  // namespace rollcon
