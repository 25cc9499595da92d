#pragma once
/// Finds what results of one contact tend to from two frames of a family, the coarser one with half the intervals of
/// the finer, both fitted to the contact's edge (docs/theory.md, section 4).

#include <functional>

#include "contact/derived.hpp"

namespace rollcon {

/// Holds what is known of frames of one family.
struct FrameFamily {
  double order = 2;             ///< order of errors in the size of the intervals
  double cover = 1;             ///< fraction that the contact covers of frames that were made too large
  double least_error = 0;       ///< least error to assume, as two frames may agree by chance
  double least_tangential = 0;  ///< least error to assume of tangential results
  double counted = 1;           ///< estimate over the step from the finer frame to what is extrapolated
};

/// Holds what the two frames tend to, and the difference of the finer frame's results from that. Both solutions
/// converged. rates: those of the finer frame.
struct Extrapolation {
  Extrapolated results;
  ErrorEstimate estimate;
};
Extrapolation extrapolate(const Solution& fine, const Solution& coarse, const FrameFamily& family,
                          const std::function<const Rates&(Parameter)>& rates);
/// Returns what the rates of both frames tend to.
Rates beyond(const Extrapolated& results, const Rates& of_fine, const Rates& of_coarse);

}  // namespace rollcon
