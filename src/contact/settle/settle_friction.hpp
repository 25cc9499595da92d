#pragma once
/// Solves with friction that follows the whole solution (contact/laws/field_law.hpp), by solves with given
/// coefficients; and the temperatures of solutions.

#include <functional>
#include <span>

#include "contact/solution.hpp"

namespace rollcon {

/// solve: with the coefficients of state.given, to a tolerance; its report tells the outcome. Coefficients start from
/// those of state.settled_friction or, where it has none, from the greatest. The report becomes that of all solves.
void settle_friction(SolverState& state, double tolerance, const std::function<void(double)>& solve);

/// Of the surfaces of both bodies under the last solution, two a node. err_state: what a body does with heat is not
/// known, or it was a step in time.
void node_temperatures(SolverState& state, const BothHeats& heat, std::span<double> temperature);
/// Likewise, two a point.
void temperatures_at(SolverState& state, const BothHeats& heat, std::span<const double> x, std::span<const double> y,
                     std::span<double> temperature);

}  // namespace rollcon
