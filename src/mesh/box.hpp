#pragma once
/// Represents a box along the axes around points.

#include <algorithm>
#include <limits>

#include "mesh/vec3.hpp"

namespace rollcon {

struct Box {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec3 low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};

  void add(const Vec3& x) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], x[k]);
      high[k] = std::max(high[k], x[k]);
    }
  }
  void add(const Box& b) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], b.low[k]);
      high[k] = std::max(high[k], b.high[k]);
    }
  }
  bool holds(const Vec3& x) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (x[k] < low[k] || x[k] > high[k]) return false;
    return true;
  }
  Vec3 size() const { return high - low; }
  double longest() const { return std::max({size()[0], size()[1], size()[2]}); }
};

/// Returns the box around points[k] for all k.
template <class Points, class Numbers>
Box box_of(const Points& point, const Numbers& numbers) {
  Box box;
  for (const auto k : numbers) box.add(point[static_cast<std::size_t>(k)]);
  return box;
}
template <class Points>
Box box_of(const Points& point) {
  Box box;
  for (const Vec3& x : point) box.add(x);
  return box;
}

}  // namespace rollcon
