#pragma once
/// Gauss rules with a hat function as weight, for smooth functions of the source point.

#include "mesh/quadrature.hpp"

namespace rollcon::halfspace {

/// A linear hat along one axis, 1 at 0 and 0 at distance h, or the half of it beside 0.
enum class Hat {
  before,  ///< [-h, 0]
  whole,   ///< [-h, h]
  after,   ///< [0, h]
};

inline constexpr int max_hat_points = 10;

/// n-point rule, exact to degree 2n - 1, for h = 1; weights sum to 1 (a half: 1/2). Ascending.
LineRule hat_rule(Hat hat, int n);

}  // namespace rollcon::halfspace
