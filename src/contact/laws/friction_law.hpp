#pragma once
/// Friction at one node: what Newton's iteration, the limit of loads and the relaxation ask of it. A law is one file of
/// this folder.

#include <array>
#include <span>

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

/// A node as friction sees it.
struct FrictionPoint {
  double mu;        ///< its coefficient
  double pressure;  ///< augmented: -(ln + rn gap)
  double a1, a2;    ///< augmented tangential traction, lt - rt s
};

/// The tangential traction that belongs to a point.
struct FrictionTraction {
  double t1, t2;
  double bound;   ///< greatest traction there
  double length;  ///< of the augmented traction
  bool sliding;   ///< it is at the bound
};

/// Slip (over speed) of a node per unit of its own tangential tractions.
struct NodeResponse {
  double b[2][2];
};

class FrictionLaw {
 public:
  virtual ~FrictionLaw() = default;
  /// The law as a projection: its residual is lt minus this.
  virtual FrictionTraction traction(const FrictionPoint& point) const = 0;
  /// Its derivative. The bound follows the normal traction of the new iterate if `bound_follows` (full problem), else
  /// it is a given number.
  virtual TangentialLaw linearise(const FrictionPoint& point, bool bound_follows) const = 0;
  /// Tractions that are admitted under a pressure: the unit disk times this matrix. A motion of the node then takes at
  /// most the power |M^T s|.
  virtual std::array<std::array<double, 2>, 2> capacity(double mu, double pressure) const = 0;
  /// Tractions that keep the law at one node under the pressure, the slip being linear in them; slip: with the
  /// tractions `old`.
  virtual std::array<double, 2> solve(const NodeResponse& response, std::array<double, 2> slip,
                                      std::array<double, 2> old, double mu, double pressure) const = 0;
};

/// Coulomb's: no slip, or a traction of mu times the pressure against it.
const FrictionLaw& coulomb();

/// What callers may name (law_names.cpp).
struct LawName {
  const char* name;
  const FrictionLaw& (*law)();
};
std::span<const LawName> law_names();

}  // namespace rollcon
