#include "quadrature/ellipse.hpp"

#include <algorithm>
#include <cmath>

namespace rollcon::quadrature {
namespace {

constexpr double straight = 0.02;  ///< sag over distance at which a line counts as straight

constexpr double rounding = 1e-14;  ///< sag over size that is only rounding

constexpr double far_away = 1e10;  ///< axis for a line that is a point

/// Returns the root that the tangent at z0 points to, refined by Newton's method on the quartic.
double axis_from(const Vec3& m, const Vec3& b, const Vec3& c, double z0) {
  const Vec3 x = m + z0 * (b + z0 * c), d = b + 2 * z0 * c;
  const double dd = dot(d, d), xd = dot(x, d), xx = dot(x, x);
  double re = z0 - xd / dd, im = std::sqrt(std::max(0.0, xx * dd - xd * xd)) / dd;
  const double a[5] = {dot(m, m), 2 * dot(m, b), dot(b, b) + 2 * dot(m, c), 2 * dot(b, c), dot(c, c)};
  for (int i = 0; i < 3; ++i) {
    // Horner's scheme gives value and slope in complex numbers.
    double vr = a[4], vi = 0, sr = 0, si = 0;
    for (int k = 3; k >= 0; --k) {
      const double s = sr * re - si * im + vr;
      si = sr * im + si * re + vi;
      sr = s;
      const double v = vr * re - vi * im + a[k];
      vi = vr * im + vi * re;
      vr = v;
    }
    const double norm = sr * sr + si * si;
    if (!(norm > 0)) break;
    re -= (vr * sr + vi * si) / norm;
    im -= (vi * sr - vr * si) / norm;
  }
  const double im2 = im * im;
  return 0.5 * (std::sqrt((re - 1) * (re - 1) + im2) + std::sqrt((re + 1) * (re + 1) + im2));
}

}  // namespace

double ellipse_axis(const Vec3& first, const Vec3& middle, const Vec3& last) {
  const Vec3 b = 0.5 * (last - first), c = 0.5 * (first + last) - middle;
  const double bb = dot(b, b), cc = dot(c, c);
  const double r[3] = {dot(first, first), dot(middle, middle), dot(last, last)};
  const double nearest = std::min({r[0], r[1], r[2]});
  if (bb + cc <= 1e-20 * nearest) return far_away;
  // A line that a point nearly touches has no sag up to the rounding of its own points, either.
  if (cc <= std::max(straight * straight * std::min(bb, nearest), rounding * rounding * std::max({bb, r[0], r[2]})))
    return std::max(1.0, 0.5 * (std::sqrt(r[0]) + std::sqrt(r[2])) / std::sqrt(bb));
  const double z0 = nearest == r[1] ? 0 : nearest == r[0] ? -1 : 1;
  const double axis = axis_from(middle, b, c, z0);
  return axis >= 1 ? axis : 1;
}

double log_rho(double axis) {
  return std::log(axis + std::sqrt(std::max(0.0, axis * axis - 1)));
}

}  // namespace rollcon::quadrature
