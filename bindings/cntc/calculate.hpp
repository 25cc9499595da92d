#pragma once
#include <string>
#include <vector>

#include "problem.hpp"

namespace cntc {

/// Returns 1/E* of two half-spaces, from Poisson's ratios and shear moduli.
double contact_compliance(const Material& m);

/// Finds the missing semi-axes or curvatures by Hertz's formulas, from load or approach; throws Failure.
HertzContact hertz_contact(const Inputs& in);

/// Returns CONTACT's grid: it reaches scale times the semi-axes to both sides.
Grid hertz_grid(const HertzInput& input, const HertzContact& contact);

/// Finds the grid and the undeformed distance of module 3 from what the caller gave, by Hertz's problem where needed.
/// Throws Failure.
void fill_gap(Problem& p, Grid& grid, std::vector<double>& gap);

/// Solves the case of a contact of module 3, or of a wheel; returns CONTACT's error code, and the reason in why.
int solve_gap(Problem& p, std::string& why);
int solve_wheel(Problem& p, std::string& why);

/// Refuses what rollcon does not have; throws Failure with the error code of cntc_calculate.
void refuse_absent(const Problem& p);

}  // namespace cntc
