#pragma once
/// Turns elements over, to be seen from their other side.

#include "mesh/surface_mesh.hpp"

namespace rollcon {

/// Returns which of an element's nodes comes at place k seen from its other side; the first node stays.
constexpr int turned_over(ElementType type, int k) {
  const int corners = corner_count(type);
  if (k < corners) return (corners - k) % corners;
  return k < 2 * corners ? 3 * corners - 1 - k : k;
}

/// Makes all elements look the other way.
void turn_over(SurfaceMesh& mesh);

}  // namespace rollcon
