#pragma once
/// Elements without their midside nodes.

#include "mesh/surface_mesh.hpp"

namespace rollcon {

/// The type of the corners alone.
constexpr ElementType linear_type(ElementType type) {
  return corner_count(type) == 3 ? ElementType::tri3 : ElementType::quad4;
}

/// The same elements on the same nodes, all linear.
SurfaceMesh corner_elements(SurfaceMesh mesh);

}  // namespace rollcon
