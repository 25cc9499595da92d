#pragma once
/// Tabulates Gauss rules of the far field with the values of the shape functions at their points.

#include "bodies/bem/kelvin.hpp"

namespace rollcon::bem {

/// Limits the points per direction of a rule for a quadrilateral in the far field.
inline constexpr int most_far_points = 8;

/// Returns the rule with n1 x n2 points on a quadrilateral (1 to most_far_points each), or the smallest one of degree
/// n1 or more on a triangle. Rules are computed once for each type.
const RuleTable& rule_table(ElementType type, int n1, int n2);

}  // namespace rollcon::bem
