#pragma once
/// Does node by node what Coulomb's law does, with coefficients that something else gives.

#include "contact/laws/friction_law.hpp"

namespace rollcon {

class CoulombGiven : public FrictionLaw {
 public:
  FrictionTraction traction(const FrictionPoint& p) const override { return coulomb().traction(p); }
  TangentialLaw linearise(const FrictionPoint& p, bool bound_follows) const override {
    return coulomb().linearise(p, bound_follows);
  }
};

}  // namespace rollcon
