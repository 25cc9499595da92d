/// Reaches the problem by way of others: another scale of slip, one part after the other, more or less friction.

#include <algorithm>
#include <cmath>

#include "contact/newton/start.hpp"
#include "contact/newton/strategies/continuation_steps.hpp"
#include "contact/newton/strategies/strategies.hpp"

namespace rollcon {
namespace {

constexpr double plenty_of_friction = 0.5;

}  // namespace

Outcome rescale_slip(NewtonIteration& newton) {
  Solve& s = newton.solve();
  Prescribed given = s.given;
  Outcome outcome = Outcome::not_converged;
  for (const double factor : {3.0, 0.3, 10.0, 0.1}) {
    given.slip_scale = factor;
    newton.rows_changed();
    newton.return_to_best();
    outcome = newton.run(s.goal, given);
    if (outcome != Outcome::not_converged || s.iterations_left <= 0) break;
  }
  newton.rows_changed();
  // The last run measures residuals in the standard scale.
  return outcome == Outcome::converged ? newton.run(s.goal, s.given) : outcome;
}

Outcome alternate(NewtonIteration& newton) {
  constexpr int sweeps = 4, rounds = 2;
  constexpr std::int64_t iterations = 30;
  Solve& s = newton.solve();
  const double loose = std::max(s.tolerance, 1e-4);
  Outcome outcome = Outcome::not_converged;
  newton.return_to_best();
  for (int round = 0; round < rounds && s.iterations_left > 0; ++round) {
    for (int sweep = 0; sweep < sweeps; ++sweep)
      for (const Part part : {Part::normal, Part::tangential}) {
        outcome = newton.run(part, s.given, {.tolerance = loose, .max_iterations = iterations});
        if (outcome != Outcome::converged && outcome != Outcome::not_converged) return outcome;
      }
    outcome = newton.run(s.goal, s.given);
    if (outcome != Outcome::not_converged) return outcome;
  }
  return outcome;
}

Outcome continue_in_friction(NewtonIteration& newton, bool from_above) {
  Solve& s = newton.solve();
  const Problem& p = *s.problem;
  Iterate& it = *s.iterate;
  const double largest = s.given.friction * *std::max_element(p.mu.begin(), p.mu.end());
  const double top = plenty_of_friction / largest;
  if (from_above && !(top > 2 && std::isfinite(top))) return Outcome::not_converged;
  Prescribed given = s.given;
  const auto set = [&](double part) {
    const double factor = from_above ? std::pow(top, 1 - part) : part;
    given.friction = factor * s.given.friction;
    for (const int m : {xi1, xi2, spin}) {
      const auto i = static_cast<std::size_t>(m);
      if (!given.by_force[i]) continue;
      const double asked = s.given.value[i], carried = load_of_pressures(p, m, it.lambda[2]);
      given.value[i] = part < 1 ? carried + factor * (asked - carried) : asked;
    }
  };
  const double loose = std::max(s.tolerance, 1e-6);
  start_cold(p, s.given, it);
  guess_start(p, s.given, it);
  Outcome outcome = newton.run(Part::normal, s.given, {.tolerance = s.goal == Part::full ? loose : s.tolerance});
  if (s.goal == Part::tangential && outcome != Outcome::converged) return outcome;
  if (from_above && outcome == Outcome::converged) {
    set(0);
    outcome = newton.run(s.goal, given, {.tolerance = loose, .stick_first = true, .rehearsal = true});
  }
  if (outcome != Outcome::converged) return outcome;
  return continuation_steps(newton, 0.25, [&](double part) {
    set(part);
    return part == 1 ? newton.run(s.goal, s.given) : newton.run(s.goal, given, {.tolerance = loose, .rehearsal = true});
  });
}

}  // namespace rollcon
