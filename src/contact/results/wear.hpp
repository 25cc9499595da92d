#pragma once
/// Finds the material that rolling with slip takes off, by a law of wear.

#include <array>
#include <span>

#include "contact/derived.hpp"
#include "contact/laws/wear_law.hpp"

namespace rollcon {

/// Adds `share` times the volume per length rolled that belongs to the function that is 1 at y[j], 0 at the other y and
/// linear between; y ascending, along t2. Each node's volume is spread over as much of t2 as its elements cover, and
/// what lies beyond the ends is given to them: no volume is lost. Where the balance of work holds (power_is_balanced),
/// the whole is the law's part of its power: slip at nodes misses much of it on coarse frames. Returns the whole volume
/// (without that factor).
double add_wear(const Solution& solution, Derived& derived, const WearLaw& law, std::span<const double> y, double share,
                double* volume);

/// Returns the least and the greatest t2 of nodes in contact; without contact the first is above the second.
std::array<double, 2> contact_across(const Solution& state);

}  // namespace rollcon
