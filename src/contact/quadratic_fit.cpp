#include "contact/quadratic_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace rollcon {

QuadraticFit::Coefficients QuadraticFit::monomials(double x, double y) const {
  const double u = (x - x_) / rx_, v = (y - y_) / ry_;
  return {1, u, v, u * u, u * v, v * v};
}

// The normal equations by elimination with pivoting.
bool QuadraticFit::solve(std::array<std::array<double, terms + 1>, terms>& a, Coefficients& c) {
  constexpr double least_pivot = 1e-10;
  for (std::size_t i = 0; i < terms; ++i) {
    std::size_t pivot = i;
    for (std::size_t r = i + 1; r < terms; ++r)
      if (std::abs(a[r][i]) > std::abs(a[pivot][i])) pivot = r;
    std::swap(a[i], a[pivot]);
    if (!(std::abs(a[i][i]) > least_pivot)) return false;
    for (std::size_t r = i + 1; r < terms; ++r) {
      const double factor = a[r][i] / a[i][i];
      for (std::size_t j = i; j <= terms; ++j) a[r][j] -= factor * a[i][j];
    }
  }
  for (std::size_t i = terms; i-- > 0;) {
    c[i] = a[i][terms];
    for (std::size_t j = i + 1; j < terms; ++j) c[i] -= a[i][j] * c[j];
    c[i] /= a[i][i];
  }
  return true;
}

bool QuadraticFit::fit(const Frame& frame, std::span<const std::int32_t> nodes, double x, double y,
                       const std::vector<double>& value) {
  x_ = x;
  y_ = y;
  rx_ = ry_ = 0;
  for (const std::int32_t k : nodes) {
    rx_ = std::max(rx_, std::abs(frame.x[static_cast<std::size_t>(k)] - x));
    ry_ = std::max(ry_, std::abs(frame.y[static_cast<std::size_t>(k)] - y));
  }
  if (!(rx_ > 0) || !(ry_ > 0)) return false;
  std::array<std::array<double, terms + 1>, terms> normal{};
  for (const std::int32_t node : nodes) {
    const auto k = static_cast<std::size_t>(node);
    const Coefficients m = monomials(frame.x[k], frame.y[k]);
    for (std::size_t i = 0; i < terms; ++i) {
      for (std::size_t j = 0; j < terms; ++j) normal[i][j] += m[i] * m[j];
      normal[i][terms] += m[i] * value[k];
    }
  }
  return solve(normal, c_);
}

double QuadraticFit::at(double x, double y) const {
  const Coefficients m = monomials(x, y);
  return std::inner_product(m.begin(), m.end(), c_.begin(), 0.0);
}

double QuadraticFit::curvature(double dx, double dy) const {
  const double u = dx / rx_, v = dy / ry_;
  return 2 * (c_[3] * u * u + c_[4] * u * v + c_[5] * v * v);
}

}  // namespace rollcon
