#pragma once
/// Lays strips on a contact along the rolling direction: rows of nodes whose chords' ends and whose width are unknowns.
/// Each part of the contact (convex along rolling) has rows of its own. See docs/theory.md, section 4.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rollcon::strips {

/// Pads places of sources to a multiple of this (bodies/halfspace/strip_kernels.hpp).
constexpr int kernel_width = 8;

/// Counts intervals of every part along the rolling direction and across; at least 4 each.
struct StripCounts {
  int along = 8, across = 12;
  bool operator==(const StripCounts&) const = default;
};

/// Describes a place that moves with the strips: x = middle c[row] + beyond c[beside] + half s[row],
/// y = M[part] + across S[part].
struct StripPoint {
  int row = 0, beside = 0, part = 0;
  double middle = 1, beyond = 0, half = 0, across = 0;
};

/// Returns the usual place of a row in the width, from -1 to 1, at a parameter in the same range that is uniform.
double usual_row(double t);

/// Holds what depends on the counts, the number of parts and the places of rows alone. A geometry is a vector of
/// lengths in this order: middle c and half length s of each row's chord, middle M and half width S of each part.
class StripLayout {
 public:
  StripLayout() = default;
  /// across: places of rows in the width, from -1 to 1 with both ends; empty: the usual ones.
  StripLayout(StripCounts counts, int parts, std::vector<double> across = {});

  StripCounts counts;
  int parts = 0, rows_each = 0, rows = 0, nodes_each = 0, nodes = 0;  ///< nodes lie inside of chords
  int geometry = 0;                                                   ///< length of a geometry
  int places = 0;                    ///< count of all rows' nodes with the chords' ends, padded for the kernels
  std::vector<double> along;         ///< places of a chord's nodes, from -1 to 1: sin(pi t/2), t uniform
  std::vector<double> across;        ///< places of rows in the width, with its ends
  std::vector<double> slope;         ///< slopes of hats: 1 over each interval along
  std::vector<double> weight, turn;  ///< values for the three feet of each place, [foot][place]
  std::vector<StripPoint> node;      ///< nodes inside, row by row
  std::vector<StripPoint> upstream;  ///< places 0.6 of the mean spacing further on, for differences along x
  std::vector<double> spacing;       ///< distance of node and upstream over the half chord
  /// Differences belong between node and upstream place. Slip at the node is extrapolated from them: these are the
  /// weights of the node's difference and of those of the next two nodes upstream. The last two nodes of a chord take
  /// slip half way to the upstream place as it is, and the node before them extrapolates from two differences: slip
  /// that pressures of unlike bodies cause bends sharply at the edge.
  std::vector<std::array<double, 3>> carry;
  std::vector<StripPoint> slip_place;  ///< places where slip is taken
  /// Places where gaps vanish: the nodes, then beside the chords' ends and beyond the ends of the widths.
  std::vector<StripPoint> observers;
  std::vector<double> unit_weight;   ///< load of a node's unit pressure over s[row] S[part]
  std::vector<StripPoint> centroid;  ///< centroid of a node's shape function
  std::vector<double> unit_cell;     ///< part of the contact's area that is a node's, over s[row] S[part]

  int part_of(int row) const { return row / rows_each; }
  int middle_of(int row) const { return row; }
  int half_of(int row) const { return rows + row; }
  int centre_of(int part) const { return 2 * rows + part; }
  int width_of(int part) const { return 2 * rows + parts + part; }

  double x(const StripPoint& p, const double* g) const {
    return p.middle * g[p.row] + p.beyond * g[p.beside] + p.half * g[rows + p.row];
  }
  double y(const StripPoint& p, const double* g) const { return g[centre_of(p.part)] + p.across * g[width_of(p.part)]; }
  /// Returns s[row] S[part] of a node, which weights and cells multiply.
  double cell(const StripPoint& node, const double* g) const { return g[half_of(node.row)] * g[width_of(node.part)]; }
  /// Adds (fx, fy) . d(x, y)/dgeometry to rates.
  void add_motion(const StripPoint& p, double fx, double fy, double* rates) const {
    rates[p.row] += p.middle * fx;
    rates[p.beside] += p.beyond * fx;
    rates[rows + p.row] += p.half * fx;
    rates[centre_of(p.part)] += fy;
    rates[width_of(p.part)] += p.across * fy;
  }
};

/// Describes strips under a frame, whose nodes are the ends of the parts' widths and all nodes of rows with their ends.
struct StripFrame {
  StripLayout layout;
  std::vector<double> geometry;
  std::vector<std::int32_t> node;  ///< frame's node of each node inside
};

}  // namespace rollcon::strips
