#pragma once
#include <string>
#include <vector>

#include "problem.hpp"

namespace cntc {

/// Grid and undeformed distance that module 3 was given; Hertz's problem is solved for them. Throws Failure.
void fill_gap(Problem& p, Grid& grid, std::vector<double>& gap);

/// Solves the case of a contact of module 3, or of a wheel; returns CONTACT's error code and why in words.
int solve_gap(Problem& p, std::string& why);
int solve_wheel(Problem& p, std::string& why);

/// Says what is not there at all; throws Failure with the code of cntc_calculate.
void refuse_absent(const Problem& p);

/// Forces with damping of the contact (M2 = 2): F + c dF/dt, with the rate within bounds.
void add_damping(Problem& p, ContactResult& r);

}  // namespace cntc
