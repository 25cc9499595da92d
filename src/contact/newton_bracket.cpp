/// One prescribed tangential force or spin moment, found from the outside: given motions converge
/// where given forces get stuck, and the load falls as its motion grows.

#include <algorithm>
#include <cmath>

#include "contact/newton.hpp"

namespace rollcon {
namespace {

constexpr int most_evaluations = 40;
constexpr double close_enough = 1e-4;  // of the load's terms: Newton's step takes over

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

// Creepage (or spin) whose slip corresponds to the mean friction bound.
double Newton::creep_scale(int m) const {
  const Problem& p = *problem_;
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < p.gap.size(); ++k) {
    if (!(iterate_->lambda[2][k] < 0) || !(p.rt[k] > 0)) continue;
    sum += -p.mu[k] * iterate_->lambda[2][k] / p.rt[k];
    ++count;
  }
  if (!(sum > 0)) return 0;
  return sum / count / (m == spin ? p.length : 1);
}

Outcome Newton::bracket_creep(double tolerance, std::int64_t max_iterations) {
  Problem& p = *problem_;
  int m = -1;
  for (const int candidate : {xi1, xi2, spin})
    if (p.by_force[at(candidate)]) {
      if (m >= 0) return Outcome::not_converged;  // several unknowns have no bracket
      m = candidate;
    }
  if (m < 0) return Outcome::not_converged;
  return_to_best();
  Iterate& it = *iterate_;
  const double target = p.value[at(m)], scale = creep_scale(m);
  if (!(scale > 0) || !std::isfinite(scale)) return Outcome::not_converged;
  const double loose = std::max(tolerance, 1e-7);

  Outcome outcome = Outcome::converged;
  const auto excess = [&](double motion) {  // load minus target at a given motion
    p.value[at(m)] = it.motion[at(m)] = motion;
    free_steps_ = 1;
    outcome = run(goal_, loose, max_iterations, iterations_of(goal_));
    free_steps_ = 0;
    return load_on_body1(p, m, it.lambda).value - target;
  };
  p.by_force[at(m)] = false;
  continuing_ = true;
  double low = it.motion[at(m)], high = low, step = scale;
  double at_low = excess(low), at_high = at_low;
  int evaluations = 1;
  while (outcome == Outcome::converged && at_low * at_high > 0 && evaluations < most_evaluations) {
    // The load falls as the motion grows.
    if (at_low > 0)
      low = high, at_low = at_high, at_high = excess(high += step);
    else
      high = low, at_high = at_low, at_low = excess(low -= step);
    step *= 2;
    ++evaluations;
  }
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
  continuing_ = false;
  p.by_force[at(m)] = true;
  p.value[at(m)] = target;
  if (outcome != Outcome::converged) return outcome;
  free_steps_ = 2;
  outcome = run(goal_, tolerance, max_iterations, iterations_of(goal_));
  free_steps_ = 0;
  return outcome;
}

}  // namespace rollcon
