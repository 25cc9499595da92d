#pragma once
#include "inputs.hpp"

namespace cntc {

/// Returns 1/E* of two half-spaces, from Poisson's ratios and shear moduli.
double contact_compliance(const Material& m);

/// Finds the missing semi-axes or curvatures by Hertz's formulas, from load or approach; throws Failure.
HertzContact hertz_contact(const Inputs& in);

/// Returns CONTACT's grid: it reaches scale times the semi-axes to both sides.
Grid hertz_grid(const HertzInput& input, const HertzContact& contact);

}  // namespace cntc
