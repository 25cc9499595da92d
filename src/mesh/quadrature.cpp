#include "mesh/quadrature.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace rollcon {
namespace {

struct Polynomial {
  double value, slope;
};

/// Evaluates the Jacobi polynomial P_n^(a,0) and its derivative by the three-term recurrence; |x| < 1.
Polynomial jacobi(int n, double a, double x) {
  double before = 1, value = (a + 1) + 0.5 * (a + 2) * (x - 1);
  for (int k = 2; k <= n; ++k) {
    const double c = 2 * k + a;
    const double next = ((c - 1) * (c * (c - 2) * x + a * a) * value - 2 * (k + a - 1) * (k - 1) * c * before) /
                        (2 * k * (k + a) * (c - 2));
    before = value;
    value = next;
  }
  const double c = 2 * n + a;
  return {value, (n * (a - c * x) * value + 2 * n * (n + a) * before) / (c * (1 - x * x))};
}

}  // namespace

LineRule gauss_jacobi(int n, double alpha) {
  LineRule rule;
  for (int k = 0; k < n; ++k) {
    double x = -std::cos((2 * k + 1) * std::numbers::pi / (2 * n));
    if (k > 0) x = 0.5 * (x + rule.x.back());
    for (int iteration = 0; iteration < 100; ++iteration) {
      const Polynomial p = jacobi(n, alpha, x);
      double found = 0;  // deflation: zeros already found repel
      for (double z : rule.x) found += 1 / (x - z);
      const double step = p.value / (p.slope - found * p.value);
      x -= step;
      if (std::abs(step) < 4e-16) break;
    }
    const double slope = jacobi(n, alpha, x).slope;
    rule.x.push_back(x);
    rule.w.push_back(std::pow(2, alpha + 1) / ((1 - x * x) * slope * slope));
  }
  return rule;
}

PlaneRule triangle_rule(int degree) {
  const int n = degree / 2 + 1;
  const LineRule along = gauss_legendre(n), towards = gauss_jacobi(n, 1);
  PlaneRule rule;
  for (std::size_t i = 0; i < towards.x.size(); ++i)
    for (std::size_t j = 0; j < along.x.size(); ++j) {
      // The Jacobian (1 - u)/8 is Gauss-Jacobi's weight with xi = (1 + u)/2, eta = (1 - xi)(1 + v)/2.
      const double xi = 0.5 * (1 + towards.x[i]);
      rule.xi.push_back(xi);
      rule.eta.push_back(0.25 * (1 - towards.x[i]) * (1 + along.x[j]));
      rule.w.push_back(towards.w[i] * along.w[j] / 8);
    }
  return rule;
}

PlaneRule product_rule(const LineRule& xi, const LineRule& eta) {
  PlaneRule rule;
  for (std::size_t i = 0; i < xi.x.size(); ++i)
    for (std::size_t j = 0; j < eta.x.size(); ++j) {
      rule.xi.push_back(xi.x[i]);
      rule.eta.push_back(eta.x[j]);
      rule.w.push_back(xi.w[i] * eta.w[j]);
    }
  return rule;
}

PlaneRule square_rule(int degree) {
  const LineRule line = gauss_legendre(degree / 2 + 1);
  return product_rule(line, line);
}

}  // namespace rollcon
