/// One prescribed load, found from the outside: given motions converge where given forces get stuck, and a tangential
/// load falls as its motion grows, the normal one grows with the approach.

#include <algorithm>
#include <cmath>

#include "contact/newton/start.hpp"
#include "contact/newton/strategies/strategies.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

constexpr int most_evaluations = 120;
constexpr int most_doublings = 40;     // every node slides long before that
constexpr double close_enough = 1e-4;  // of the load's terms: Newton's step takes over

// Motion m of the part, from `from` on in steps of `scale`.
Outcome bracket(NewtonIteration& newton, int m, Part part, double from, double scale, double tolerance) {
  Solve& s = newton.solve();
  const Problem& p = *s.problem;
  Iterate& it = *s.iterate;
  if (!(scale > 0) || !std::isfinite(scale)) return Outcome::not_converged;
  const double target = s.given.value[at(m)], loose = std::max(tolerance, 1e-7);
  Prescribed given = s.given;
  given.by_force[at(m)] = false;

  Outcome outcome = Outcome::converged;
  // What the load lacks (approach) or exceeds (creepages) at a given motion: falls as that grows.
  const auto excess = [&](double motion) {
    given.value[at(m)] = it.motion[at(m)] = motion;
    outcome = newton.run(part, given, {.tolerance = loose, .free_steps = 1, .rehearsal = true});
    if (m == approach && outcome == Outcome::no_contact) {
      outcome = Outcome::converged;
      guess_start(p, given, it);
    }
    const double load = load_on_body1(p, m, it.lambda).value;
    return m == approach ? target - load : load - target;
  };
  double low = from, high = low, step = scale;
  double at_low = excess(low), at_high = at_low;
  int evaluations = 1;
  while (outcome == Outcome::converged && at_low * at_high > 0 && evaluations < most_doublings) {
    if (at_low > 0)
      low = high, at_low = at_high, at_high = excess(high += step);
    else
      high = low, at_high = at_low, at_low = excess(low -= step);
    step *= 2;
    ++evaluations;
  }
  if (outcome == Outcome::converged && at_low * at_high > 0) outcome = Outcome::not_converged;
  int side = 0;
  while (outcome == Outcome::converged && evaluations < most_evaluations) {
    const double limit = close_enough * load_on_body1(p, m, it.lambda).magnitude;
    if (std::min(std::abs(at_low), std::abs(at_high)) <= limit) break;
    // Regula falsi with halved weight of the end that stays (Illinois), bisection where it stalls.
    double next = (low * at_high - high * at_low) / (at_high - at_low);
    if (!(next > low && next < high) || evaluations % 4 == 0) next = 0.5 * (low + high);
    if (!(next > low && next < high)) break;
    const double value = excess(next);
    ++evaluations;
    if (value > 0) {
      low = next, at_low = value;
      if (side == 1) at_high /= 2;
      side = 1;
    } else {
      high = next, at_high = value;
      if (side == -1) at_low /= 2;
      side = -1;
    }
  }
  if (outcome != Outcome::converged) return outcome;
  return newton.run(part, s.given, {.tolerance = tolerance, .free_steps = 2});
}

}  // namespace

Outcome bracket_creep(NewtonIteration& newton) {
  Solve& s = newton.solve();
  int m = -1;
  for (const int candidate : {xi1, xi2, spin})
    if (s.given.by_force[at(candidate)]) {
      if (m >= 0) return Outcome::not_converged;  // several unknowns have no bracket
      m = candidate;
    }
  if (m < 0) return Outcome::not_converged;
  newton.return_to_best();
  return bracket(newton, m, s.goal, s.iterate->motion[at(m)], creep_scale(*s.problem, s.given, *s.iterate, m),
                 s.tolerance);
}

Outcome bracket_approach(NewtonIteration& newton, double tolerance) {
  Solve& s = newton.solve();
  if (!s.given.by_force[approach]) return Outcome::not_converged;
  const GuessedContact guess = guess_contact(*s.problem, s.given);
  if (!(guess.low < INFINITY)) return Outcome::not_converged;
  start_cold(*s.problem, s.given, *s.iterate);
  return bracket(newton, approach, Part::normal, guess.low, guess.half, tolerance);
}

}  // namespace rollcon
