#pragma once
/// Reads peak pressure and semi-axes off a discrete pressure: Hertz's form says that p^2 is the linear function p0^2 (1
/// - x^2/a^2 - y^2/b^2) of x^2 and y^2, so a least-squares fit over the loaded nodes, each weighted by its p (which
/// leaves the ragged edge little say), gives p0, a, b.

#include <array>
#include <cmath>

#include "support/scene.hpp"

namespace rollcon::scenes {

struct FittedEllipse {
  double p0 = 0, a = 0, b = 0;
};

/// Takes rough semi-axes a, b, for scaling only.
inline FittedEllipse fit_hertz(const Solution& s, double a, double b) {
  double m[3][4] = {};
  for (std::size_t k = 0; k < s.nodes(); ++k) {
    const double p = s.pressure[k];
    if (p <= 0) continue;
    const std::array<double, 3> row = {1, s.x[k] * s.x[k] / (a * a), s.y[k] * s.y[k] / (b * b)};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) m[i][j] += p * row[i] * row[j];
      m[i][3] += p * row[i] * p * p;
    }
  }
  for (int i = 0; i < 3; ++i)  // Gauss-Jordan; the matrix is positive definite
    for (int r = 0; r < 3; ++r) {
      if (r == i) continue;
      const double factor = m[r][i] / m[i][i];
      for (int j = i; j < 4; ++j) m[r][j] -= factor * m[i][j];
    }
  const double c0 = m[0][3] / m[0][0], cx = m[1][3] / m[1][1], cy = m[2][3] / m[2][2];
  return {std::sqrt(c0), a * std::sqrt(-c0 / cx), b * std::sqrt(-c0 / cy)};
}

}  // namespace rollcon::scenes
