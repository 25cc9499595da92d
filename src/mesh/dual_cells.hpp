#pragma once
/// Builds the median-dual mesh of the projected frame (docs/theory.md, section 5): the cell of node I joins the
/// centroids of the linear cells and the edge midpoints around I.

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/topology.hpp"

namespace rollcon {

/// Is one straight face between the cells of two nodes, from an edge's midpoint to a centroid; (nx, ny) is the normal
/// from `from` to `to`, times the face's length.
struct DualFace {
  std::int32_t from, to;
  double nx, ny;
};

struct DualCells {
  std::vector<DualFace> face;
  std::vector<double> area;  ///< area per node; 0 for nodes of no element
};

/// Takes nodal coordinates x, y in the tangent plane.
DualCells build_dual_cells(const LinearCells& cells, std::span<const double> x, std::span<const double> y);

}  // namespace rollcon
