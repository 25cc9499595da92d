#pragma once
/// Provides quadrature rules of the half-space integrals. They are symmetric under every symmetry of the reference
/// element, so that mirrored frames give mirrored integrals.

#include <vector>

#include "mesh/quadrature.hpp"
#include "quadrature/near_points.hpp"

namespace rollcon::quadrature {

inline constexpr int max_line_points = 24;

/// Returns the Gauss-Legendre rule with n points on [-1, 1], 1 <= n <= max_line_points; it is computed once.
const LineRule& line_rule(int n);

struct TriangleRule {
  int degree;
  PlaneRule points;  ///< points on (0,0), (1,0), (0,1); weights sum to 1/2
};

/// Returns fully symmetric rules with positive weights and inner points, ascending in degree.
const std::vector<TriangleRule>& symmetric_triangle_rules();

/// Takes a symmetric rule of at least the degree `first` on triangles (or else the highest there is), and first x
/// second Gauss points on quadrilaterals.
void fill_rule(bool triangle, int first, int second, NearPoints& points);

}  // namespace rollcon::quadrature
