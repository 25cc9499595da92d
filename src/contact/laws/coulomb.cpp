/// Implements Coulomb's law as a projection (Alart & Curnier 1991; docs/theory.md, sections 2 and 6).

#include <array>
#include <cmath>

#include "contact/laws/friction_law.hpp"
#include "contact/laws/parameters.hpp"

namespace rollcon {
namespace {

class Coulomb final : public FrictionLaw {
 public:
  FrictionTraction traction(const FrictionPoint& p) const override {
    const double a1 = p.t1 - p.rt * p.s1, a2 = p.t2 - p.rt * p.s2;
    return within_bound(a1, a2, std::hypot(a1, a2), p.mu * p.pressure);
  }

  TangentialLaw linearise(const FrictionPoint& p, bool bound_follows) const override {
    const double a1 = p.t1 - p.rt * p.s1, a2 = p.t2 - p.rt * p.s2;
    const double length = std::hypot(a1, a2), bound = p.mu * p.pressure;
    if (length < bound) return stick_law();
    if (!(length > 0)) return law_without_friction();
    TangentialLaw law{};
    law.sliding = true;
    const double e1 = a1 / length, e2 = a2 / length;
    const double gamma = bound / length;
    law.direction[0] = e1;
    law.direction[1] = e2;
    // gamma (I - e e^T) is the rotation of the slip direction.
    const double r11 = gamma * e2 * e2, r12 = -gamma * e1 * e2, r22 = gamma * e1 * e1;
    law.own[0][0] = 1 - r11;
    law.own[0][1] = law.own[1][0] = -r12;
    law.own[1][1] = 1 - r22;
    law.slip[0][0] = r11;
    law.slip[0][1] = law.slip[1][0] = r12;
    law.slip[1][1] = r22;
    if (bound_follows) {
      law.own[0][2] = p.mu * e1;
      law.own[1][2] = p.mu * e2;
    } else {
      law.constant[0] = bound * e1;
      law.constant[1] = bound * e2;
    }
    return law;
  }
};

}  // namespace

const FrictionLaw& coulomb() {
  static const Coulomb law;
  return law;
}

GivenFriction make_coulomb(std::span<const double> parameters) {
  require_coefficient(parameters[0], "mu");
  return {nullptr, parameters[0]};
}

}  // namespace rollcon
