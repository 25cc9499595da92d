#pragma once
/// Where iterations begin, and loads that friction cannot carry.

#include <array>
#include <vector>

#include "contact/problem.hpp"

namespace rollcon {

/// A cold start: pressures (and the approach, where the normal load is given) as of a Hertzian
/// contact of the bodies cut at half the approach.
void guess_start(const Problem& problem, Iterate& iterate);
/// The contact that such a start takes: nodes whose gap, as an approach, is below low + half.
struct GuessedContact {
  double low = 0;   ///< least gap; infinite: no node can carry traction
  double half = 0;  ///< half the approach beyond it
};
GuessedContact guess_contact(const Problem& problem);
/// The approach alone.
void guess_approach(const Problem& problem, std::array<double, 4>& motion);
/// Zero tractions; unknown motions start from zero, but bodies that carry no load just touch.
void start_cold(const Problem& problem, Iterate& iterate);

/// True when the normal part's residual and load are near those of the solution: what friction can
/// carry may be judged by these pressures.
bool pressures_settled(const Problem& problem, const std::vector<double> (&lambda)[3],
                       double residual);
/// ||F_t|| >= mu F_n has no steady solution; neither has a spin moment beyond what full sliding
/// about the origin can give. On a curved frame pressures carry a part of these loads.
bool load_beyond_friction(const Problem& problem, const std::vector<double> (&lambda)[3]);

}  // namespace rollcon
