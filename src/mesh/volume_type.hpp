#pragma once
/// Lists the element types of volume meshes. Numbers are those of rollcon.h and never change.

#include <cstdint>

namespace rollcon {

enum class VolumeType : std::int32_t {
  tet4 = 304,
  tet10 = 310,
  wedge6 = 326,
  wedge15 = 335,
  hex8 = 338,
  hex20 = 350,
};

/// Returns the number of nodes. Corners are numbered so that the Jacobian is positive (tetrahedron: 0, 1, 2
/// counter-clockwise seen from 3; wedge and hexahedron: bottom face counter-clockwise seen from the top, then the top
/// face above it), and the edge midpoints follow. Tetrahedron: edges 01 12 20 03 13 23. Wedge: 01 12 20, 34 45 53, 03
/// 14 25. Hexahedron: 01 12 23 30, 45 56 67 74, 04 15 26 37.
constexpr int node_count(VolumeType type) {
  switch (type) {
    case VolumeType::tet4:
      return 4;
    case VolumeType::tet10:
      return 10;
    case VolumeType::wedge6:
      return 6;
    case VolumeType::wedge15:
      return 15;
    case VolumeType::hex8:
      return 8;
    case VolumeType::hex20:
      return 20;
  }
  return 0;
}

constexpr int corner_count(VolumeType type) {
  switch (type) {
    case VolumeType::tet4:
    case VolumeType::tet10:
      return 4;
    case VolumeType::wedge6:
    case VolumeType::wedge15:
      return 6;
    case VolumeType::hex8:
    case VolumeType::hex20:
      return 8;
  }
  return 0;
}

constexpr bool is_quadratic(VolumeType type) {
  return node_count(type) != corner_count(type);
}

constexpr int max_volume_nodes = 20;

/// Returns true when the number is one of the enumerators above.
constexpr bool is_volume_type(std::int32_t type) {
  return node_count(static_cast<VolumeType>(type)) > 0;
}

}  // namespace rollcon
