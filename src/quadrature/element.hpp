#pragma once
/// What the quadrature needs to know of an element's shape on the tangent plane.

#include <cstdint>

#include "mesh/element_type.hpp"
#include "mesh/frame.hpp"

namespace rollcon::quadrature {

/// Smoothness of an element's map, which decides the polynomial degrees of the integrands.
enum class MapKind : std::uint8_t { affine, straight, curved };

struct ElementShape {
  ElementType type = ElementType::tri3;
  MapKind map = MapKind::affine;
  double x[max_element_nodes], y[max_element_nodes];
  double centre_x = 0, centre_y = 0;
  double half_length = 0;  ///< of the longest side or median of the element
  double area = 0;
};

ElementShape element_shape(const Frame& frame, std::int64_t element);

/// Degree of shape function times Jacobian: in each reference direction of a quadrilateral, in all
/// of a triangle.
int direction_degree(ElementType type, MapKind map);
/// Total degree along a ray from any point.
int ray_degree(ElementType type, MapKind map);

}  // namespace rollcon::quadrature
