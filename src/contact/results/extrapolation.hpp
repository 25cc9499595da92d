#pragma once
/// Results of one contact on two frames of a family, the coarser one with half the intervals of the finer, both fitted
/// to the contact's edge: what they tend to (docs/theory.md, section 4).

namespace rollcon {

struct Rates;
struct SolverState;

/// What is known of frames of one family.
struct FrameFamily {
  double order = 2;        ///< of errors over the size of the intervals
  double cover = 1;        ///< what the contact is of the area of frames that were made too large
  double least_error = 0;  ///< where two frames may agree by chance
};

/// Both are solved and converged. Fills fine.extrapolated and the error estimate: what finer and extrapolated results
/// differ by.
void extrapolate(SolverState& fine, const SolverState& coarse, const FrameFamily& family);
/// Of results of both that depend on a parameter.
Rates beyond(const SolverState& fine, const Rates& of_fine, const Rates& of_coarse);

}  // namespace rollcon
