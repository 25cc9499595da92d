#pragma once
/// Finds the largest mean pressure over a length, which has a bound where the pressure itself has none.

#include "contact/solution.hpp"

namespace rollcon {

/// Returns the largest mean of pressures, linear between nodes, over lines of this length along t2; 0 where nothing is
/// in contact. What is not in contact counts as 0.
double largest_mean_pressure(const Solution& s, double length);

}  // namespace rollcon
