#pragma once
/// Polar coordinates about the foot of the origin on an element; see near_field.hpp.

#include "quadrature/element.hpp"
#include "quadrature/rule_selection.hpp"

namespace rollcon::quadrature {

/// The foot of the origin on an element and the tangent map there.
struct Foot {
  bool found = false;
  Vec2 reference{0, 0};
  Vec3 x{}, d_xi{}, d_eta{};
  double height = 0;  ///< 0 when the origin lies on the element

  Vec3 tangent(Vec2 v) const { return v.x * d_xi + v.y * d_eta; }
};

/// The foot closest to `start`; with `on`, start itself, the origin being there. Not found when Newton's method leaves
/// the element's neighbourhood.
Foot find_foot(const ElementGeometry& element, Vec2 start, bool on);

/// An edge of a cell in the metric of the tangent map, seen from the foot.
struct EdgeView {
  Vec2 a, b;                        ///< the edge is foot + a + t b, 0 <= t <= 1
  double t0, eta;                   ///< its nearest point, and distance of the singularity, in units of t
  double u1, u2;                    ///< of the ends: t = t0 + eta sinh(u)
  double longest = 0;               ///< ray
  bool counts = false;              ///< above the tolerance
  double share_t = 0, share_u = 0;  ///< size of the integrals
  double uneven = 0;                ///< largest relative departure of the map from its tangent
};

EdgeView view_edge(const ElementGeometry& element, const Foot& foot, Vec2 begin, Vec2 end, Tolerance tolerance);

struct PolarRule {
  int ray = 1, ray_pieces = 1;      ///< points on each piece of a ray, pieces
  int angle = 1, angle_pieces = 1;  ///< the same across
};
PolarRule polar_rule(const ElementGeometry& element, const Foot& foot, const EdgeView& view, Tolerance tolerance);

/// Gauss points, and equal pieces, for an integrand of t = t0 + eta sinh(u) over a span of u: a polynomial of this
/// degree times what is singular at u = +- i pole. series_log: as in ElementGeometry; target: relative.
void sinh_rule(double span, double pole, int degree, double series_log, double target, int& points, int& pieces);

}  // namespace rollcon::quadrature
