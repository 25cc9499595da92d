#pragma once
/// Lays straight lines across a part of a plane element with straight sides, from side to side at equal xi or eta, seen
/// from a point beside the part or above it.
///
/// Gauss's rule serves across the lines, because the point is a width away. It would not serve along the lines of a
/// slender part: t = t0 + eta sinh(u) does, with t0 the point's foot on the line and eta its distance, in half lengths
/// of the line.

#include "quadrature/element.hpp"
#include "quadrature/rule_selection.hpp"

namespace rollcon::quadrature {

struct SinhMap {
  double t0, eta;
  double u1, u2;  ///< values of u at t = -1 and 1
};

struct Lines {
  Vec3 begin[2], end[2];              ///< ends of the first and the last line
  int number = 1;                     ///< Gauss points across; more than Gauss's rule has: not for this point
  int points = 1, pieces = 1;         ///< points on each line, in so many pieces
  SinhMap line(double across) const;  ///< map of a line at `across` from -1 to 1
};

/// Lays lines along xi if `along` is 0, along eta if it is 1. The part is relative to the point; `foot` is in the
/// part's coordinates along the lines.
Lines lines_across(const ElementGeometry& element, const CellShape& shape, int along, double foot, Tolerance tolerance);

}  // namespace rollcon::quadrature
