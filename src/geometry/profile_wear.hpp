#pragma once
/// Wears a profile's points: turns volumes into depths, smooths them keeping the volume, and makes the worn profile.

#include <span>
#include <vector>

#include "geometry/vec2.hpp"

namespace rollcon {

/// Integrates the functions that are 1 at s[j], 0 at the others and linear between, over ascending s. A single point
/// gets 1.
std::vector<double> shares_of_length(std::span<const double> s);

/// Returns the lengths along the lines from point to point.
std::vector<double> lengths_along(std::span<const Vec2> point);

/// Smooths in place: (M + (length / 2 pi)^2 K) w' = M w, with M the diagonal of shares_of_length and K from the squared
/// derivative. The integral sum of M w is kept, no value passes the least and greatest, and waves of this length keep
/// one half.
void smooth_keeping_volume(std::span<const double> s, double length, std::vector<double>& value);

/// Says where a wearing profile stands after a step.
struct WornProfile {
  std::vector<Vec2> point;
  double taken = 0;  ///< part of the distance that was taken
};

/// Moves each point by taken * rate along the normal, towards greater z if side is 1 and lesser if it is -1, the rate
/// smoothed before. Takes the whole distance, or less where most_depth (> 0) would be passed anywhere.
WornProfile wear_profile(std::span<const Vec2> point, std::vector<double> rate, double side, double distance,
                         double most_depth, double smoothing);

}  // namespace rollcon
