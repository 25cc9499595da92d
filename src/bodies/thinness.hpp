#pragma once
/// Finds bodies that are thin beside their own elements: the mesh does not show their bending.

#include <cstdint>
#include <span>

#include "bodies/model/body_mesh.hpp"
#include "bodies/model/compliance.hpp"

namespace rollcon {

struct Thinness {
  double part = 0;   ///< part of the free surface, by area, whose elements are too long for the thickness there
  double ratio = 0;  ///< mean length of these elements over the thickness, by area
};

/// Measures thickness along the inward normal at an element's middle, to the opposite side of the body. Elements that
/// are held, or opposite to held ones, do not count: glued layers do not bend. linear, quadratic: largest length
/// (diagonal over sqrt 2) over the thickness, by kind of element.
Thinness thinness(BodyMesh& mesh, double linear, double quadratic);

/// Measures the body under some elements.
MeshOnFrame look_under(const BodyMesh& mesh, std::span<const std::int64_t> element);

}  // namespace rollcon
