#pragma once
/// Solves linear systems of a few unknowns.

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace rollcon {

/// Solves the leading n of N equations, whose right sides stand in the last columns, by elimination with pivots; the
/// solutions replace the right sides. Returns false where a pivot is least or below, or a solution is not finite.
template <std::size_t N, std::size_t columns>
bool solve_small(std::size_t n, std::array<std::array<double, columns>, N>& a, double least = 0) {
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t pivot = i;
    for (std::size_t r = i + 1; r < n; ++r)
      if (std::abs(a[r][i]) > std::abs(a[pivot][i])) pivot = r;
    if (!(std::abs(a[pivot][i]) > least)) return false;
    std::swap(a[i], a[pivot]);
    for (std::size_t r = 0; r < n; ++r) {
      if (r == i) continue;
      const double factor = a[r][i] / a[i][i];
      for (std::size_t j = i; j < columns; ++j) a[r][j] -= factor * a[i][j];
    }
  }
  double square = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = N; j < columns; ++j) a[i][j] /= a[i][i], square += a[i][j] * a[i][j];
  return std::isfinite(square);
}

/// Finds x of a x = b for the leading n unknowns; the others become 0.
template <std::size_t N>
bool solve_small(std::size_t n, const std::array<std::array<double, N>, N>& a, const std::array<double, N>& b,
                 std::array<double, N>& x) {
  std::array<std::array<double, N + 1>, N> system{};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) system[i][j] = a[i][j];
    system[i][N] = b[i];
  }
  x = {};
  const bool solved = solve_small(n, system);
  for (std::size_t i = 0; solved && i < n; ++i) x[i] = system[i][N];
  return solved;
}

}  // namespace rollcon
