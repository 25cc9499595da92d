#pragma once
/// Joins elements around nodes into fans.

#include <algorithm>
#include <numeric>
#include <vector>

#include "mesh/element_sides.hpp"

namespace rollcon {

/// Holds sets of entries of the connectivity: each entry starts alone, and entries of one node are joined.
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

  /// Returns the first entry of the fan that entry i belongs to.
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

}  // namespace rollcon
