#pragma once
/// Integrates with a weight that decays exponentially upstream, as the memory of a relaxing material does.

#include <span>
#include <vector>

namespace rollcon::halfspace {

/// Returns n points of [0, 1], n = 2 to 16, in ascending order with 0 and 1 among them: the extrema of a Chebyshev
/// polynomial. All are computed once.
const std::vector<double>& lag_points(int n);

/// Sets weights of values at lag_points(weight.size()) that integrate f(t) rate exp(-rate t) over [0, 1], rate > 0. The
/// polynomial through the values is integrated exactly.
void lag_weights(double rate, std::span<double> weight);

/// Turns weights of the slopes at these points, spread over [0, length], into weights of the values there.
void weigh_slopes(double length, std::span<double> weight);

}  // namespace rollcon::halfspace
