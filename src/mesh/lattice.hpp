#pragma once
/// Regular rectangular frames: where convolution replaces dense matrices.

#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/frame.hpp"

namespace rollcon {

/// The nodes of a frame as a full grid of equal rectangular cells. Node (ix, iy) lies at
///   (x0, y0) + ix dx (ex, ey) + iy dy (-ey, ex)
/// in the frame's axes (t1, t2).
struct Lattice {
  std::int64_t nx = 0, ny = 0;  ///< nodes along either axis of the grid, at least 2
  double dx = 0, dy = 0;        ///< spacings
  double ex = 1, ey = 0;        ///< unit direction of the first axis, the one closer to t1; ex > 0
  double x0 = 0, y0 = 0;
  std::vector<std::int32_t> node;  ///< node[iy * nx + ix]: number in the frame

  std::int64_t nodes() const { return nx * ny; }
  /// Spacing along the flow (t1) of a node amid others: the area of a cell over its extent across.
  double spacing_along_flow() const { return dx * dy / (dx * (ey < 0 ? -ey : ey) + dy * ex); }
};

/// The grid of a flat frame of quad4 elements, turned and numbered in any way, with every node and
/// every cell there; none if the frame is anything else. Nodes may be off their places by 1e-10 of
/// a spacing times the nodes along the longer side. Takes O(nodes) time.
std::optional<Lattice> find_lattice(const Frame& frame);

}  // namespace rollcon
