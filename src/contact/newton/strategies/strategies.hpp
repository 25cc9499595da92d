#pragma once
/// What is tried where the full step gets stuck. Each works on a copy of what is prescribed; none changes the problem
/// that is finally solved.

#include "contact/newton/iteration.hpp"

namespace rollcon {

/// One prescribed tangential load, found by bracketing its motion from the outside: given motions converge where given
/// forces get stuck, and a load falls as its motion grows.
Outcome bracket_creep(NewtonIteration& newton);
/// Likewise under friction that falls with the slip speed, from stick on; no_solution where the load is beyond the
/// greatest on that branch.
Outcome bracket_before_fall(NewtonIteration& newton);
/// Several tangential loads likewise: all grow in proportion, and the branch is followed as far as it takes, past the
/// greatest loads on it.
Outcome follow_before_fall(NewtonIteration& newton);
/// The prescribed normal load of the normal part likewise, from the first touch on.
Outcome bracket_approach(NewtonIteration& newton, double tolerance);
/// Several prescribed tangential loads, found from the outside likewise: few unknowns, so a Newton iteration with
/// differences does.
Outcome search_creep(NewtonIteration& newton);
/// Relaxation node by node: slow, but it does not cycle between states as Newton's steps may.
Outcome relax(NewtonIteration& newton);
/// The scale r_t does not change the solution but it does change the path: a cycle between two states of a few nodes is
/// often left with another scale.
Outcome rescale_slip(NewtonIteration& newton);
/// Normal and tangential problems in turn, each with the other's tractions held, which contracts for moderate friction;
/// then the full step again.
Outcome alternate(NewtonIteration& newton);
/// Friction and the tangential loads change together, each step starting from the last solution: from none upwards, or
/// down from friction so high that nearly all sticks. The way down is for friction that is small against the strains
/// that pressures alone cause in unlike bodies.
Outcome continue_in_friction(NewtonIteration& newton, bool from_above);

/// The problem with friction as at rest, roughly: where solutions under friction that falls with slip begin.
Outcome run_as_at_rest(NewtonIteration& newton);
/// From there on by degrees: the branch of solutions that begins with stick.
Outcome fall_from_rest(NewtonIteration& newton, const Prescribed& wanted, const RunSettings& last = {});

/// Of pressures under sliding.
inline constexpr double sliding_tolerance = 1e-6;
/// The share of the loads in friction when every node slides in the direction in which that falls short of them most,
/// under the pressures of that sliding. Shares of 0: not found. Leaves the iterate anywhere.
FrictionShare slide_against_loads(NewtonIteration& newton);

}  // namespace rollcon
