#pragma once
/// Defines vectors and rotations in space, by rows.

#include <array>
#include <cmath>

namespace capi_test {

using Vector = std::array<double, 3>;
using Matrix = std::array<double, 9>;

inline Vector operator*(const Matrix& q, const Vector& v) {
  Vector r{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) r[i] += q[3 * i + j] * v[j];
  return r;
}

/// Returns the turn by an angle about an axis of any length.
inline Matrix turned(Vector a, double angle) {
  const double l = std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]), c = std::cos(angle), s = std::sin(angle);
  for (double& x : a) x /= l;
  Matrix q{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) q[3 * i + j] = (1 - c) * a[i] * a[j] + (i == j ? c : 0);
  q[1] -= s * a[2];
  q[3] += s * a[2];
  q[2] += s * a[1];
  q[6] -= s * a[1];
  q[5] -= s * a[0];
  q[7] += s * a[0];
  return q;
}

inline Matrix operator*(const Matrix& p, const Matrix& q) {
  Matrix r{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) r[3 * i + j] += p[3 * i + k] * q[3 * k + j];
  return r;
}

inline Vector operator+(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vector operator*(double f, const Vector& v) {
  return {f * v[0], f * v[1], f * v[2]};
}
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace capi_test
