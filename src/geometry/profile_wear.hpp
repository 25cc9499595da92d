#pragma once
/// Wear along a profile's points: from volumes to depths, smoothing that keeps volume, and the worn profile.

#include <span>
#include <vector>

#include "geometry/vec2.hpp"

namespace rollcon {

/// Integrals of the functions that are 1 at s[j], 0 at the others and linear between, over s ascending. One point: 1.
std::vector<double> shares_of_length(std::span<const double> s);

/// Lengths along the lines from point to point.
std::vector<double> lengths_along(std::span<const Vec2> point);

/// In place: (M + (length / 2 pi)^2 K) w' = M w, M diagonal with shares_of_length, K of the squared derivative. The
/// integral sum of M w stays, no value gets beyond the least and greatest, waves of this length keep one half.
void smooth_keeping_volume(std::span<const double> s, double length, std::vector<double>& value);

/// Where a wearing profile stands after a step.
struct WornProfile {
  std::vector<Vec2> point;
  double taken = 0;  ///< of the distance
};

/// Moves each point by taken * rate along the normal, side: 1 towards greater z, -1 towards lesser, the rate smoothed
/// before. taken: the distance, or less where most_depth (> 0) would be passed anywhere.
WornProfile wear_profile(std::span<const Vec2> point, std::vector<double> rate, double side, double distance,
                         double most_depth, double smoothing);

}  // namespace rollcon
