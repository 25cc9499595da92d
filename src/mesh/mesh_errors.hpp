#pragma once
/// How checks of meshes report: the first offender and their number.

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
  /// where: "frame", "surface" or "volume"; base: what the caller's numbers
  /// count from.
  void fail_if_any(const char* what, const char* where, std::int32_t base) const {
    if (count > 0)
      fail(Status::err_mesh, "%s; %lld such in the %s; first: %s (counting from %d)", what, count, where, first.c_str(),
           base);
  }
};

/// Numbers and names as the caller knows them, of a surface or the inside of a
/// volume.
template <class Elements>
struct Names {
  const Elements& mesh;
  std::int32_t base;  ///< what the caller's numbers count from
  const char* where;  ///< "frame", "surface" or "volume"
  long long node(std::int64_t k) const { return k + base; }
  long long element(std::int64_t e) const { return e + base; }
  const char* type(std::int64_t e) const { return name(mesh.type[static_cast<std::size_t>(e)]); }
  void refuse(const Tally& found, const char* what) const { found.fail_if_any(what, where, base); }
};

/// Nodes in range, no node twice in an element, no element twice. Before
/// anything is computed.
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

/// How far apart an element's nodes are, and how far from the origin.
struct NodeExtent {
  double size = 0, magnitude = 0;
  double nearest = std::numeric_limits<double>::infinity();  ///< of near_i and near_j
  std::size_t near_i = 0, near_j = 0;
  std::array<double, max_volume_nodes> own;  ///< by node: distance of the nearest other one
};
NodeExtent measure_nodes(std::span<const Vec3> point);

/// Points where a surface element's Jacobian is checked. A linear element's is
/// linear in each variable, so its corners decide; quadratic ones get a lattice
/// with spacing 1/8 of the element.
struct CheckPoint {
  ReferencePoint at;
  int node = -1;  ///< local node that lies there
  Shape shape;
};
std::vector<CheckPoint> check_points(ElementType type);

}  // namespace rollcon
