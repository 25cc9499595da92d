#pragma once
/// Results of one contact on two frames of a family, the coarser one with half the intervals of the finer, both fitted
/// to the contact's edge: what they tend to (docs/theory.md, section 4).

namespace rollcon {

struct Rates;
struct SolverState;

/// Both are solved and converged. Fills fine.extrapolated and the error estimate: what finer and extrapolated results
/// differ by.
/// Of results that depend on a parameter.
Rates beyond(const Rates& fine, const Rates& coarse);
void extrapolate(SolverState& fine, const SolverState& coarse);

}  // namespace rollcon
