#pragma once
/// Lists what is tried where the full step gets stuck. Each works on a copy of what is prescribed; none changes the
/// problem that is finally solved.

#include "contact/newton/iteration.hpp"

namespace rollcon {

/// Finds one prescribed tangential load by bracketing its motion from the outside: given motions converge where given
/// forces get stuck, and a load falls as its motion grows.
Outcome bracket_creep(NewtonIteration& newton);
/// Brackets one load under friction that falls with the slip speed, from stick on; no_solution where the load is beyond
/// the greatest on that branch.
Outcome bracket_before_fall(NewtonIteration& newton);
/// Follows the branch of several loads, which grow in proportion, under falling friction as far as it takes, past the
/// greatest loads on it.
Outcome follow_before_fall(NewtonIteration& newton);
/// Brackets the approach for the normal part's prescribed load, from the first touch on.
Outcome bracket_approach(NewtonIteration& newton, double tolerance);
/// Finds several prescribed tangential loads from the outside: few unknowns, so a Newton iteration with differences
/// does.
Outcome search_creep(NewtonIteration& newton);
/// Relaxes node by node: slow, but it does not cycle between states as Newton's steps may.
Outcome relax(NewtonIteration& newton);
/// Solves with another scale r_t, which does not change the solution but does change the path: a cycle between two
/// states of a few nodes is often left.
Outcome rescale_slip(NewtonIteration& newton);
/// Solves normal and tangential problems in turn, each with the other's tractions held, which contracts for moderate
/// friction; then takes the full step again.
Outcome alternate(NewtonIteration& newton);
/// Changes friction and the tangential loads together, each step starting from the last solution: from none upwards, or
/// down from friction so high that nearly all sticks. The way down is for friction that is small against the strains
/// that pressures alone cause in unlike bodies.
Outcome continue_in_friction(NewtonIteration& newton, bool from_above);

/// Solves the problem with friction as at rest, roughly: solutions under friction that falls with slip begin there.
Outcome run_as_at_rest(NewtonIteration& newton);
/// Goes on from rest by degrees: the branch of solutions that begins with stick.
Outcome fall_from_rest(NewtonIteration& newton, const Prescribed& wanted, const RunSettings& last = {});

/// Tolerance of pressures under sliding.
inline constexpr double sliding_tolerance = 1e-6;
/// Finds the utilisation of friction by the loads when every node slides in the direction in which friction falls short
/// of them most, under the pressures of that sliding. 0: not found. Leaves the iterate anywhere.
FrictionShare slide_against_loads(NewtonIteration& newton);

}  // namespace rollcon
