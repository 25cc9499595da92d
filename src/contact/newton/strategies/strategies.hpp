#pragma once
/// Lists what is tried where the full step gets stuck. Each works on a copy of what is prescribed; none changes the
/// problem that is finally solved.

#include "contact/newton/iteration.hpp"

namespace rollcon {

// Numbers say how many of 9,675 solves, of which 36 do not converge, are lost without a fallback (docs/stability.md).

/// Brackets the approach for the normal part's prescribed load, from the first touch on. (Of 800 small loads on
/// quadratic elements 98 are lost without it.)
Outcome bracket_approach(NewtonIteration& newton, double tolerance);
/// Finds prescribed tangential loads from the outside: by damped steps of the motions, or on the branch that begins
/// with stick; no_solution where friction falls and the loads are beyond the greatest on that branch. (60)
Outcome follow_loads(NewtonIteration& newton);
/// Solves with another scale r_t, which does not change the solution but does change the path: a cycle between two
/// states of a few nodes is often left. (6)
Outcome rescale_slip(NewtonIteration& newton);
/// Solves normal and tangential problems in turn, each with the other's tractions held, which contracts for moderate
/// friction; then takes the full step again. (8)
Outcome alternate(NewtonIteration& newton);
/// Grows friction and the tangential loads together from none, each step starting from the last solution. (28)
Outcome grow_friction(NewtonIteration& newton);

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
