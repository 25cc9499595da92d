#pragma once
/// Straight lines across a part of a plane element with straight sides, from side to side at equal xi or eta, seen from
/// a point beside the part or above it.
///
/// Across the lines Gauss's rule serves, the point being a width away. Along them it would not if the part is slender:
/// there t = t0 + eta sinh(u), with t0 the point's foot on the line and eta its distance, in half lengths of the line.

#include "quadrature/element.hpp"
#include "quadrature/rule_selection.hpp"

namespace rollcon::quadrature {

struct SinhMap {
  double t0, eta;
  double u1, u2;  ///< of t = -1 and 1
};

struct Lines {
  Vec3 begin[2], end[2];              ///< of the first and the last line
  int number = 1;                     ///< Gauss's rule across; more than it has: not for this point
  int points = 1, pieces = 1;         ///< on each line
  SinhMap line(double across) const;  ///< from -1 to 1
};

/// along: 0 for lines along xi, 1 along eta. The part is relative to the point; foot: in the part's coordinates along
/// the lines.
Lines lines_across(const ElementGeometry& element, const CellShape& shape, int along, double foot, Tolerance tolerance);

}  // namespace rollcon::quadrature
