#pragma once
/// Integrates with weights that fall exponentially: what is left of a material's past at a distance upstream.

#include <span>
#include <vector>

namespace rollcon::halfspace {

/// Returns n >= 2 points of [0, 1], ascending, 0 and 1 among them: extrema of a Chebyshev polynomial, computed once for
/// each n up to 16.
const std::vector<double>& lag_points(int n);

/// Sets weights for values at lag_points(weight.size()) that integrate f(t) rate exp(-rate t) over [0, 1]; the
/// polynomial through the values is integrated exactly. rate > 0.
void lag_weights(double rate, std::span<double> weight);

/// Turns weights for the slopes at these points of [0, length] into weights for values there.
void weigh_slopes(double length, std::span<double> weight);

}  // namespace rollcon::halfspace
