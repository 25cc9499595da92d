#pragma once
/// Elements seen from their other side.

#include <span>

#include "mesh/surface_mesh.hpp"

namespace rollcon {

/// Order of an element's nodes seen from its other side; the first node stays.
std::span<const int> turned_over(ElementType type);

/// Makes all elements look the other way.
void turn_over(SurfaceMesh& mesh);

}  // namespace rollcon
