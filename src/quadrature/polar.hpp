#pragma once
/// Provides polar coordinates about the foot of the origin on an element; near_field.hpp explains them.

#include "quadrature/element.hpp"
#include "quadrature/rule_selection.hpp"

namespace rollcon::quadrature {

/// Holds the foot of the origin on an element and the tangent map there.
struct Foot {
  bool found = false;
  Vec2 reference{0, 0};
  Vec3 x{}, d_xi{}, d_eta{};
  double height = 0;  ///< 0 when the origin lies on the element

  Vec3 tangent(Vec2 v) const { return v.x * d_xi + v.y * d_eta; }
};

/// Finds the foot closest to `start`; with `on`, it is start itself, because the origin is there. None is found when
/// Newton's method leaves the element's neighbourhood.
Foot find_foot(const ElementGeometry& element, Vec2 start, bool on);

/// Is an edge of a cell in the metric of the tangent map, seen from the foot.
struct EdgeView {
  Vec2 a, b;                        ///< the edge is foot + a + t b, 0 <= t <= 1
  double t0, eta;                   ///< value of t nearest to the foot, and distance of the singularity, in units of t
  double u1, u2;                    ///< values of u at the ends: t = t0 + eta sinh(u)
  double longest = 0;               ///< length of the longest ray
  bool counts = false;              ///< true if the integrals exceed the tolerance
  double share_t = 0, share_u = 0;  ///< size of the integrals
  double uneven = 0;                ///< largest relative departure of the map from its tangent
};

EdgeView view_edge(const ElementGeometry& element, const Foot& foot, Vec2 begin, Vec2 end, Tolerance tolerance);

struct PolarRule {
  int ray = 1, ray_pieces = 1;      ///< points on each piece of a ray, pieces
  int angle = 1, angle_pieces = 1;  ///< points on each piece of the edge, pieces
};
PolarRule polar_rule(const ElementGeometry& element, const Foot& foot, const EdgeView& view, Tolerance tolerance);

/// Chooses Gauss points, and equal pieces, for an integrand of t = t0 + eta sinh(u) over a span of u: a polynomial of
/// this degree times what is singular at u = +- i pole. ElementGeometry describes series_log; the target is relative.
void sinh_rule(double span, double pole, int degree, double series_log, double target, int& points, int& pieces);

}  // namespace rollcon::quadrature
