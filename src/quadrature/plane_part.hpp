#pragma once
/// A plane part of an element with straight sides, in coordinates of its plane.
///
/// Seen through the bilinear map, the rays of polar coordinates in the reference square are parabolas. On a slender
/// element they bend over distances far below its width, and cuts would be needed in proportion to its slenderness. In
/// coordinates p, q of the plane along the part's two middle lines, rays are straight, and the map and its inverse are
/// those of a round element:
///   p = xi + alpha xi eta,   q = eta + beta xi eta.
/// Shape functions are no polynomials of p and q: their series' singularity is 1/(sqrt|alpha| + sqrt|beta|)^2 away.

#include <optional>

#include "quadrature/polar.hpp"

namespace rollcon::quadrature {

struct PlanePart {
  Cell cell;  ///< on which xi and eta go from -1 to 1
  double alpha = 0, beta = 0;
  double series_log = 0;   ///< log of the ratio in which terms of the series fall; 0: they may not
  ElementGeometry affine;  ///< its reference coordinates are p and q
  Foot foot;               ///< of the origin, in p and q

  /// Corner i in p and q, going around.
  Vec2 corner(int i) const;
  /// xi and eta at p, q; their real parts, where the plane's point is beyond the map's fold.
  Vec2 local(Vec2 at) const;
  /// From p, q and a weight there to the element's reference coordinates.
  void place(Vec2& at, double& weight) const;
};

/// The cell, a quadrilateral that `shape` belongs to; nothing if its sides are curved or it is not plane.
std::optional<PlanePart> plane_part(const ElementGeometry& element, const Cell& cell, const CellShape& shape);

}  // namespace rollcon::quadrature
