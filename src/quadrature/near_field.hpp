#pragma once
/// Integrates over one element for a point on it or near it.
///
/// The element is cut until every part has a Gauss rule of moderate size, or the point's foot on the element (found by
/// Newton's method; it may lie a little outside) sees the part in polar coordinates: the part is the signed sum of
/// triangles from the foot to its edges. With d the point's height, L the length of the ray to the edge's
/// coordinate t in the metric of the tangent map, and h the distance of foot and edge,
///   s = d/L sinh(v) along the ray,   t = t0 + sqrt(h^2 + d^2)/|edge| sinh(u) along the edge
/// make the integrand smooth however small d and h are, and however slender the element is: r^2 is d^2 cosh^2(v) to
/// first order, and |edge|^2 t'^2 + h^2 + d^2 is smooth in u. A point on the element has d = 0: then v is s itself, T
/// is integrated against N(y) - N(x), and both integrands are smooth as well.
///
/// Slender quadrilaterals in a plane have two ways more: straight lines along them (lines.hpp) for points beside or
/// above, and polar coordinates of the plane itself (plane_part.hpp) for points that touch them or nearly so.

#include <cstdint>
#include <functional>

#include "quadrature/element.hpp"
#include "quadrature/near_points.hpp"
#include "quadrature/rule_selection.hpp"

namespace rollcon::quadrature {

struct NearWorkspace {
  NearPoints points;
  std::int64_t evaluations = 0;
};

/// Says where a point lies on the element, if it does.
struct OnElement {
  bool known = false;
  Vec2 reference{0, 0};
};

/// Finds the points that integrate kernels like T and U over the element, seen from the point, and
/// calls kernel() for each batch of them in the workspace, at least one. Set `strong` if T is
/// wanted, whose integrals against N of a point on the element make sense only after N(x) times their
/// sum over the nodes has been taken away. Kernels like U are all those of degree -1, in a plane, too.
void near_field(const ElementGeometry& element, const Vec3& point, const OnElement& on, Tolerance tolerance,
                bool strong, NearWorkspace& workspace, const std::function<void()>& kernel);

}  // namespace rollcon::quadrature
