#pragma once
/// Recognises regular rectangular frames, where convolution replaces dense matrices.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mesh/frame.hpp"

namespace rollcon {

/// Holds the nodes of a frame as places of a grid of equal rectangular cells, of which some may lack. Node (ix, iy)
/// lies at
///   (x0, y0) + ix dx (ex, ey) + iy dy (-ey, ex)
/// in the frame's axes (t1, t2).
struct Lattice {
  /// Names the cells around a node, as bits of cells[].
  enum Cell : std::uint8_t { low_low = 1, high_low = 2, low_high = 4, high_high = 8, all = 15 };

  std::int64_t nx = 0, ny = 0;  ///< places along either axis of the grid, at least 2
  double dx = 0, dy = 0;        ///< spacings
  double ex = 1, ey = 0;        ///< unit direction of the first axis, the one closer to t1; ex > 0
  double x0 = 0, y0 = 0;
  std::vector<std::int32_t> node;   ///< node[iy * nx + ix]: number in the frame; -1: none
  std::vector<std::uint8_t> cells;  ///< cells around each place that are there
  std::vector<std::int32_t> loose;  ///< nodes of the frame that belong to no cell
  double misfit = 0;                ///< largest distance of a node from its place, over the smaller spacing

  std::int64_t frame_nodes() const;
  /// Says whether some node has all its cells.
  bool has_inner_node() const;
  /// Returns the spacing along the flow (t1) of a node amid others: the area of a cell over its extent across.
  double spacing_along_flow() const { return dx * dy / (dx * (ey < 0 ? -ey : ey) + dy * ex); }

  /// Sets nx, ny, node, cells and loose from the place of each node of the frame (-1: none) and the places of the low
  /// corners of the cells.
  void place(std::int64_t columns, std::int64_t lines, const std::vector<std::int32_t>& place_of,
             const std::vector<std::int32_t>& low_corner);
};

/// Nodes may be off their places by this fraction of the smaller spacing, which coordinates in single precision are.
/// Results change by about as much.
inline constexpr double lattice_tolerance = 1e-5;
/// The number of nodes over that of places is at least this: emptier grids cost more than they save.
inline constexpr double least_lattice_fill = 0.25;

/// Finds the grid of a flat frame of quad4 elements, turned and numbered in any way, with or without holes and nodes of
/// no element; none if the frame is anything else, for the reason then given in *why. Spacings, axes and origin are
/// those of least squares. Takes O(nodes) time.
std::optional<Lattice> find_lattice(const Frame& frame, std::string* why = nullptr);

/// Returns false if the sides of the elements, whose shapes and connections nobody has checked yet, already rule a grid
/// out.
bool may_be_lattice(const SurfaceMesh& mesh);

}  // namespace rollcon
