#include "tables/table_grid.hpp"

#include <algorithm>
#include <cmath>

#include "support/index.hpp"

namespace rollcon {
namespace {

/// Adds `factor` times the slope at plane k, of the parabola through three planes, as weights of planes from `first`.
void add_slope(const std::vector<double>& x, std::int64_t k, double factor, std::int64_t first, double* weight) {
  const auto n = static_cast<std::int64_t>(x.size());
  const std::int64_t from = std::clamp<std::int64_t>(k - 1, 0, n - 3);
  for (std::int64_t i = from; i < from + 3; ++i) {
    // The sum is the derivative of Lagrange's polynomial of i at plane k.
    double sum = 0;
    for (std::int64_t m = from; m < from + 3; ++m) {
      if (m == i) continue;
      double product = 1 / (x[at(i)] - x[at(m)]);
      for (std::int64_t l = from; l < from + 3; ++l)
        if (l != i && l != m) product *= (x[at(k)] - x[at(l)]) / (x[at(i)] - x[at(l)]);
      sum += product;
    }
    weight[i - first] += factor * sum;
  }
}

}  // namespace

double UnlikePair::mean_poisson() const {
  return (flexibility[0] * poisson[0] + flexibility[1] * poisson[1]) / (flexibility[0] + flexibility[1]);
}

double UnlikePair::strained() const {
  return ((1 - 2 * poisson[0]) * flexibility[0] - (1 - 2 * poisson[1]) * flexibility[1]) / 2;
}

double TableGrid::stretch(double log_ratio) const {
  return std::exp(stretched * log_ratio);
}

double TableGrid::spin_scale(double log_ratio) const {
  return std::pow(std::cosh(log_ratio), 0.5 - stretched);
}

// Two hundredths change forces by 0.6 % of mu Fn; extrapolated by twice as much, these are as exact as those between.
double TableGrid::beyond() const {
  constexpr double widths = 2, most = 0.04;
  return poisson.size() == 2 ? std::min({most, widths * (poisson[1] - poisson[0]), 0.5 - poisson[1]}) : 0;
}

PlaneWeights plane_weights(const std::vector<double>& x, double where) {
  PlaneWeights w;
  const auto n = static_cast<std::int64_t>(x.size());
  if (n == 1) return w;
  std::int64_t k = 0;  // between planes k and k + 1
  while (k + 2 < n && x[at(k + 1)] < where) ++k;
  const double width = x[at(k + 1)] - x[at(k)], part = (where - x[at(k)]) / width, t = std::clamp(part, 0.0, 1.0);
  if (n == 2) {
    w.count = 2;
    w.value[0] = 1 - part, w.value[1] = part;
    w.slope[0] = -1 / width, w.slope[1] = 1 / width;
    return w;
  }
  w.first = std::clamp<std::int64_t>(k - 1, 0, n - 3);
  w.count = std::min<std::int64_t>(k + 3, n) - w.first;
  w.value[0] = 0;
  // Hermite's cubics and their derivatives by x weigh both planes.
  const double rise = t * t * (3 - 2 * t), rise_x = 6 * t * (1 - t) / width;
  w.value[k - w.first] += 1 - rise, w.value[k + 1 - w.first] += rise;
  w.slope[k - w.first] -= rise_x, w.slope[k + 1 - w.first] += rise_x;
  add_slope(x, k, width * t * (1 - t) * (1 - t), w.first, w.value);
  add_slope(x, k + 1, width * t * t * (t - 1), w.first, w.value);
  add_slope(x, k, (1 - t) * (1 - 3 * t), w.first, w.slope);
  add_slope(x, k + 1, t * (3 * t - 2), w.first, w.slope);
  return w;
}

}  // namespace rollcon
