#pragma once
/// Makes a coarser triangulation on some of a frame's own nodes.

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/frame.hpp"

namespace rollcon {

struct CoarseMesh {
  std::vector<std::int32_t> node;                   ///< node of the frame of each coarse node
  std::vector<std::array<std::int32_t, 3>> corner;  ///< triangles of coarse nodes
};

/// Makes linear triangles on about a quarter of the nodes; on a grid on every second node of every second line. They
/// cover the frame: corners and nodes along a curved rim stay, and so does every node that cannot be taken out without
/// turning a triangle over (in the projection).
CoarseMesh coarsen(const Frame& frame);

}  // namespace rollcon
