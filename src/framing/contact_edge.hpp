#pragma once
/// Finds where a contact ends, from its pressures and gaps on a lattice.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "framing/outline.hpp"

namespace rollcon {

/// Numbers nodes (i, j), both from 0 to intervals, line by line, over a rectangle about (x, y) whose sides are turned
/// by `angle`.
struct SearchGrid {
  double x = 0, y = 0, angle = 0;
  double half_length = 0, half_width = 0;
  std::int64_t intervals = 0;

  std::int64_t lines() const { return intervals + 1; }
  double spacing_along() const { return 2 * half_length / static_cast<double>(intervals); }
  double spacing_across() const { return 2 * half_width / static_cast<double>(intervals); }
  /// Returns the extent of an interval along x and y.
  EdgePoint cell() const;
  /// Returns a point; i and j may be fractions.
  EdgePoint point(double i, double j) const;
};

/// Holds the edge of one connected part of the contact, or of several that lie close to each other.
struct PatchEdge {
  std::vector<EdgePoint> point;
  std::vector<LoadAt> load;  ///< loads of the nodes in contact
  /// Number of nodes in contact from the first to the last, the lesser of both directions.
  std::int64_t least_nodes_across = 0;
};

/// Returns the undeformed gap, +infinity where a body is not there.
using GapBetween = std::function<double(double x, double y)>;

/// Finds the edges from pressure and deformed gap at the nodes; modulus: E* of the bodies.
std::vector<PatchEdge> contact_edges(const SearchGrid& lattice, std::span<const double> pressure,
                                     std::span<const double> gap, double modulus, const GapBetween& undeformed);

}  // namespace rollcon
