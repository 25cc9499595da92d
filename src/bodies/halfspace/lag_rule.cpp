#include "bodies/halfspace/lag_rule.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "mesh/quadrature.hpp"

namespace rollcon::halfspace {
namespace {

constexpr std::size_t most_points = 16;

/// Returns the weight of point q of n in the barycentric form of Lagrange's polynomials.
double barycentric(std::size_t q, std::size_t n) {
  return (q % 2 == 0 ? 1 : -1) * (q == 0 || q + 1 == n ? 0.5 : 1);
}

}  // namespace

const std::vector<double>& lag_points(int n) {
  static const std::array<std::vector<double>, most_points + 1> points = [] {
    std::array<std::vector<double>, most_points + 1> all;
    for (std::size_t m = 2; m <= most_points; ++m)
      for (std::size_t k = 0; k < m; ++k) {
        // The sine of half the angle keeps the digits of small points.
        const double s = std::sin(0.5 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(m - 1));
        all[m].push_back(k + 1 == m ? 1 : s * s);
      }
    return all;
  }();
  return points[static_cast<std::size_t>(n)];
}

void lag_weights(double rate, std::span<double> weight) {
  constexpr int order = 40;
  constexpr double forgotten = 40;
  static const LineRule gauss = gauss_legendre(order);
  const std::vector<double>& point = lag_points(static_cast<int>(weight.size()));
  const double length = std::min(1.0, forgotten / rate);
  std::fill(weight.begin(), weight.end(), 0.0);
  std::array<double, most_points> share{};
  for (std::size_t g = 0; g < gauss.x.size(); ++g) {
    const double t = 0.5 * length * (1 + gauss.x[g]);
    const double value = 0.5 * length * gauss.w[g] * rate * std::exp(-rate * t);
    // The barycentric form gives Lagrange's polynomials at t.
    double sum = 0;
    for (std::size_t q = 0; q < point.size(); ++q) {
      const double apart = t - point[q];
      share[q] = barycentric(q, point.size()) / (apart != 0 ? apart : 1e-300);
      sum += share[q];
    }
    for (std::size_t q = 0; q < point.size(); ++q) weight[q] += value * share[q] / sum;
  }
}

void weigh_slopes(double length, std::span<double> weight) {
  const std::size_t n = weight.size();
  const std::vector<double>& point = lag_points(static_cast<int>(n));
  std::array<double, most_points> of_value{};
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      if (i == j) continue;
      const double d = weight[i] * barycentric(j, n) / barycentric(i, n) / (point[i] - point[j]);
      of_value[j] += d;
      of_value[i] -= d;
    }
  for (std::size_t q = 0; q < n; ++q) weight[q] = of_value[q] / length;
}

}  // namespace rollcon::halfspace
