#pragma once
/// Defines vectors in a plane.

#include <array>
#include <cmath>

namespace rollcon {

using Vec2 = std::array<double, 2>;

inline Vec2 operator+(const Vec2& a, const Vec2& b) {
  return {a[0] + b[0], a[1] + b[1]};
}
inline Vec2 operator-(const Vec2& a, const Vec2& b) {
  return {a[0] - b[0], a[1] - b[1]};
}
inline Vec2 operator*(double s, const Vec2& a) {
  return {s * a[0], s * a[1]};
}
inline double dot(const Vec2& a, const Vec2& b) {
  return a[0] * b[0] + a[1] * b[1];
}
/// Returns the product with b of a turned by a right angle from the first axis to the second.
inline double cross(const Vec2& a, const Vec2& b) {
  return a[0] * b[1] - a[1] * b[0];
}
inline double length(const Vec2& a) {
  return std::hypot(a[0], a[1]);
}

}  // namespace rollcon
