#pragma once
/// Results of one contact on two frames of a family, the coarser one with half the intervals of the finer, both fitted
/// to the contact's edge: what they tend to (docs/theory.md, section 4).

#include <functional>

#include "contact/derived.hpp"

namespace rollcon {

/// What is known of frames of one family.
struct FrameFamily {
  double order = 2;        ///< of errors over the size of the intervals
  double cover = 1;        ///< what the contact is of the area of frames that were made too large
  double least_error = 0;  ///< where two frames may agree by chance
};

/// What the two frames tend to and what the finer frame's and the extrapolated results differ by. Both solutions
/// converged. rates: of the finer one.
struct Extrapolation {
  Extrapolated results;
  ErrorEstimate estimate;
};
Extrapolation extrapolate(const Solution& fine, const Solution& coarse, const FrameFamily& family,
                          const std::function<const Rates&(Parameter)>& rates);
/// What rates of both tend to.
Rates beyond(const Extrapolated& results, const Rates& of_fine, const Rates& of_coarse);

}  // namespace rollcon
