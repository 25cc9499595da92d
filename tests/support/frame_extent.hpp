#pragma once
/// Returns the middle and half widths of a frame.

#include <algorithm>

#include "mesh/frame.hpp"

namespace rollcon {

struct Extent {
  double x0, y0, half_x, half_y;
  explicit Extent(const Frame& f) {
    const auto [xl, xh] = std::minmax_element(f.x.begin(), f.x.end());
    const auto [yl, yh] = std::minmax_element(f.y.begin(), f.y.end());
    x0 = 0.5 * (*xl + *xh);
    y0 = 0.5 * (*yl + *yh);
    half_x = 0.5 * (*xh - *xl);
    half_y = 0.5 * (*yh - *yl);
  }
};

}  // namespace rollcon
