#pragma once
/// Solves a node whose slip is linear in its tractions under a bound.

#include <array>
#include <cmath>

#include "contact/laws/friction_law.hpp"

namespace rollcon {

/// Returns t with B t = -s, or with (B + g I) t = -s and |t| = bound: what is left of slip is -g t. |t| falls as g
/// grows, from where B + g I is positive. A response that is not positive (a node at the rim where material leaves,
/// under the characteristic scheme) allows several tractions, of which one that slides is taken; else `old`.
inline std::array<double, 2> solve_on_disk(const NodeResponse& response, double s1, double s2, double bound,
                                           std::array<double, 2> old) {
  if (!(bound > 0)) return {0, 0};
  const auto& b = response.b;
  const auto with = [&](double g) {
    const double d1 = b[0][0] + g, d2 = b[1][1] + g, det = d1 * d2 - b[0][1] * b[1][0];
    return std::array<double, 2>{-(d2 * s1 - b[0][1] * s2) / det, -(d1 * s2 - b[1][0] * s1) / det};
  };
  const auto length = [](const std::array<double, 2>& t) { return std::hypot(t[0], t[1]); };
  const double least = 0.5 * (b[0][0] + b[1][1]) - 0.5 * std::hypot(b[0][0] - b[1][1], b[0][1] + b[1][0]);
  std::array<double, 2> t = old;
  if (least > 0) {
    t = with(0);
    if (length(t) <= bound) return t;
  }
  double low = least > 0 ? 0 : -least, high = low + std::hypot(s1, s2) / bound;
  for (int i = 0; i < 60 && high - low > 1e-12 * high; ++i) {
    const double g = 0.5 * (low + high);
    t = with(g);
    (length(t) > bound ? low : high) = g;
  }
  const double found = length(t);
  return found > 0 && std::isfinite(found) ? std::array<double, 2>{bound * t[0] / found, bound * t[1] / found} : old;
}

}  // namespace rollcon
