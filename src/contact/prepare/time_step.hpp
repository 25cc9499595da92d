#pragma once
/// Steps in time: what they start from, what of it goes into the problem, what they leave (docs/time.md).

#include "contact/solution.hpp"

namespace rollcon {

/// Before the scene is prepared. err_state: a steady solve failed just before.
void begin_step(SolverState& state, const Scene& scene);
/// After it was prepared: slip that the scene and the step before give, in the problem.
void carry_past(SolverState& state, const Scene& scene);
/// The iterate from which a step is solved.
void start_step(SolverState& state);
/// The solution becomes what the next step starts from.
void end_step(SolverState& state, const Scene& scene);
/// The next step starts from where the last one did. err_state: there is none, or that was done already.
void repeat_step(SolverState& state);
/// change[c], c = t1, t2: of the solved step's displacements, from the nodes to the points where their particles were.
void find_changes_upstream(SolverState& state, std::vector<double> (&change)[2]);
/// At rest.
void forget_past(SolverState& state);

}  // namespace rollcon
