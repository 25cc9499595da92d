#pragma once
/// Interpolates values given at points, linearly between them and constant beyond.

#include <algorithm>
#include <cstddef>
#include <span>

namespace rollcon {

/// Takes at least one point, in ascending order, and as many values.
inline double linear_between(std::span<const double> point, std::span<const double> value, double at) {
  const auto next = std::upper_bound(point.begin(), point.end(), at);
  if (next == point.begin()) return value.front();
  if (next == point.end()) return value.back();
  const auto i = static_cast<std::size_t>(next - point.begin());
  const double part = (at - point[i - 1]) / (point[i] - point[i - 1]);
  return (1 - part) * value[i - 1] + part * value[i];
}

/// Returns the slope of linear_between(), to the right where it jumps.
inline double slope_between(std::span<const double> point, std::span<const double> value, double at) {
  const auto next = std::upper_bound(point.begin(), point.end(), at);
  if (next == point.begin() || next == point.end()) return 0;
  const auto i = static_cast<std::size_t>(next - point.begin());
  return (value[i] - value[i - 1]) / (point[i] - point[i - 1]);
}

}  // namespace rollcon
