#pragma once
#include <cmath>

#include "result.hpp"

namespace cntc {

inline Vec3 operator+(const Vec3& a, const Vec3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vec3 operator-(const Vec3& a, const Vec3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vec3 operator*(double f, const Vec3& a) {
  return {f * a[0], f * a[1], f * a[2]};
}
inline double dot(const Vec3& a, const Vec3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double norm(const Vec3& a) {
  return std::sqrt(dot(a, a));
}
inline Vec3 operator*(const Mat3& m, const Vec3& v) {
  return {dot(m[0], v), dot(m[1], v), dot(m[2], v)};
}
inline Mat3 transposed(const Mat3& m) {
  return {Vec3{m[0][0], m[1][0], m[2][0]}, Vec3{m[0][1], m[1][1], m[2][1]}, Vec3{m[0][2], m[1][2], m[2][2]}};
}
inline Mat3 operator*(const Mat3& a, const Mat3& b) {
  const Mat3 t = transposed(b);
  Mat3 m{};
  for (size_t i = 0; i < 3; ++i)
    for (size_t j = 0; j < 3; ++j) m[i][j] = dot(a[i], t[j]);
  return m;
}
inline Mat3 about_x(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {Vec3{1, 0, 0}, Vec3{0, c, -s}, Vec3{0, s, c}};
}
inline Mat3 about_y(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {Vec3{c, 0, s}, Vec3{0, 1, 0}, Vec3{-s, 0, c}};
}
inline Mat3 about_z(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {Vec3{c, -s, 0}, Vec3{s, c, 0}, Vec3{0, 0, 1}};
}

}  // namespace cntc
