#pragma once
/// Lists all faces of volume elements by their corners, to tell who shares a face with whom.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/volume_boundary.hpp"

namespace rollcon {

struct CornerFace {
  std::array<std::int32_t, 4> corner;  ///< ascending; the last is -1 for triangles
  BoundaryFace of;
};

/// Returns all faces of all elements, ascending by their corners, then element and side, so that those on equal corners
/// stand together. Nodes must not be negative.
std::vector<CornerFace> sorted_faces(const VolumeElements& volume);

/// Returns the numbers of a face's corners in the order of CornerFace.
std::array<std::int32_t, 4> sorted_corners(std::span<const std::int32_t> corner);

/// Returns the nodes of a face, looking out of its element; node_count(faces_of(...)[side].type) of them.
std::array<std::int32_t, 8> face_nodes(const VolumeElements& volume, const BoundaryFace& face);

/// Calls f(faces) for each group of faces on equal corners.
template <class F>
void for_each_face(std::span<const CornerFace> face, F f) {
  for (std::size_t i = 0; i < face.size();) {
    std::size_t j = i + 1;
    while (j < face.size() && face[j].corner == face[i].corner) ++j;
    f(face.subspan(i, j - i));
    i = j;
  }
}

}  // namespace rollcon
