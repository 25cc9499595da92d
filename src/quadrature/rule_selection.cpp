#include "quadrature/rule_selection.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "quadrature/ellipse.hpp"
#include "support/index.hpp"

namespace rollcon::quadrature {
namespace {

constexpr int too_many = 99;

Vec3 between(const Vec3& first, const Vec3& middle, const Vec3& last, double t) {
  return 0.5 * t * (t - 1) * first + (1 - t * t) * middle + 0.5 * t * (t + 1) * last;
}

/// Returns the foot of the observer on the plane of a and b through the centre, in their units, clamped to [-1, 1].
Vec2 foot(const Vec3& centre, const Vec3& a, const Vec3& b) {
  const double aa = dot(a, a), bb = dot(b, b), ab = dot(a, b), ca = -dot(centre, a), cb = -dot(centre, b),
               det = aa * bb - ab * ab;
  if (!(det > 0)) return {0, 0};
  return {std::clamp((ca * bb - cb * ab) / det, -1.0, 1.0), std::clamp((cb * aa - ca * ab) / det, -1.0, 1.0)};
}

double triangle_axis(const CellShape& g) {
  double axis = 1e300;
  for (int i = 0; i < 3; ++i) axis = std::min(axis, ellipse_axis(g.corner[i], g.middle[i], g.corner[(i + 1) % 3]));
  // A point above the inside of the triangle needs a line through the foot.
  const Vec3 normal = cross(g.corner[1] - g.corner[0], g.corner[2] - g.corner[0]);
  const double area2 = dot(normal, normal);
  for (int i = 0; i < 3; ++i)
    if (!(dot(cross(g.corner[i], g.corner[(i + 1) % 3]), normal) > 0)) return axis;
  const double h = std::abs(dot(g.corner[0], normal)) / std::sqrt(area2) / g.half_length;
  return std::min(axis, std::sqrt(1 + h * h));
}

void square_axes(const CellShape& g, double& first, double& second) {
  const Vec3(&c)[4] = g.corner, (&m)[4] = g.middle;
  first =
      std::min({ellipse_axis(c[0], m[0], c[1]), ellipse_axis(m[3], g.centre, m[1]), ellipse_axis(c[3], m[2], c[2])});
  second =
      std::min({ellipse_axis(c[0], m[3], c[3]), ellipse_axis(m[0], g.centre, m[2]), ellipse_axis(c[1], m[1], c[2])});
  // A point near the cell needs the lines through its nearest point, too.
  if (dot(g.centre, g.centre) > 9 * g.half_length * g.half_length) return;
  const Vec2 at = foot(g.centre, 0.5 * (m[1] - m[3]), 0.5 * (m[2] - m[0]));
  first = std::min(first, ellipse_axis(between(c[0], m[3], c[3], at.y), between(m[0], g.centre, m[2], at.y),
                                       between(c[1], m[1], c[2], at.y)));
  second = std::min(second, ellipse_axis(between(c[0], m[0], c[1], at.x), between(m[3], g.centre, m[1], at.x),
                                         between(c[3], m[2], c[2], at.x)));
}

}  // namespace

CellShape seen_from(const CellShape& cell, const Vec3& point) {
  CellShape g = cell;
  for (int i = 0; i < g.corners; ++i) {
    g.corner[i] = g.corner[i] - point;
    g.middle[i] = g.middle[i] - point;
  }
  g.centre = g.centre - point;
  return g;
}

Selection select_rule(const ElementGeometry& element, const CellShape& g, Tolerance tolerance) {
  constexpr double pi = std::numbers::pi;
  const double distance = std::max(length(g.centre), 0.5 * g.half_length);
  const double ratio = g.area / distance;
  const double amplitude_t = rule_constant * std::min(ratio / (2 * pi * distance), 1.0) / tolerance.t,
               amplitude_u = rule_constant * ratio / (4 * pi * tolerance.u);
  const double digits = std::log(std::max({1.0, amplitude_t, amplitude_u}));
  const double jacobian_digits = std::log(std::max(1.0, amplitude_u * element.bend));

  // A cut halves the map's departure in one direction at least.
  const double cuts = 0.35 * g.depth, log_departure = element.log_departure - cuts;

  // Finds 2n (or degree + 1) such that C rho^-(2n - p) max(1, kappa rho)^k is within the tolerance.
  auto exponent = [&](double axis, double jacobian_log_rho) {
    const double l = log_rho(axis);
    double e = std::max(1.0, digits / l);
    if (element.extra > 0 && log_departure + l > 0) {
      // Terms with more degrees than the rule has to spare are as small as the last before them.
      const double more = digits + element.extra * (log_departure + l);
      e = std::max(e, std::min(more / l, std::max(1.0, -digits / log_departure)));
    }
    if (jacobian_digits > 0) e = std::max(e, jacobian_digits / (jacobian_log_rho + cuts));
    return element.degree + e;
  };
  Selection selection;
  if (g.corners == 3) {
    const double degree = std::ceil(exponent(triangle_axis(g), element.jacobian_log_rho[0])) - 1;
    selection.gauss = degree <= most_triangle_degree;
    selection.first = selection.second = selection.gauss ? static_cast<int>(degree) : too_many;
    return selection;
  }
  double axis[2];
  square_axes(g, axis[0], axis[1]);
  const double n1 = std::ceil(0.5 * exponent(axis[0], element.jacobian_log_rho[0])),
               n2 = std::ceil(0.5 * exponent(axis[1], element.jacobian_log_rho[1]));
  selection.gauss = n1 <= most_line_points && n2 <= most_line_points;
  selection.first = static_cast<int>(to_index(std::min<double>(n1, too_many)));
  selection.second = static_cast<int>(to_index(std::min<double>(n2, too_many)));
  return selection;
}

}  // namespace rollcon::quadrature
