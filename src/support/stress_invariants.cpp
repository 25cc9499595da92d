#include "support/stress_invariants.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace rollcon {
namespace {

constexpr int sweeps = 12;  ///< convergence is quadratic: six suffice in practice

/// Applies Jacobi's rotation that makes a[p][q] zero.
void rotate(double (&a)[3][3], int p, int q) {
  if (a[p][q] == 0) return;
  const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
  const double t = (theta < 0 ? -1 : 1) / (std::abs(theta) + std::hypot(theta, 1.0));
  const double c = 1 / std::hypot(t, 1.0), s = t * c;
  const int r = 3 - p - q;
  const double off = a[p][q], rp = a[r][p], rq = a[r][q];
  a[p][p] -= t * off;
  a[q][q] += t * off;
  a[p][q] = a[q][p] = 0;
  a[r][p] = a[p][r] = c * rp - s * rq;
  a[r][q] = a[q][r] = s * rp + c * rq;
}

}  // namespace

StressInvariants stress_invariants(const double* stress) {
  StressInvariants out{};
  double scale = 0;
  for (int i = 0; i < 6; ++i) scale = std::max(scale, std::abs(stress[i]));
  if (!(scale > 0)) return out;
  double s[6];
  for (int i = 0; i < 6; ++i) s[i] = stress[i] / scale;
  double a[3][3] = {{s[0], s[3], s[4]}, {s[3], s[1], s[5]}, {s[4], s[5], s[2]}};
  for (int k = 0; k < sweeps && std::max({std::abs(a[0][1]), std::abs(a[0][2]), std::abs(a[1][2])}) > 0; ++k) {
    rotate(a, 0, 1);
    rotate(a, 0, 2);
    rotate(a, 1, 2);
  }
  for (int i = 0; i < 3; ++i) out.principal[i] = scale * a[i][i];
  std::sort(out.principal, out.principal + 3, std::greater<>());
  const double x = s[0] - s[1], y = s[1] - s[2], z = s[2] - s[0];
  out.von_mises = scale * std::sqrt(0.5 * (x * x + y * y + z * z) + 3 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
  out.shear = 0.5 * (out.principal[0] - out.principal[2]);
  return out;
}

}  // namespace rollcon
