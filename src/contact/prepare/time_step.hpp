#pragma once
/// Prepares and ends steps in time: their start, what of it goes into the problem, what they leave (docs/time.md).

#include "contact/prepare/preparation.hpp"
#include "contact/problem/past.hpp"
#include "contact/solution.hpp"

namespace rollcon {

/// Chooses what a step starts from, before the scene is prepared. err_state: a steady solve failed just before.
void begin_step(StepHistory& steps, const Solution& last, const Scene& scene);
/// Puts slip that the prepared scene and the step before give into the problem.
void carry_past(StepHistory& steps, Preparation& preparation, const Scene& scene);
/// Puts the iterate from which a step is solved into the solution; returns false where it was there already.
bool start_step(const StepHistory& steps, Solution& solution);
/// Makes the solution the start of the next step.
void end_step(StepHistory& steps, const Solution& solution, const Scene& scene);
/// Makes the next step start from where the last one did. err_state: there is none, or that was done already.
void repeat_step(StepHistory& steps);
/// Finds what the solved step's displacements change from the nodes to the points where their particles were, along t1
/// and t2. preparation: may be null.
void find_changes_upstream(const Solution& solution, Preparation* preparation, std::vector<double> (&change)[2]);
/// Puts the bodies at rest.
void forget_past(StepHistory& steps);

}  // namespace rollcon
