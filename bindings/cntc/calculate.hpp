#pragma once
#include <string>
#include <vector>

#include "problem.hpp"

namespace cntc {

/// Finds the grid and the undeformed distance of module 3 from what the caller gave, by Hertz's problem where needed.
/// Throws Failure.
void fill_gap(Problem& p, Grid& grid, std::vector<double>& gap);

/// Solves the case of a contact of module 3, or of a wheel; returns CONTACT's error code, and the reason in why.
int solve_gap(Problem& p, std::string& why);
int solve_wheel(Problem& p, std::string& why);

/// Refuses what rollcon does not have; throws Failure with the error code of cntc_calculate.
void refuse_absent(const Problem& p);

/// Adds damping of the contact (M2 = 2) to the forces: F + c dF/dt, with the rate within bounds.
void add_damping(Problem& p, ContactResult& r);

}  // namespace cntc
