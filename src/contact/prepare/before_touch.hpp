#pragma once
/// Finds how far particles shift within a time step before they touch (docs/time.md).

#include "contact/prepared.hpp"
#include "contact/problem/past.hpp"

namespace rollcon {

/// Puts the shift before touch into the problem. lambda: tractions of the step before on this frame; empty on another
/// one, whose displacements at the nodes are then in work.displacement. rolls_in: the shift of particles that roll
/// in counts from touch, too, which needs a regular frame.
void find_shift_before_touch(const PastStep& last, const std::vector<double> (*lambda)[3], StepWorkspace& work,
                             Prepared& on, bool rolls_in);

}  // namespace rollcon
