#pragma once
#include "inputs.hpp"

namespace cntc {

/// 1/E* of two half-spaces, from Poisson's ratios and shear moduli.
double contact_compliance(const Material& m);

/// Semi-axes or curvatures that are missing, by Hertz's formulas from load or approach; throws Failure.
HertzContact hertz_contact(const Inputs& in);

/// The grid of CONTACT: scale times the semi-axes to both sides.
Grid hertz_grid(const HertzInput& input, const HertzContact& contact);

}  // namespace cntc
