#include "bodies/halfspace/hat_rules.hpp"

#include <cmath>
#include <cstddef>

namespace rollcon::halfspace {
namespace {

/// Holds orthonormal polynomials of an even weight: x p[k] = b[k + 1] p[k + 1] + b[k] p[k - 1].
struct Recurrence {
  double b[max_hat_points + 1] = {};

  /// Computes values of p[0] to p[n] at x, and the derivative of the last.
  double values(double x, int n, double* p) const {
    double slope = 0, slope_before = 0;
    p[0] = 1;  // the weight integrates to 1
    for (int k = 0; k < n; ++k) {
      const double before = k > 0 ? b[k] * p[k - 1] : 0;
      const double next_slope = (p[k] + x * slope - (k > 0 ? b[k] * slope_before : 0)) / b[k + 1];
      p[k + 1] = (x * p[k] - before) / b[k + 1];
      slope_before = slope;
      slope = next_slope;
    }
    return slope;
  }
};

/// Stieltjes' procedure: inner products of the hat by a rule that is exact for all of them.
Recurrence hat_polynomials() {
  const LineRule half = gauss_legendre(max_hat_points + 2);
  Recurrence r;
  double p[max_hat_points + 1];
  for (int k = 0; k < max_hat_points; ++k) {
    // b[k + 1] is the norm of x p[k] - b[k] p[k - 1]; twice the half x > 0, by evenness.
    double square = 0;
    for (std::size_t q = 0; q < half.x.size(); ++q) {
      const double x = (1 + half.x[q]) / 2;
      r.values(x, k, p);
      const double rest = x * p[k] - (k > 0 ? r.b[k] * p[k - 1] : 0);
      square += half.w[q] * (1 - x) * rest * rest;
    }
    r.b[k + 1] = std::sqrt(square);
  }
  return r;
}

LineRule whole_rule(int n) {
  const Recurrence r = hat_polynomials();
  double p[max_hat_points + 1];
  // Zeros of p[k] lie between those of p[k - 1]: bisection, then Newton.
  std::vector<double> zero;
  for (int k = 1; k <= n; ++k) {
    std::vector<double> next;
    for (int i = 0; i < k; ++i) {
      double low = i == 0 ? -1 : zero[static_cast<std::size_t>(i) - 1];
      double high = i == k - 1 ? 1 : zero[static_cast<std::size_t>(i)];
      r.values(low, k, p);
      const bool negative = p[k] < 0;
      for (int step = 0; step < 20; ++step) {
        const double middle = (low + high) / 2;
        r.values(middle, k, p);
        ((p[k] < 0) == negative ? low : high) = middle;
      }
      double x = (low + high) / 2;
      for (int step = 0; step < 4; ++step) {
        const double slope = r.values(x, k, p);
        x -= p[k] / slope;
      }
      next.push_back(x);
    }
    zero = next;
  }
  LineRule rule;
  for (const double x : zero) {
    r.values(x, n, p);
    double sum = 0;
    for (int k = 0; k < n; ++k) sum += p[k] * p[k];
    rule.x.push_back(x);
    rule.w.push_back(1 / sum);
  }
  // Rules are exactly even, so that mirrored offsets have mirrored integrals.
  for (std::size_t i = 0, j = zero.size() - 1; i <= j && j < zero.size(); ++i, --j) {
    const double x = (rule.x[j] - rule.x[i]) / 2, w = (rule.w[i] + rule.w[j]) / 2;
    rule.x[i] = -x, rule.x[j] = x;
    rule.w[i] = rule.w[j] = w;
  }
  return rule;
}

}  // namespace

LineRule hat_rule(Hat hat, int n) {
  if (hat == Hat::whole) return whole_rule(n);
  const LineRule jacobi = gauss_jacobi(n, 1);  // weight 1 - x on [-1, 1]
  LineRule rule;
  const auto count = static_cast<std::size_t>(n);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t q = hat == Hat::after ? i : count - 1 - i;
    const double x = (1 + jacobi.x[q]) / 2;
    rule.x.push_back(hat == Hat::after ? x : -x);
    rule.w.push_back(jacobi.w[q] / 4);
  }
  return rule;
}

}  // namespace rollcon::halfspace
