#pragma once
/// Makes elements without their midside nodes.

#include "mesh/surface_mesh.hpp"

namespace rollcon {

/// Returns the type of an element's corners alone.
constexpr ElementType linear_type(ElementType type) {
  return corner_count(type) == 3 ? ElementType::tri3 : ElementType::quad4;
}

/// Returns the mesh with all its elements linear, on unchanged nodes.
SurfaceMesh corner_elements(SurfaceMesh mesh);

}  // namespace rollcon
