#pragma once
/// Represents a plane part of an element with straight sides, in coordinates of its plane.
///
/// The rays of polar coordinates in the reference square are parabolas, seen through the bilinear map. They bend on a
/// slender element over distances far below its width, and cuts would be needed in proportion to its slenderness. Rays
/// are straight in coordinates p, q of the plane along the part's two middle lines, and the map and its inverse are
/// those of a round element:
///   p = xi + alpha xi eta,   q = eta + beta xi eta.
/// Shape functions are no polynomials of p and q: their series' singularity is 1/(sqrt|alpha| + sqrt|beta|)^2 away.

#include <optional>

#include "quadrature/polar.hpp"

namespace rollcon::quadrature {

struct PlanePart {
  Cell cell;  ///< cell on which xi and eta go from -1 to 1
  double alpha = 0, beta = 0;
  double series_log = 0;   ///< log of the ratio in which terms of the series fall; 0: they may not
  ElementGeometry affine;  ///< element whose reference coordinates are p and q
  Foot foot;               ///< foot of the origin, in p and q

  /// Returns corner i in p and q, going around.
  Vec2 corner(int i) const;
  /// Returns xi and eta at p, q; their real parts, where the plane's point is beyond the map's fold.
  Vec2 local(Vec2 at) const;
  /// Turns p, q and a weight there into the element's reference coordinates and weight.
  void place(Vec2& at, double& weight) const;
};

/// Returns the plane part of the cell, a quadrilateral that `shape` belongs to; nothing if its sides are curved or it
/// is not plane.
std::optional<PlanePart> plane_part(const ElementGeometry& element, const Cell& cell, const CellShape& shape);

}  // namespace rollcon::quadrature
