/// What is tried when the full step gets stuck, cheapest first. None of it changes the problem that
/// is finally solved.

#include <algorithm>
#include <cmath>

#include "contact/newton/newton.hpp"
#include "contact/newton/start.hpp"

namespace rollcon {
namespace {

constexpr double plenty_of_friction = 0.5;

bool finished(Outcome outcome) {
  return outcome != Outcome::not_converged;
}

}  // namespace

Outcome Newton::fall_back(double tolerance, std::int64_t max_iterations) {
  Outcome outcome = Outcome::not_converged;
  const auto next = [&](Rung rung, auto attempt) {
    if (finished(outcome) || iterations_left_ <= 0) return;
    ++report_.fallbacks;
    outcome = guarded(attempt(), tolerance, max_iterations);
    report_.saved[static_cast<std::size_t>(rung)] += finished(outcome);
  };
  const bool full = goal_ == Part::full;
  next(Rung::bracket_creep, [&] { return bracket_creep(tolerance, max_iterations); });
  next(Rung::relax, [&] { return relax(tolerance, max_iterations); });
  next(Rung::search_creep, [&] { return search_creep(tolerance, max_iterations); });
  if (full)
    next(Rung::bracket_approach,
         [&] { return bracket_approach(goal_, tolerance, max_iterations); });
  next(Rung::rescale_slip, [&] { return rescale_slip(tolerance, max_iterations); });
  next(Rung::friction_from_above,
       [&] { return continue_in_friction(true, tolerance, max_iterations); });
  if (full) next(Rung::alternate, [&] { return alternate(tolerance, max_iterations); });
  next(Rung::friction_from_below,
       [&] { return continue_in_friction(false, tolerance, max_iterations); });
  return outcome;
}

// The scale r_t does not change the solution but it does change the path: a cycle between two
// states of a few nodes is often left with another scale.
Outcome Newton::rescale_slip(double tolerance, std::int64_t max_iterations) {
  const std::vector<double> kept = problem_->rt;
  Outcome outcome = Outcome::not_converged;
  for (const double factor : {3.0, 0.3, 10.0, 0.1}) {
    for (std::size_t k = 0; k < kept.size(); ++k) problem_->rt[k] = factor * kept[k];
    operators_changed();
    return_to_best();
    outcome = run(goal_, tolerance, max_iterations, iterations_of(goal_));
    if (finished(outcome) || iterations_left_ <= 0) break;
  }
  problem_->rt = kept;
  operators_changed();
  // Residuals are measured in the standard scale.
  if (outcome == Outcome::converged)
    outcome = run(goal_, tolerance, max_iterations, iterations_of(goal_));
  return outcome;
}

// Normal and tangential problems in turn, each with the other's tractions held, which contracts
// for moderate friction; then the full step again.
Outcome Newton::alternate(double tolerance, std::int64_t max_iterations) {
  constexpr int sweeps = 4, rounds = 2;
  constexpr std::int64_t iterations = 30;
  const double loose = std::max(tolerance, 1e-4);
  Outcome outcome = Outcome::not_converged;
  return_to_best();
  for (int round = 0; round < rounds && iterations_left_ > 0; ++round) {
    for (int sweep = 0; sweep < sweeps; ++sweep)
      for (const Part part : {Part::normal, Part::tangential}) {
        outcome = run(part, loose, iterations, iterations_of(part));
        if (outcome != Outcome::converged && outcome != Outcome::not_converged) return outcome;
      }
    outcome = run(goal_, tolerance, max_iterations, iterations_of(goal_));
    if (finished(outcome)) return outcome;
  }
  return outcome;
}

// Friction and the tangential loads change together, each step starting from the last solution:
// from none upwards, or down from friction so high that nearly all sticks. The way down is for
// friction that is small against the strains that pressures alone cause in unlike bodies.
Outcome Newton::continue_in_friction(bool from_above, double tolerance,
                                     std::int64_t max_iterations) {
  Problem& p = *problem_;
  const std::vector<double> mu = p.mu;
  const std::array<double, 4> value = p.value;
  const double largest = *std::max_element(mu.begin(), mu.end());
  const double top = plenty_of_friction / largest;
  if (from_above && !(top > 2 && std::isfinite(top))) return Outcome::not_converged;
  const auto factor = [&](double part) { return from_above ? std::pow(top, 1 - part) : part; };
  const auto set = [&](double part) {
    const double s = factor(part);
    for (std::size_t k = 0; k < mu.size(); ++k) p.mu[k] = s * mu[k];
    for (const int m : {xi1, xi2, spin}) {
      const auto i = static_cast<std::size_t>(m);
      if (!p.by_force[i]) continue;
      const double carried = load_of_pressures(p, m, iterate_->lambda[2]);
      p.value[i] = part < 1 ? carried + s * (value[i] - carried) : value[i];
    }
    continuing_ = part < 1;
  };
  const double loose = std::max(tolerance, 1e-6);
  Iterate& it = *iterate_;
  start_cold(*problem_, *iterate_);
  guess_start(*problem_, *iterate_);
  Outcome outcome = run(Part::normal, goal_ == Part::full ? loose : tolerance, max_iterations,
                        report_.normal_iterations);
  if (goal_ == Part::tangential && outcome != Outcome::converged) return outcome;
  if (from_above && outcome == Outcome::converged) {
    set(0);
    stick_first_ = true;
    outcome = run(goal_, loose, max_iterations, iterations_of(goal_));
    stick_first_ = false;
  }
  double done = 0, step = 0.25;
  std::vector<double> lambda[3];
  std::array<double, 4> motion{};
  while (outcome == Outcome::converged && done < 1) {
    for (int c = 0; c < 3; ++c) lambda[c] = it.lambda[c];
    motion = it.motion;
    const double next = std::min(1.0, done + step);
    set(next);
    outcome = run(goal_, next == 1 ? tolerance : loose, max_iterations, iterations_of(goal_));
    if (outcome == Outcome::converged) {
      done = next;
      step *= 1.5;
      continue;
    }
    if (outcome != Outcome::not_converged || step < 1e-3 || iterations_left_ <= 0) break;
    step *= 0.4;
    for (int c = 0; c < 3; ++c) it.lambda[c] = lambda[c];
    it.motion = motion;
    it.invalidate();
    outcome = Outcome::converged;
  }
  continuing_ = false;
  p.mu = mu;
  p.value = value;
  return outcome;
}

}  // namespace rollcon
