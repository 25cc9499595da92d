/// Friction that falls with the slip speed has several solutions. Those sought begin with stick: friction as at rest
/// first, then falling by degrees.

#include <algorithm>
#include <array>
#include <vector>

#include "contact/newton/start.hpp"
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
  constexpr double least_step = 1e-3;
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
  std::vector<double> lambda[3];
  std::array<double, 4> motion{};
  // Where slip is small against the law's speeds a tenth is a small step, too.
  double done = 0, step = 0.1;
  while (outcome == Outcome::converged && done < 1) {
    for (int c = 0; c < 3; ++c) lambda[c] = it.lambda[c];
    motion = it.motion;
    given.falling = std::min(1.0, done + step);
    outcome = given.falling == 1 ? newton.run(s.goal, wanted, last)
                                 : newton.run(s.goal, given, {.tolerance = loose, .rehearsal = true});
    if (outcome == Outcome::converged) {
      done = given.falling;
      step *= 1.5;
      continue;
    }
    if (outcome != Outcome::not_converged || step < least_step || s.iterations_left <= 0) break;
    step *= 0.4;
    for (int c = 0; c < 3; ++c) it.lambda[c] = lambda[c];
    it.motion = motion;
    it.invalidate();
    outcome = Outcome::converged;
  }
  return outcome;
}

}  // namespace rollcon
