/// One prescribed load, found from the outside: given motions converge where given forces get
/// stuck, and a tangential load falls as its motion grows, the normal one grows with the approach.

#include <algorithm>
#include <cmath>

#include "contact/newton/newton.hpp"
#include "contact/newton/start.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

constexpr int most_evaluations = 120;
constexpr int most_doublings = 40;     // every node slides long before that
constexpr double close_enough = 1e-4;  // of the load's terms: Newton's step takes over

}  // namespace

// Creepage (or spin) at which friction saturates: its slip is that of the mean friction bound, or
// of the tractions that there are if that is more (between unlike bodies pressures cause slip).
double Newton::creep_scale(int m) const {
  const Problem& p = *problem_;
  double sum = 0, count = 0, slip = 0;
  for (std::size_t k = 0; k < p.gap.size(); ++k) {
    if (!(iterate_->lambda[2][k] < 0) || !(p.rt[k] > 0)) continue;
    sum += -p.mu[k] * iterate_->lambda[2][k] / p.rt[k];
    ++count;
    for (const auto& image : {iterate_->image[0][k], iterate_->image[1][k]})
      if (std::isfinite(image)) slip = std::max(slip, std::abs(image));
  }
  if (!(sum > 0)) return 0;
  return std::max(sum / count, slip) / (m == spin ? p.length : 1);
}

Outcome Newton::bracket_creep(double tolerance, std::int64_t max_iterations) {
  const Problem& p = *problem_;
  int m = -1;
  for (const int candidate : {xi1, xi2, spin})
    if (p.by_force[at(candidate)]) {
      if (m >= 0) return Outcome::not_converged;  // several unknowns have no bracket
      m = candidate;
    }
  if (m < 0) return Outcome::not_converged;
  return_to_best();
  return bracket(m, goal_, iterate_->motion[at(m)], creep_scale(m), tolerance, max_iterations);
}

// From the first touch on.
Outcome Newton::bracket_approach(Part part, double tolerance, std::int64_t max_iterations) {
  if (!problem_->by_force[approach]) return Outcome::not_converged;
  const GuessedContact guess = guess_contact(*problem_);
  if (!(guess.low < INFINITY)) return Outcome::not_converged;
  start_cold(*problem_, *iterate_);
  return bracket(approach, part, guess.low, guess.half, tolerance, max_iterations);
}

Outcome Newton::bracket(int m, Part part, double from, double scale, double tolerance,
                        std::int64_t max_iterations) {
  Problem& p = *problem_;
  Iterate& it = *iterate_;
  if (!(scale > 0) || !std::isfinite(scale)) return Outcome::not_converged;
  const double target = p.value[at(m)], loose = std::max(tolerance, 1e-7);

  Outcome outcome = Outcome::converged;
  // What the load lacks (approach) or exceeds (creepages) at a given motion: falls as that grows.
  const auto excess = [&](double motion) {
    p.value[at(m)] = it.motion[at(m)] = motion;
    free_steps_ = 1;
    outcome = run(part, loose, max_iterations, iterations_of(part));
    free_steps_ = 0;
    if (m == approach && outcome == Outcome::no_contact) {
      outcome = Outcome::converged;
      guess_start(p, it);
    }
    const double load = load_on_body1(p, m, it.lambda).value;
    // Forces that friction cannot carry yet: the bodies are still too far apart.
    if (m == approach && outcome == Outcome::no_solution && load < target)
      outcome = Outcome::converged;
    return m == approach ? target - load : load - target;
  };
  p.by_force[at(m)] = false;
  continuing_ = true;
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
  continuing_ = false;
  p.by_force[at(m)] = true;
  p.value[at(m)] = target;
  if (outcome != Outcome::converged) return outcome;
  free_steps_ = 2;
  outcome = run(part, tolerance, max_iterations, iterations_of(part));
  free_steps_ = 0;
  return outcome;
}

}  // namespace rollcon
