#pragma once
/// Solves linear systems of few unknowns.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace rollcon {

/// Finds x of a x = b for the leading count unknowns by elimination with pivots; returns false if a is singular.
template <std::size_t N>
bool solve_few(std::size_t count, std::array<std::array<double, N>, N> a, std::array<double, N> b,
               std::array<double, N>& x) {
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t pivot = i;
    for (std::size_t r = i + 1; r < count; ++r)
      if (std::abs(a[r][i]) > std::abs(a[pivot][i])) pivot = r;
    if (!(std::abs(a[pivot][i]) > 0)) return false;
    std::swap(a[i], a[pivot]);
    std::swap(b[i], b[pivot]);
    for (std::size_t r = i + 1; r < count; ++r) {
      const double factor = a[r][i] / a[i][i];
      for (std::size_t c = i; c < count; ++c) a[r][c] -= factor * a[i][c];
      b[r] -= factor * b[i];
    }
  }
  x = {};
  double square = 0;
  for (std::size_t i = count; i-- > 0;) {
    double sum = b[i];
    for (std::size_t c = i + 1; c < count; ++c) sum -= a[i][c] * x[c];
    x[i] = sum / a[i][i];
    square += x[i] * x[i];
  }
  return std::isfinite(square);
}

}  // namespace rollcon
