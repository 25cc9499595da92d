#pragma once
/// Finds a root of a function by false position (the Illinois rule): no slopes, and a bracket throughout.

#include <algorithm>
#include <cmath>

namespace rollcon {

/// Returns the last s that was tried between a and b, at which the function's values have different signs; value(s)
/// returns the function's; the search ends where done(value) or where nothing is left between both ends.
template <class Value, class Done>
double false_position(double a, double value_a, double b, double value_b, Value value, Done done) {
  constexpr int most = 200, stubborn = 4;
  int kept = 0;  // how often in turn the same end stayed
  double s = a;
  for (int i = 0; i < most; ++i) {
    s = (value_a * b - value_b * a) / (value_a - value_b);
    if (kept >= stubborn || !(s > std::min(a, b) && s < std::max(a, b))) s = (a + b) / 2;
    if (s == a || s == b) return s;
    const double f = value(s);
    if (f == 0 || done(f)) return s;
    const bool same = (f < 0) == (value_b < 0);
    if (!same) {  // the root is between s and b: b stays
      std::swap(a, b);
      std::swap(value_a, value_b);
      kept = 0;
    } else {
      if (kept > 0) value_a /= 2;
      ++kept;
    }
    b = s;
    value_b = f;
  }
  return s;
}

}  // namespace rollcon
