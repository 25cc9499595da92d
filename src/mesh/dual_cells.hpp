#pragma once
/// Median-dual mesh of the projected frame (docs/theory.md, section 5): the cell of node I joins the centroids of the
/// linear cells and the edge midpoints around I.

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/topology.hpp"

namespace rollcon {

/// One straight face between the cells of two nodes, from an edge's midpoint to a centroid.
/// (nx, ny): normal from `from` to `to`, times the face's length.
struct DualFace {
  std::int32_t from, to;
  double nx, ny;
};

struct DualCells {
  std::vector<DualFace> face;
  std::vector<double> area;  ///< per node; 0 for nodes of no element
};

/// x, y: nodal coordinates in the tangent plane.
DualCells build_dual_cells(const LinearCells& cells, std::span<const double> x, std::span<const double> y);

}  // namespace rollcon
