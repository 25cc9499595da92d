#pragma once
/// Coulomb's law as a projection and its derivative (Alart & Curnier 1991; docs/theory.md, sections
/// 2 and 6). All arguments of one node.

#include <cmath>

namespace rollcon {

/// How the tangential row of one node depends on its own tractions and slip:
///   row = own[i][0] lt1 + own[i][1] lt2 + own[i][2] ln + slip[i][0] s1 + slip[i][1] s2 =
///   constant[i]
/// linearised at the iterate. With the slip already multiplied by rt.
struct TangentialLaw {
  double own[2][3];
  double slip[2][2];
  double constant[2];
  double direction[2];  ///< of slip, where it slides: the row along it has no slip; 0: any
  bool sliding;
};

/// rt s = 0.
inline TangentialLaw stick_law() {
  TangentialLaw law{};
  law.slip[0][0] = law.slip[1][1] = 1;
  return law;
}

/// a1, a2: augmented traction lambda_t - rt s; bound: mu times augmented pressure. The bound is
/// -mu lambda_n^+ of the new iterate if `bound_follows` (full problem), else a given number.
inline TangentialLaw linearise_coulomb(double a1, double a2, double mu, double bound,
                                       bool bound_follows) {
  const double length = std::hypot(a1, a2);
  if (length < bound) return stick_law();
  TangentialLaw law{};
  law.sliding = true;
  if (!(length > 0)) {  // no friction at this node: lambda_t = 0
    law.own[0][0] = law.own[1][1] = 1;
    return law;
  }
  const double e1 = a1 / length, e2 = a2 / length;
  const double gamma = bound / length;
  law.direction[0] = e1;
  law.direction[1] = e2;
  // gamma (I - e e^T): the rotation of the slip direction
  const double r11 = gamma * e2 * e2, r12 = -gamma * e1 * e2, r22 = gamma * e1 * e1;
  law.own[0][0] = 1 - r11;
  law.own[0][1] = law.own[1][0] = -r12;
  law.own[1][1] = 1 - r22;
  law.slip[0][0] = r11;
  law.slip[0][1] = law.slip[1][0] = r12;
  law.slip[1][1] = r22;
  if (bound_follows) {
    law.own[0][2] = mu * e1;
    law.own[1][2] = mu * e2;
  } else {
    law.constant[0] = bound * e1;
    law.constant[1] = bound * e2;
  }
  return law;
}

/// Projection of (a1, a2) on the disk of radius bound >= 0.
inline void project_on_disk(double a1, double a2, double bound, double& t1, double& t2) {
  const double length = std::hypot(a1, a2);
  const double factor = length > bound ? bound / length : 1;
  t1 = factor * a1;
  t2 = factor * a2;
}

}  // namespace rollcon
