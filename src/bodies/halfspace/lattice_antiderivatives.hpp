#pragma once
/// Defines functions F whose mixed derivative d^4 F / dx^2 dy^2 is one of the five kernels of kernels.hpp. Integrals of
/// a kernel times bilinear functions on rectangles are sums of F and its first derivatives at corners.

#include <cmath>

namespace rollcon::halfspace {

/// Extends doubles, as differences of F lose digits with the fourth power of distance over cell size.
using Extended = long double;

/// Holds value[k][p][q], the p-th derivative in x and q-th in y of the antiderivative of kernel k.
struct Antiderivatives {
  Extended value[5][2][2];
};

inline Antiderivatives antiderivatives(Extended x, Extended y) {
  const Extended r = std::sqrt(x * x + y * y);
  // Products x asinh(y/|x|) and y asinh(x/|y|) are zero where the argument is infinite.
  const Extended b = x != 0 ? x * std::asinh(y / std::abs(x)) : 0;
  const Extended a = y != 0 ? y * std::asinh(x / std::abs(y)) : 0;
  // atan, not atan2: what the jump adds to F has no mixed derivative, and F_x, F_y stay continuous.
  const Extended theta = x != 0 ? std::atan(y / x) : 0;
  const Extended phi = y != 0 ? std::atan(x / y) : 0;
  const Extended l = r != 0 ? std::log(r) : 0;
  Antiderivatives f;
  // 1/r
  f.value[0][0][0] = x * y * (b + a) / 2 - r * r * r / 6;
  f.value[0][1][0] = y * b + y * a / 2 - x * r / 2;
  f.value[0][0][1] = x * a + x * b / 2 - y * r / 2;
  f.value[0][1][1] = b + a;
  // x^2/r^3
  f.value[1][0][0] = r * r * r / 6 + y * (x * a - y * r) / 2;
  f.value[1][1][0] = (x * r + y * a) / 2;
  f.value[1][0][1] = x * a - y * r;
  f.value[1][1][1] = a;
  // x y/r^3
  f.value[2][0][0] = -(2 * x * y * r + x * x * b + y * y * a) / 6;
  f.value[2][1][0] = -(y * r + x * b) / 2;
  f.value[2][0][1] = -(x * r + y * a) / 2;
  f.value[2][1][1] = -r;
  // x/r^2
  f.value[3][0][0] =
      l * x * (3 * y * y - x * x) / 6 + y * y * y * phi / 6 + x * x * y * theta / 2 - x * y * y / 6 + x * x * x / 18;
  f.value[3][1][0] = (y * y - x * x) * l / 2 + x * y * theta;
  f.value[3][0][1] = x * y * l + (y * y * phi + x * x * theta) / 2;
  f.value[3][1][1] = y * l + x * theta + y / 2;
  // y/r^2
  f.value[4][0][0] =
      l * y * (3 * x * x - y * y) / 6 + x * x * x * theta / 6 + y * y * x * phi / 2 - x * x * y / 6 + y * y * y / 18;
  f.value[4][0][1] = (x * x - y * y) * l / 2 + x * y * phi;
  f.value[4][1][0] = x * y * l + (x * x * theta + y * y * phi) / 2;
  f.value[4][1][1] = x * l + y * phi + x / 2;
  return f;
}

}  // namespace rollcon::halfspace
