#pragma once
/// Reaches a problem through easier ones.

#include <algorithm>
#include <array>
#include <vector>

#include "contact/newton/iteration.hpp"

namespace rollcon {

/// Follows the solution from the iterate's, at 0, to that at 1. solve_at(part) solves the problem at this fraction of
/// the way, from the iterate. Steps grow where it converges, and are taken again, shorter, where it does not.
template <class SolveAt>
Outcome continuation_steps(NewtonIteration& newton, double step, const SolveAt& solve_at) {
  constexpr double least_step = 1e-3;
  Iterate& it = *newton.solve().iterate;
  std::vector<double> lambda[3];
  for (double done = 0; done < 1;) {
    for (int c = 0; c < 3; ++c) lambda[c] = it.lambda[c];
    const MotionValues motion = it.motion;
    const double next = std::min(1.0, done + step);
    const Outcome outcome = solve_at(next);
    if (outcome == Outcome::converged) {
      done = next;
      step *= 1.5;
      continue;
    }
    if (outcome != Outcome::not_converged || step < least_step || newton.solve().iterations_left <= 0) return outcome;
    step *= 0.4;
    for (int c = 0; c < 3; ++c) it.lambda[c] = lambda[c];
    it.motion = motion;
    it.invalidate();
  }
  return Outcome::converged;
}

}  // namespace rollcon
