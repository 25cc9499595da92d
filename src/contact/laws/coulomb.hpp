#pragma once
/// Coulomb's law as a projection (Alart & Curnier 1991; docs/theory.md, sections 2 and 6).

#include <cmath>

namespace rollcon {

/// Projection of (a1, a2) on the disk of radius bound >= 0.
inline void project_on_disk(double a1, double a2, double bound, double& t1, double& t2) {
  const double length = std::hypot(a1, a2);
  const double factor = length > bound ? bound / length : 1;
  t1 = factor * a1;
  t2 = factor * a2;
}

}  // namespace rollcon
