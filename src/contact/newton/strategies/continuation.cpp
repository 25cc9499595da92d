/// Reaches the problem by way of others: another scale of slip, one part after the other, less friction.

#include <algorithm>
#include <cmath>

#include "contact/newton/start.hpp"
#include "contact/newton/strategies/continuation_steps.hpp"
#include "contact/newton/strategies/strategies.hpp"

namespace rollcon {
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

Outcome grow_friction(NewtonIteration& newton) {
  Solve& s = newton.solve();
  const Problem& p = *s.problem;
  Iterate& it = *s.iterate;
  const double loose = std::max(s.tolerance, 1e-6);
  start_cold(p, s.given, it);
  guess_start(p, s.given, it);
  const Outcome outcome = newton.run(Part::normal, s.given, {.tolerance = s.goal == Part::full ? loose : s.tolerance});
  if (outcome != Outcome::converged) return outcome;
  Prescribed given = s.given;
  return continuation_steps(newton, 0.25, [&](double part) {
    if (part == 1) return newton.run(s.goal, s.given);
    given.friction = part * s.given.friction;
    for (const int m : {xi1, xi2, spin}) {
      const auto i = static_cast<std::size_t>(m);
      if (!given.by_force[i]) continue;
      const double carried = load_of_pressures(p, m, it.lambda[2]);
      given.value[i] = carried + part * (s.given.value[i] - carried);
    }
    return newton.run(s.goal, given, {.tolerance = loose, .rehearsal = true});
  });
}

}  // namespace rollcon
