#pragma once
/// Makes Gauss rules with a hat function as weight, for smooth functions of the source point.

#include "bodies/model/translation.hpp"
#include "mesh/quadrature.hpp"

namespace rollcon::halfspace {

inline constexpr int max_hat_points = 10;

/// Returns the n-point rule, ascending, exact to degree 2n - 1, for h = 1; weights sum to 1 (half a hat: 1/2).
LineRule hat_rule(Hat hat, int n);

}  // namespace rollcon::halfspace
