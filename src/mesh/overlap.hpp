#pragma once
/// Finds cells that lie over one another in the plane, with a tree of boxes.

#include <cstdint>
#include <span>

#include "mesh/topology.hpp"

namespace rollcon {

struct ElementOverlap {
  std::int64_t first = -1, second = -1;  ///< a pair of cells; -1: none
  std::int64_t count = 0;                ///< number of cells found to lie over another
};

/// Takes convex counter-clockwise cells. A cell counts when its centroid or one of its nodes is inside another cell
/// (deeper than `tolerance` times that cell's size).
ElementOverlap find_overlap(const LinearCells& cells, std::span<const double> x, std::span<const double> y,
                            double tolerance);

}  // namespace rollcon
