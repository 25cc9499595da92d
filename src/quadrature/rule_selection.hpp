#pragma once
/// Chooses a rule for an element, or a part of one, seen from a point.
///
/// Gauss's rule with n points on a line, for a kernel times a polynomial of degree p, is off by about C rho^-(2n - p)
/// of the integrals' scale, area/(2 pi d^2) for T and area/(4 pi d) for U: rho is the parameter of the ellipse with
/// foci at the line's ends through the complex point of the line at which r = 0. Elements that depart from an affine
/// map by kappa (relative) raise p by up to k; every degree costs kappa rho. The Jacobian in U is no polynomial on
/// curved elements: it has an ellipse of its own, through the point at which the normal vector vanishes. C is
/// calibrated by the sweep in tests/bodies/bem/integrals/rule_selection_test.cpp.

#include "quadrature/element.hpp"

namespace rollcon::quadrature {

/// Holds the allowed error of the integrals of T (a number) and of U (a length); infinite: not wanted.
struct Tolerance {
  double t, u;
};

/// The largest Gauss rule has so many points per direction; the highest degree on triangles follows.
inline constexpr int most_line_points = 12;
inline constexpr int most_triangle_degree = 12;
/// This is C in the estimate above.
inline constexpr double rule_constant = 5;

struct Selection {
  /// Gauss points along the first and second direction of a quadrilateral (beyond most_line_points: split along this
  /// direction), or degree of exactness on a triangle.
  int first = 0, second = 0;
  bool gauss = false;  ///< false: needs the rules of the near field
};

/// Returns the cell relative to the point.
CellShape seen_from(const CellShape& cell, const Vec3& point);
/// Selects a rule for the origin: the cell is relative to the point.
Selection select_rule(const ElementGeometry& element, const CellShape& cell, Tolerance tolerance);

}  // namespace rollcon::quadrature
