#include "quadrature/polar.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "quadrature/rules.hpp"

namespace rollcon::quadrature {
namespace {

constexpr double ray_constant = 20, height_constant = 200, angle_constant = 100;
constexpr double on_element = 1e-12;  ///< height below which a point lies on the element

/// Returns the logarithm of the parameter of the ellipse about [0, length] through a pole at i height.
double ray_decay(double length, double height) {
  const double s = (height + std::hypot(length, height)) / length;
  return std::log(s + std::sqrt(s * s - 1));
}

/// Finds the number of equal pieces with the fewest points in all.
template <class Points>
void cheapest(int& points, int& pieces, Points needed) {
  double cost = 1e300;
  points = max_line_points;
  for (int m = 1; m <= 24; ++m) {
    const double n = std::ceil(needed(m));
    if (n <= max_line_points && n * m < cost) {
      cost = n * m;
      points = static_cast<int>(n);
      pieces = m;
    }
    if ((m > 2 && n <= 4) || m * 2 > cost) break;
  }
}

}  // namespace

Foot find_foot(const ElementGeometry& element, Vec2 start, bool on) {
  Foot foot;
  foot.reference = start;
  if (on) {
    element.tangents(start, foot.x, foot.d_xi, foot.d_eta);
    foot.x = {0, 0, 0};
    foot.found = true;
    return foot;
  }
  for (int iteration = 0; iteration < 20; ++iteration) {
    element.tangents(foot.reference, foot.x, foot.d_xi, foot.d_eta);
    const double aa = dot(foot.d_xi, foot.d_xi), bb = dot(foot.d_eta, foot.d_eta), ab = dot(foot.d_xi, foot.d_eta),
                 xa = dot(foot.x, foot.d_xi), xb = dot(foot.x, foot.d_eta), det = aa * bb - ab * ab;
    if (!(det > 0)) return foot;
    const Vec2 step{(xb * ab - xa * bb) / det, (xa * ab - xb * aa) / det};
    const double miss = length(foot.tangent(step)), height = length(foot.x);
    if (miss <= std::max(1e-6 * height, 1e-14 * element.shape.half_length)) {
      foot.found = true;
      foot.height = height <= on_element * element.shape.half_length ? 0 : height;
      return foot;
    }
    foot.reference = foot.reference + step;
    if (!(std::abs(foot.reference.x) + std::abs(foot.reference.y) < 20)) return foot;
  }
  return foot;
}

EdgeView view_edge(const ElementGeometry& element, const Foot& foot, Vec2 begin, Vec2 end, Tolerance tolerance) {
  EdgeView view;
  view.a = begin - foot.reference;
  view.b = end - begin;
  const Vec3 pa = foot.tangent(view.a), pb = foot.tangent(view.b);
  const double length2 = dot(pb, pb), edge = std::sqrt(length2), d = foot.height;
  const double h = length(cross(pa, pb)) / edge;
  // The foot is on the edge up to rounding; the points of a thinner triangle could not be told from the foot's.
  if (!(h > 1e-14 * element.shape.half_length)) return view;
  view.eta = std::hypot(h, d) / edge;
  view.t0 = -dot(pa, pb) / length2;
  view.u1 = std::asinh(-view.t0 / view.eta);
  view.u2 = std::asinh((1 - view.t0) / view.eta);
  view.longest = std::max(length(pa), length(pa + pb));
  const double span = view.u2 - view.u1;
  const double width = element.shape.area / element.shape.half_length;
  const double angle = std::min(span, 4.0);
  view.share_u = std::min(h, view.longest) * span;
  view.share_t =
      d > 0 ? std::min(angle, h * angle / d) * (1 + std::log1p(view.longest / d)) : angle * std::min(1.0, h / width);
  view.counts = view.share_u > 1e-2 * tolerance.u || view.share_t > 1e-2 * tolerance.t;
  if (!view.counts || element.map == MapKind::affine) return view;
  // The map is checked where the ray is shortest, and all along the edge: past a second zero of the map the rays would
  // run over the point once more.
  auto uneven = [&](double t) {
    const Vec2 ray = view.a + t * view.b;
    const Vec3 linear = foot.tangent(ray);
    const Vec3 off = element.position(foot.reference + ray) - foot.x - linear;
    view.uneven = std::max(view.uneven, std::sqrt(dot(off, off) / dot(linear, linear)));
  };
  const int steps = is_quadratic(element.type) ? 8 : 2;
  for (int k = 0; k <= steps; ++k) uneven(static_cast<double>(k) / steps);
  for (const double t :
       {view.t0, view.t0 - view.eta, view.t0 + view.eta, view.t0 - 3 * view.eta, view.t0 + 3 * view.eta})
    if (t >= 0 && t <= 1) uneven(t);
  return view;
}

PolarRule polar_rule(const ElementGeometry& element, const Foot& foot, const EdgeView& view, Tolerance tolerance) {
  const double safety = element.map == MapKind::affine ? 3 : 30;
  const double target = std::min({1.0, tolerance.t / (safety * view.share_t), tolerance.u / (safety * view.share_u)});
  // The integrand along a ray is a polynomial in s, times the map's departure from its tangent, which is singular at
  // about s = 1/uneven; with a height, it is also singular at v = +- i pi/2.
  const int p = element.series_log > 0 ? element.degree : ray_degree(element.type, element.map);
  double least = std::floor(0.5 * p) + 1;
  if (view.uneven > 0 && target < view.uneven) {
    const double z = 2 / view.uneven - 1, rho = z + std::sqrt(z * z - 1);
    least = std::max(least, 0.5 * (p + std::log(ray_constant * view.uneven / target) / std::log(rho)));
  }
  if (element.series_log > 0) least = std::max(least, 0.5 * (p + std::log(ray_constant / target) / element.series_log));
  PolarRule rule;
  const double v = foot.height > 0 ? std::asinh(view.longest / foot.height) : 0;
  const double shift = view.uneven * std::max(1.0, foot.height / view.longest);
  const double ray_pole = 0.5 * std::numbers::pi * (1 - std::min(shift, 0.5));
  const double ray_digits = std::log(height_constant / target);
  cheapest(rule.ray, rule.ray_pieces, [&](int pieces) {
    if (v == 0) return least;
    const double length = v / pieces;
    return std::max({least, 0.5 * p + 0.5 * ray_digits / ray_decay(length, ray_pole),
                     0.5 * (p + std::sqrt(p * length * ray_digits))});
  });
  // The integrand over the angle is singular at u = +- i pi/2.
  sinh_rule(view.u2 - view.u1, 0.5 * std::numbers::pi * (1 - view.uneven), std::max(2, element.degree + element.extra),
            element.series_log, target, rule.angle, rule.angle_pieces);
  return rule;
}

void sinh_rule(double span, double pole, int degree, double series_log, double target, int& points, int& pieces) {
  const double digits = std::log(angle_constant / target);
  cheapest(points, pieces, [&](int m) {
    const double z = 2 * pole * m / span;
    double decay = std::log(z + std::sqrt(1 + z * z));
    if (series_log > 0) decay = std::min(decay, series_log);
    return std::max(2.0, 0.5 * (degree + digits / decay));
  });
}

}  // namespace rollcon::quadrature
