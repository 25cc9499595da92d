#pragma once
/// Evaluates elements of a section, and edges of its boundary, at points.

#include <array>
#include <vector>

#include "mesh/element_type.hpp"
#include "mesh/swept_section.hpp"

namespace rollcon::section {

/// Holds a point of an element: its coordinates along e1 and e2, and the shape functions and their derivatives there.
struct PlanePoint {
  double p = 0, q = 0;
  double jacobian = 0;
  double xi_p = 0, xi_q = 0, eta_p = 0, eta_q = 0;  ///< derivatives of the reference coordinates
  std::array<double, max_element_nodes> value{}, dp{}, dq{};
};
PlanePoint plane_point(const SweptSection& section, std::int64_t element, double xi, double eta);

/// Holds a point of an edge: the shape functions of both ends and the middle, the derivative of the place (half of the
/// edge, if that is straight), and the weight of a rule times the length of the way per radian.
struct EdgePoint {
  std::array<double, 3> value{};
  double dp = 0, dq = 0, weight = 0;
};
std::vector<EdgePoint> edge_points(const SweptSection& section, const SectionEdge& edge);

/// Holds integrals of products of an edge's shape functions over the edge and one radian of the way.
using EdgeMass = std::array<std::array<double, 3>, 3>;
EdgeMass edge_mass(const SweptSection& section, const SectionEdge& edge);

}  // namespace rollcon::section
