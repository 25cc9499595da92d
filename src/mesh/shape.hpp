#pragma once
/// Lagrange and serendipity shape functions of the frame's elements. Reference triangle: corners (0,0), (1,0), (0,1);
/// reference square: [-1,1]^2, first corner (-1,-1).

#include <array>
#include <span>

#include "mesh/element_type.hpp"

namespace rollcon {

struct Shape {
  std::array<double, max_element_nodes> value;  ///< N_i
  std::array<double, max_element_nodes> d_xi;   ///< dN_i / dxi
  std::array<double, max_element_nodes> d_eta;  ///< dN_i / deta
};

struct ReferencePoint {
  double xi, eta;
};

/// Values and derivatives at a reference point; entries past node_count(type) are left alone.
void evaluate_shape(ElementType type, double xi, double eta, Shape& shape);

/// Reference coordinates of the element's nodes, in their order.
std::span<const ReferencePoint> reference_nodes(ElementType type);

}  // namespace rollcon
