/// Finds the approach of a given normal load from the outside: a given approach converges where a given load gets stuck
/// (98 of 800 small loads on quadratic elements are solved by nothing else).

#include <algorithm>
#include <cmath>

#include "contact/newton/start.hpp"
#include "contact/newton/strategies/strategies.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

constexpr int most_doublings = 40, most_evaluations = 120;
constexpr double close_enough = 1e-4;  // fraction of the load's terms, where Newton's step takes over

}  // namespace

// Doubles the approach beyond the first touch until the load is reached, and closes in by regula falsi with halved
// weight of the end that stays (Illinois), by bisection where it stalls.
Outcome bracket_approach(NewtonIteration& newton, double tolerance) {
  Solve& s = newton.solve();
  Iterate& it = *s.iterate;
  if (!s.given.by_force[approach]) return Outcome::not_converged;
  start_cold(*s.problem, s.given, it);
  const GuessedContact guess = guess_contact(*s.problem, s.given, it.motion);
  if (!(guess.low < INFINITY && guess.half > 0 && std::isfinite(guess.half))) return Outcome::not_converged;
  Prescribed given = s.given;
  given.by_force[approach] = false;
  Outcome outcome = Outcome::converged;
  LoadSum load;
  const auto lack = [&](double motion) {
    given.value[approach] = it.motion[approach] = motion;
    outcome =
        newton.run(Part::normal, given, {.tolerance = std::max(tolerance, 1e-7), .free_steps = 1, .rehearsal = true});
    if (outcome == Outcome::no_contact) {
      outcome = Outcome::converged;
      guess_start(*s.problem, given, it);
    }
    load = load_on_body1(*s.problem, approach, it.lambda);
    return s.given.value[approach] - load.value;
  };
  double low = guess.low, high = low, step = guess.half, at_low = lack(low), at_high = at_low;
  if (!(at_low > 0)) return Outcome::not_converged;
  for (int i = 0; outcome == Outcome::converged && at_high > 0; ++i, step *= 2) {
    if (i == most_doublings) return Outcome::not_converged;
    low = high, at_low = at_high, at_high = lack(high += step);
  }
  int side = 0;
  for (int i = 1; outcome == Outcome::converged && i < most_evaluations; ++i) {
    if (std::min(std::abs(at_low), std::abs(at_high)) <= close_enough * load.magnitude) break;
    double next = (low * at_high - high * at_low) / (at_high - at_low);
    if (!(next > low && next < high) || i % 4 == 0) next = 0.5 * (low + high);
    if (!(next > low && next < high)) break;
    const double value = lack(next);
    const int now = value > 0 ? 1 : -1;
    (value > 0 ? low : high) = next;
    (value > 0 ? at_low : at_high) = value;
    if (now == side) (value > 0 ? at_high : at_low) /= 2;
    side = now;
  }
  return outcome == Outcome::converged ? newton.run(Part::normal, s.given, {.tolerance = tolerance, .free_steps = 2})
                                       : outcome;
}

}  // namespace rollcon
