#include "quadrature/lines.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "quadrature/ellipse.hpp"
#include "quadrature/polar.hpp"
#include "support/index.hpp"

namespace rollcon::quadrature {

SinhMap Lines::line(double across) const {
  const double s = 0.5 * (1 - across), t = 0.5 * (1 + across);
  const Vec3 from = s * begin[0] + t * begin[1], to = s * end[0] + t * end[1];
  const Vec3 middle = 0.5 * (from + to), half = 0.5 * (to - from);
  const double length2 = dot(half, half);
  SinhMap map;
  map.t0 = -dot(middle, half) / length2;
  // Any eta is right; the least one keeps the span finite where the point lies on the line's extension.
  map.eta = std::max(length(cross(middle, half)) / length2, 1e-14);
  map.u1 = std::asinh((-1 - map.t0) / map.eta);
  map.u2 = std::asinh((1 - map.t0) / map.eta);
  return map;
}

Lines lines_across(const ElementGeometry& element, const CellShape& shape, int along, double foot,
                   Tolerance tolerance) {
  constexpr double safety = 30, across_constant = 100;  // values of polar_rule
  const Vec3(&c)[4] = shape.corner;
  const int last = along == 0 ? 3 : 1;
  Lines lines{{c[0], c[last]}, {c[4 - last], c[2]}};
  double span = 0, height = 1e300;
  for (const double at : {-1.0, 0.0, 1.0}) {
    const SinhMap map = lines.line(at);
    span = std::max(span, map.u2 - map.u1);
    height = std::min(height, map.eta * shape.half_length);
  }
  const double width = shape.area / shape.half_length;
  const double share_u = width * span, share_t = std::min(span, 4.0) * std::max(1.0, width / height);
  const double target = std::min({1.0, tolerance.t / (safety * share_t), tolerance.u / (safety * share_u)});
  const int degree = direction_degree(element.type, element.map);
  sinh_rule(span, 0.5 * std::numbers::pi, degree, 0, target, lines.points, lines.pieces);

  // The ellipse across the lines is smallest at their ends or past the foot; the point is farther away elsewhere.
  double axis = 1e300;
  for (const double at : {-1.0, std::clamp(foot, -1.0, 1.0), 1.0}) {
    const double s = 0.5 * (1 - at), t = 0.5 * (1 + at);
    const Vec3 from = s * lines.begin[0] + t * lines.end[0], to = s * lines.begin[1] + t * lines.end[1];
    axis = std::min(axis, ellipse_axis(from, 0.5 * (from + to), to));
  }
  const double number = std::ceil(0.5 * (degree + std::log(across_constant / target) / log_rho(axis)));
  lines.number = static_cast<int>(to_index(std::min(number, 99.0)));
  return lines;
}

}  // namespace rollcon::quadrature
