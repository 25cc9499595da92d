#include "mesh/quadratic_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "support/small_system.hpp"

namespace rollcon {
namespace {

constexpr std::size_t terms = Quadratic::terms;
using Coefficients = std::array<double, terms>;

/// Holds the normal equations of a fit, and right sides beside them.
template <std::size_t sides>
using System = std::array<std::array<double, terms + sides>, terms>;

constexpr double least_pivot = 1e-10;  // below it, points do not determine a quadratic polynomial

/// Centres at (x0, y0) and scales by the largest distances from there; none where the points are on one line along an
/// axis.
std::optional<Quadratic> scaled(double x0, double y0, std::span<const double> x, std::span<const double> y) {
  Quadratic q{.x0 = x0, .y0 = y0, .rx = 0, .ry = 0, .c = {}};
  for (std::size_t k = 0; k < x.size(); ++k) {
    q.rx = std::max(q.rx, std::abs(x[k] - x0));
    q.ry = std::max(q.ry, std::abs(y[k] - y0));
  }
  if (!(q.rx > 0) || !(q.ry > 0)) return std::nullopt;
  return q;
}

}  // namespace

Coefficients Quadratic::monomials(double x, double y) const {
  const double u = (x - x0) / rx, v = (y - y0) / ry;
  return {1, u, v, u * u, u * v, v * v};
}

double Quadratic::operator()(double x, double y) const {
  const Coefficients m = monomials(x, y);
  return std::inner_product(m.begin(), m.end(), c.begin(), 0.0);
}

// The mean of the values is subtracted, because it may be large beside what they differ by.
std::optional<Quadratic> fit_quadratic(double x0, double y0, std::span<const double> x, std::span<const double> y,
                                       std::span<const double> value) {
  std::optional<Quadratic> q = scaled(x0, y0, x, y);
  if (!q) return q;
  const double mean = std::accumulate(value.begin(), value.end(), 0.0) / static_cast<double>(value.size());
  System<1> a{};
  for (std::size_t k = 0; k < x.size(); ++k) {
    const Coefficients m = q->monomials(x[k], y[k]);
    for (std::size_t i = 0; i < terms; ++i) {
      for (std::size_t j = 0; j < terms; ++j) a[i][j] += m[i] * m[j];
      a[i][terms] += m[i] * (value[k] - mean);
    }
  }
  if (!solve_small(terms, a, least_pivot)) return std::nullopt;
  for (std::size_t i = 0; i < terms; ++i) q->c[i] = a[i][terms];
  q->c[0] += mean;
  return q;
}

// The normal matrix is symmetric: rows of its inverse are columns.
std::vector<std::array<double, 3>> curvature_weights(std::span<const double> x, std::span<const double> y) {
  std::vector<std::array<double, 3>> weight;
  if (x.size() < terms) return weight;
  const auto mean = [](std::span<const double> v) {
    return std::accumulate(v.begin(), v.end(), 0.0) / static_cast<double>(v.size());
  };
  const std::optional<Quadratic> q = scaled(mean(x), mean(y), x, y);
  if (!q) return weight;
  System<3> a{};
  for (std::size_t k = 0; k < x.size(); ++k) {
    const Coefficients m = q->monomials(x[k], y[k]);
    for (std::size_t i = 0; i < terms; ++i)
      for (std::size_t j = 0; j < terms; ++j) a[i][j] += m[i] * m[j];
  }
  for (std::size_t d = 0; d < 3; ++d) a[3 + d][terms + d] = 1;
  if (!solve_small(terms, a, least_pivot)) return weight;
  const double per[3] = {2 / (q->rx * q->rx), 1 / (q->rx * q->ry), 2 / (q->ry * q->ry)};
  for (std::size_t k = 0; k < x.size(); ++k) {
    const Coefficients m = q->monomials(x[k], y[k]);
    std::array<double, 3>& w = weight.emplace_back();
    for (std::size_t d = 0; d < 3; ++d)
      for (std::size_t i = 0; i < terms; ++i) w[d] += per[d] * a[i][terms + d] * m[i];
  }
  return weight;
}

}  // namespace rollcon
