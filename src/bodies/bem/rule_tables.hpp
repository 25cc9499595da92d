#pragma once
/// Gauss rules of the far field with the values of the shape functions at their points.

#include "bodies/bem/kelvin.hpp"

namespace rollcon::bem {

/// Largest rule per direction of a quadrilateral in the far field.
inline constexpr int most_far_points = 8;

/// Rule with n1 x n2 points on a quadrilateral (1 to most_far_points each), or the smallest one of degree n1 or more on
/// a triangle. Computed once for each type.
const RuleTable& rule_table(ElementType type, int n1, int n2);

}  // namespace rollcon::bem
