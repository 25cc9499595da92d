#pragma once
/// Finds where iterations begin.

#include <array>
#include <vector>

#include "contact/problem/problem.hpp"

namespace rollcon {

/// Makes a cold start: pressures (and the approach, where the normal load is given) of a Hertzian contact of the bodies
/// cut at half the approach.
void guess_start(const Problem& problem, const Prescribed& given, Iterate& iterate);
/// Holds the contact that a cold start takes: nodes whose gap, as an approach, is below low + half.
struct GuessedContact {
  double low = 0;   ///< least gap; infinite: no node can carry traction
  double half = 0;  ///< half the approach beyond it
};
GuessedContact guess_contact(const Problem& problem, const Prescribed& given, const MotionValues& motion);
/// Guesses the approach alone.
void guess_approach(const Problem& problem, const Prescribed& given, MotionValues& motion);
/// Returns the creepage (or spin) at which friction saturates: its slip is that of the mean friction bound, or of the
/// tractions that there are if that is more (between unlike bodies pressures cause slip). 0: no node in contact.
double creep_scale(const Problem& problem, const Prescribed& given, const Iterate& iterate, int motion);
/// Sets tractions to zero; unknown motions start from zero, but bodies that carry no load just touch.
void start_cold(const Problem& problem, const Prescribed& given, Iterate& iterate);

}  // namespace rollcon
