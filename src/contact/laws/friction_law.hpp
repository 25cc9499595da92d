#pragma once
/// Defines friction at one node: what Newton's iteration and the limit of loads ask of it. A law is one file of this
/// folder.

#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <string>

namespace rollcon {

class FieldLaw;  // contact/laws/field_law.hpp

/// Tells how the tangential row of one node depends on its own tractions and slip:
///   row = own[i][0] lt1 + own[i][1] lt2 + own[i][2] ln + slip[i][0] s1 + slip[i][1] s2 =
///   constant[i]
/// linearised at the iterate, with the slip already multiplied by rt.
struct TangentialLaw {
  double own[2][3];
  double slip[2][2];
  double constant[2];
  double direction[2];  ///< direction of slip, where it slides: the row along it has no slip; 0: any
  bool sliding;
};

/// Returns the law of stick, rt s = 0.
inline TangentialLaw stick_law() {
  TangentialLaw law{};
  law.slip[0][0] = law.slip[1][1] = 1;
  return law;
}

/// Returns the law where nothing can be carried: lt = 0.
inline TangentialLaw law_without_friction() {
  TangentialLaw law{};
  law.sliding = true;
  law.own[0][0] = law.own[1][1] = 1;
  return law;
}

/// Describes a node as friction sees it.
struct FrictionPoint {
  double mu;              ///< coefficient of the node: the greatest that its law can reach there
  double pressure;        ///< augmented pressure, -(ln + rn gap)
  double t1, t2;          ///< tangential traction
  double s1 = 0, s2 = 0;  ///< slip over rolling speed
  double rt = 0;          ///< scale of the slip
  double falling = 1;     ///< factor on the slip speed that friction falls with; 0: as at rest
};

/// Holds the tangential traction that belongs to a point.
struct FrictionTraction {
  double t1, t2;
  double bound;   ///< greatest traction there
  double length;  ///< length of the augmented traction, as the law measures it against the bound
  bool sliding;   ///< the traction is at the bound
};

/// Shortens a vector where its length, as the law measures it, is beyond the bound.
inline FrictionTraction within_bound(double a1, double a2, double length, double bound) {
  const double factor = length > bound ? bound / length : 1;
  return {factor * a1, factor * a2, bound, length, !(length < bound)};
}

/// Defines a law, whose coefficients are those of the nodes times functions that are the law's own: none exceeds 1, so
/// a node's coefficient is the greatest there.
class FrictionLaw {
 public:
  virtual ~FrictionLaw() = default;
  /// Projects the augmented traction lt - rt s; the law's residual is lt minus the result.
  virtual FrictionTraction traction(const FrictionPoint& point) const = 0;
  /// Linearises that projection. The bound follows the normal traction of the new iterate if `bound_follows` (full
  /// problem), else it is a given number.
  virtual TangentialLaw linearise(const FrictionPoint& point, bool bound_follows) const = 0;
  /// Returns a matrix M: the tractions admitted under a pressure are the unit disk times M. A motion of the node then
  /// takes at most the power |M^T s|.
  virtual std::array<std::array<double, 2>, 2> capacity(double mu, double pressure) const {
    return {{{mu * pressure, 0}, {0, mu * pressure}}};
  }
  /// Returns the direction (of unit length) against which a node slides under the point's traction, which is not zero.
  virtual std::array<double, 2> against(const FrictionPoint& point) const {
    const double length = std::hypot(point.t1, point.t2);
    return {point.t1 / length, point.t2 / length};
  }
  /// Says whether friction is the same in all directions.
  virtual bool isotropic() const { return true; }
  /// Returns the law by which coefficients, given while a node is looked at, follow the whole solution; or null.
  virtual const FieldLaw* of_field() const { return nullptr; }
  /// Says whether friction depends on the slip speed, so that there may be several solutions.
  virtual bool falls() const { return false; }
  /// Returns the friction coefficient at the point.
  virtual double coefficient(const FrictionPoint& point) const { return point.mu; }
  /// Returns the law with slip speeds over this rolling speed; null: it does not matter.
  virtual std::shared_ptr<const FrictionLaw> at_speed(double /*speed*/) const { return nullptr; }
  /// Returns one line for the plan, of a law that is not Coulomb's.
  virtual std::string description() const { return {}; }
};

/// Returns Coulomb's law: no slip, or a traction of mu times the pressure against it.
const FrictionLaw& coulomb();

/// Holds a law with its parameters, and the coefficient of every node where no field gives it.
struct GivenFriction {
  std::shared_ptr<const FrictionLaw> law;
  double mu = 0;
};

/// Tells how long a slip it takes until friction follows the slip speed.
struct FrictionMemory {
  double length = 0;       ///< 0: none
  double least_speed = 0;  ///< speed that counts for lesser ones
  bool operator==(const FrictionMemory&) const = default;
};
/// Adds a memory to a law that falls.
std::shared_ptr<const FrictionLaw> with_memory(std::shared_ptr<const FrictionLaw> law, FrictionMemory memory);

/// Describes a layer between the bodies that flows under a traction of stress + hardening times the flow.
struct LayerYield {
  double stress = 0;  ///< 0: it never flows
  double hardening = 0;
  bool operator==(const LayerYield&) const = default;
};
/// Adds the yielding of a layer to a law that follows the whole solution, or (null) to Coulomb's.
std::shared_ptr<const FrictionLaw> with_yield(std::shared_ptr<const FrictionLaw> law, LayerYield yield);

/// Makes a law from finite parameters. Throws Error naming the parameter and what is allowed.
using MakeFriction = GivenFriction(std::span<const double> parameters);

/// Describes a law that callers may name (law_names.cpp).
struct LawName {
  const char* name;
  const char* parameters;  ///< parameters in words
  int least, greatest;     ///< number of parameters
  MakeFriction* make;
};
std::span<const LawName> law_names();

}  // namespace rollcon
