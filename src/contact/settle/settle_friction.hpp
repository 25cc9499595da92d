#pragma once
/// Solves with friction that follows the whole solution (contact/laws/field_law.hpp), by solves with given
/// coefficients; and finds the temperatures of solutions.

#include <functional>
#include <span>

#include "contact/derived.hpp"

namespace rollcon {

/// Repeats solve(tolerance), which takes solution.given's coefficients and tells its outcome in the report. They start
/// from solution.settled or, where it has none, from the greatest. The report becomes that of all solves.
void settle_friction(Solution& solution, double tolerance, const std::function<void(double)>& solve);

/// Finds the temperatures of the surfaces of both bodies, two a node. err_state: what a body does with heat is not
/// known, or it was a step in time.
void node_temperatures(const Solution& solution, Derived& derived, const BothHeats& heat,
                       std::span<double> temperature);
/// Finds the temperatures at points of the frame's plane, two a point.
void temperatures_at(const Solution& solution, Derived& derived, const BothHeats& heat, std::span<const double> x,
                     std::span<const double> y, std::span<double> temperature);

}  // namespace rollcon
