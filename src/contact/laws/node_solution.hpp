#pragma once
/// Coulomb's law solved at one node whose slip is linear in its own tractions.

#include <algorithm>
#include <array>
#include <cmath>

namespace rollcon {

/// Slip (over speed) of a node per unit of its own tangential tractions.
struct NodeResponse {
  double b[2][2];
};

/// Tractions that satisfy the law with the given bound > 0: no slip, or slip against the traction,
/// which is then at the bound. slip: with the tractions `old`. A response that is not positive (a
/// node at the rim where material leaves, under the characteristic scheme) allows several; the one
/// taken slides.
inline std::array<double, 2> solve_node(const NodeResponse& response, std::array<double, 2> slip,
                                        std::array<double, 2> old, double bound) {
  const auto& b = response.b;
  const double s1 = slip[0] - b[0][0] * old[0] - b[0][1] * old[1];
  const double s2 = slip[1] - b[1][0] * old[0] - b[1][1] * old[1];
  // (B + g I) t = -s: what is left of slip is -g t. |t| falls as g grows, from where B + g I is
  // positive.
  const auto with = [&](double g) {
    const double d1 = b[0][0] + g, d2 = b[1][1] + g, det = d1 * d2 - b[0][1] * b[1][0];
    return std::array<double, 2>{-(d2 * s1 - b[0][1] * s2) / det, -(d1 * s2 - b[1][0] * s1) / det};
  };
  const auto length = [](const std::array<double, 2>& t) { return std::hypot(t[0], t[1]); };
  const double least =
      0.5 * (b[0][0] + b[1][1]) - 0.5 * std::hypot(b[0][0] - b[1][1], b[0][1] + b[1][0]);
  std::array<double, 2> t = old;
  if (least > 0) {
    t = with(0);
    if (length(t) <= bound) return t;
  }
  double low = std::max(0.0, -least), high = low + std::hypot(s1, s2) / bound;
  for (int i = 0; i < 60 && high - low > 1e-12 * high; ++i) {
    const double g = 0.5 * (low + high);
    t = with(g);
    (length(t) > bound ? low : high) = g;
  }
  const double found = length(t);
  return found > 0 && std::isfinite(found)
             ? std::array<double, 2>{bound * t[0] / found, bound * t[1] / found}
             : old;
}

}  // namespace rollcon
