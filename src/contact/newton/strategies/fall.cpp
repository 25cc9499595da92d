/// Finds, of the several solutions of friction that falls with the slip speed, those that begin with stick: friction as
/// at rest first, then falling by degrees.

#include <algorithm>

#include "contact/newton/start.hpp"
#include "contact/newton/strategies/continuation_steps.hpp"
#include "contact/newton/strategies/strategies.hpp"

namespace rollcon {
namespace {

constexpr double rough = 1e-2;

}  // namespace

Outcome run_as_at_rest(NewtonIteration& newton) {
  const Solve& s = newton.solve();
  Prescribed given = s.given;
  given.falling = 0;
  return newton.run(
      s.goal, given,
      {.tolerance = std::max(s.tolerance, rough), .stick_first = s.given.tangential_load(), .rehearsal = true});
}

Outcome fall_from_rest(NewtonIteration& newton, const Prescribed& wanted, const RunSettings& last) {
  const Solve& s = newton.solve();
  Iterate& it = *s.iterate;
  start_cold(*s.problem, wanted, it);
  guess_start(*s.problem, wanted, it);
  const double loose = std::max(s.tolerance, 1e-6);
  Outcome outcome = newton.run(Part::normal, wanted, {.tolerance = s.goal == Part::full ? loose : s.tolerance});
  if (s.goal == Part::tangential && outcome != Outcome::converged) return outcome;
  Prescribed given = wanted;
  given.falling = 0;
  outcome = newton.run(s.goal, given, {.tolerance = loose, .stick_first = wanted.tangential_load(), .rehearsal = true});
  if (outcome != Outcome::converged) return outcome;
  // A tenth is a small step, too, where slip is small against the law's speeds.
  return continuation_steps(newton, s.problem->law->falls() ? 0.1 : 1.0, [&](double part) {
    given.falling = part;
    return part == 1 ? newton.run(s.goal, wanted, last)
                     : newton.run(s.goal, given, {.tolerance = loose, .rehearsal = true});
  });
}

}  // namespace rollcon
