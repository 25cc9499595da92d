#pragma once
/// Evaluates Lagrange and serendipity shape functions of the frame's elements. The reference triangle has the corners
/// (0,0), (1,0), (0,1); the reference square is [-1,1]^2, with its first corner at (-1,-1).

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

/// Evaluates values and derivatives at a reference point; entries past node_count(type) are not written.
void evaluate_shape(ElementType type, double xi, double eta, Shape& shape);

/// Returns the reference coordinates of the element's nodes, in their order.
std::span<const ReferencePoint> reference_nodes(ElementType type);

}  // namespace rollcon
