/// The order in which Newton's parts run: normal first where the problems decouple, all together
/// where they do not, cold again where a warm start gets stuck.

#include <algorithm>
#include <cmath>

#include "contact/newton/newton.hpp"
#include "contact/newton/start.hpp"

namespace rollcon {
namespace {

constexpr double start_tolerance = 1e-2;  // of the frictionless start of a coupled problem
constexpr std::int64_t patience = 12;     // iterations without progress before a run is stuck
constexpr double much_more = 1e3;         // times the traction found in the end
constexpr double clearly = 0.05;          // beyond sliding, before fallbacks are tried
constexpr double progress = 0.7;          // factor on the best residual that counts as progress

}  // namespace

Outcome Newton::run(Part part, double tolerance, std::int64_t max_iterations,
                    std::int64_t& iterations) {
  freeze_other_part(part);
  images_fresh_ = false;
  merits_.clear();
  StepRecord record;
  record.part = part;
  double last_worst = INFINITY, best = INFINITY, last_merit = 0, eta = 0;
  double largest = 0;  // traction since the images were made
  const auto traction_of = [&](const Residual& r) {
    return part == Part::normal ? r.pressure
           : part == Part::tangential
               ? r.traction
               : std::min(r.pressure, r.traction > 0 ? r.traction : r.pressure);
  };
  std::int64_t waiting = 0;
  for (std::int64_t k = 0;; ++k) {
    Residual residual = evaluate(part);
    if (k == 0 && prediction_ratio_ != 0 && !residual.within(part, tolerance) &&
        start_predicted(part))
      residual = evaluate(part);
    record.iteration = k;
    record.merit = residual.merit;
    record.residual_normal = residual.normal;
    record.residual_tangential = residual.tangential;
    record.contact = residual.contact;
    record.sliding = residual.sliding;
    if (part != Part::tangential) report_.residual_normal = residual.normal;
    if (part != Part::normal) report_.residual_tangential = residual.tangential;
    report_.residual_load = residual.load;
    if (monitor_->step(record)) return Outcome::cancelled;
    const double worst = residual.worst(part);
    // A greatest value may pass over what is not a number; a sum does not.
    if (!std::isfinite(worst) || !std::isfinite(residual.merit)) return Outcome::not_converged;
    if (residual.contact == 0) {
      if (part == Part::tangential || !problem_->by_force[approach]) {
        Iterate& it = *iterate_;
        const bool loaded =
            std::any_of(it.lambda[2].begin(), it.lambda[2].end(), [](double l) { return l != 0; });
        // Of a coupled problem, friction alone cannot tell whether the bodies touch.
        const bool open = part != Part::tangential || goal_ != Part::full;
        if (!loaded) return open ? Outcome::no_contact : Outcome::not_converged;
        it.clear_tractions();
        continue;
      }
      if (k > 1) return Outcome::not_converged;
      guess_start(*problem_, *iterate_);
      if (k == 1) fit_approach();
      continue;
    }
    largest = std::max(largest, traction_of(residual));
    if (residual.within(part, tolerance)) {
      // Images follow the steps. On the way from a load beyond all comparison they keep its
      // rounding.
      if (largest <= much_more * traction_of(residual)) return Outcome::converged;
      largest = traction_of(residual);
      images_fresh_ = false;
      iterate_->invalidate();
      freeze_other_part(part);
      continue;
    }
    waiting = worst < progress * best ? 0 : waiting + 1;
    best = std::min(best, worst);
    remember_best(part, worst);
    if (waiting > patience) return Outcome::not_converged;
    if (k >= max_iterations || iterations_left_ <= 0) return Outcome::not_converged;
    if (beyond_friction(part, k, residual.normal)) return Outcome::no_solution;
    // Forcing term: the linear residual need not be smaller than the next Newton residual can be.
    double forcing = std::clamp(
        k == 0 ? 1e-3 * worst : 0.1 * std::min(worst, last_worst > 0 ? worst / last_worst : 1.0),
        std::min(1e-2, 0.05 * tolerance / std::max(worst, tolerance)), 1e-2);
    if (procedure.eta > 0) forcing = procedure.eta;
    if (procedure.linear == LinearMethod::gmres_adaptive)
      forcing = eta = adaptive_tolerance(procedure, residual.merit, last_merit, eta);
    last_worst = worst;
    last_merit = residual.merit;
    if (!newton_step(part, std::max(forcing, 1e-13))) return Outcome::not_converged;
    if (stick_first_) free_steps_ = 1;
    stick_first_ = false;
    record.step = line_search(part, trial_merit(part, 0));
    advance(part, record.step);
    ++iterations;
    --iterations_left_;
  }
}

void Newton::remember_best(Part part, double worst) {
  if (part != goal_ || continuing_ || !(worst < best_.worst)) return;
  best_.worst = worst;
  best_.residual_normal = report_.residual_normal;
  best_.residual_tangential = report_.residual_tangential;
  best_.residual_load = report_.residual_load;
  for (int c = 0; c < 3; ++c) best_.lambda[c] = iterate_->lambda[c];
  best_.motion = iterate_->motion;
}

void Newton::return_to_best() {
  if (!std::isfinite(best_.worst)) {
    // Nothing to return to; but what is not finite must not be handed on.
    const Iterate& it = *iterate_;
    bool finite = true;
    for (const auto& lambda : it.lambda)
      for (const double l : lambda) finite = finite && std::isfinite(l);
    for (const double m : it.motion) finite = finite && std::isfinite(m);
    if (!finite) start_cold(*problem_, *iterate_);
    return;
  }
  report_.residual_normal = best_.residual_normal;
  report_.residual_tangential = best_.residual_tangential;
  report_.residual_load = best_.residual_load;
  for (int c = 0; c < 3; ++c) iterate_->lambda[c] = best_.lambda[c];
  iterate_->motion = best_.motion;
  iterate_->invalidate();
}

void Newton::reserve(std::size_t n) {
  for (int c = 0; c < 3; ++c) {
    next_[c].resize(n);
    next_image_[c].resize(n);
    frozen_[c].resize(n);
    known_[c].reserve(n);
    best_.lambda[c].resize(n);
  }
  active_.reserve(n);
  judged_.reserve(n);
  is_active_.resize(n);
  merits_.reserve(8);
}

Outcome Newton::attempt(bool cold, double tolerance, std::int64_t max_iterations) {
  Outcome outcome = Outcome::converged;
  if (goal_ != Part::full || cold) {
    const double enough = goal_ == Part::full ? std::max(start_tolerance, tolerance) : tolerance;
    outcome = run(Part::normal, enough, max_iterations, report_.normal_iterations);
    if (outcome == Outcome::not_converged && iterations_left_ > 0) {
      ++report_.fallbacks;
      outcome = bracket_approach(Part::normal, enough, max_iterations);
      report_.saved[static_cast<std::size_t>(Rung::approach_of_pressures)] +=
          outcome == Outcome::converged;
    }
    pressures_found_ = outcome == Outcome::converged;
    judged_ = iterate_->lambda[2];
    judged_approach_ = iterate_->motion[approach];
  }
  if (outcome != Outcome::converged || goal_ == Part::normal) return outcome;
  if (look_for_sliding && goal_ == Part::tangential && sliding_.given(*problem_, *iterate_))
    report_.sliding_steps += sliding_.solve(*problem_, *iterate_, tolerance / 2);
  if (report_.sliding_steps > 0) prediction_ratio_ = 0;
  free_steps_ = cold ? 0 : 2;
  // With creepages still unknown there is no slip direction to start from: full stick finds both
  // (15 to 9 iterations on the linear quadrilaterals of the sphere example).
  const auto& by_force = problem_->by_force;
  stick_first_ = cold && (by_force[xi1] || by_force[xi2] || by_force[spin]);
  outcome = run(goal_, tolerance, max_iterations, iterations_of(goal_));
  free_steps_ = 0;
  return outcome;
}

Part Newton::goal(const Problem& problem, bool frictionless) {
  if (frictionless) return Part::normal;
  // Tangential tractions carry a part of the normal load of a curved frame.
  const bool together = problem.op.coupled || (!problem.turn.empty() && problem.by_force[approach]);
  return together ? Part::full : Part::tangential;
}

NewtonReport Newton::solve(Problem& problem, Iterate& iterate, bool frictionless, double tolerance,
                           std::int64_t max_iterations, Monitor& monitor) {
  problem_ = &problem;
  iterate_ = &iterate;
  monitor_ = &monitor;
  report_ = {};
  iterations_left_ = max_iterations;
  linear.forget_exact();
  goal_ = goal(problem, frictionless);
  best_.worst = INFINITY;
  pressures_found_ = compared_ = false;
  reserve(static_cast<std::size_t>(problem.nodes));
  begin_prediction();
  for (const int m : {xi1, xi2, approach, spin}) {
    const auto k = static_cast<std::size_t>(m);
    if (!problem.by_force[k])
      iterate.motion[k] = problem.value[k];
    else if (frictionless && m != approach)
      iterate.motion[k] = 0;
  }
  if (problem.by_force[approach] && !(problem.value[approach] > 0)) {
    start_cold(problem, iterate);
    report_.outcome = Outcome::no_contact;
    return report_;
  }
  const bool cold = std::none_of(iterate.lambda[2].begin(), iterate.lambda[2].end(),
                                 [](double l) { return l != 0; });
  if (cold) {
    prediction_.forget();
    prediction_ratio_ = 0;
    guess_start(problem, iterate);
  }
  Outcome outcome = guarded(attempt(cold, tolerance, max_iterations), tolerance, max_iterations);
  prediction_ratio_ = 0;
  if (outcome == Outcome::not_converged && beyond_sliding(clearly)) outcome = Outcome::no_solution;
  if (outcome == Outcome::not_converged && !cold && iterations_left_ > 0) {
    ++report_.fallbacks;
    start_cold(problem, iterate);
    guess_start(problem, iterate);
    outcome = guarded(attempt(true, tolerance, max_iterations), tolerance, max_iterations);
    report_.saved[static_cast<std::size_t>(Rung::cold)] += outcome == Outcome::converged;
  }
  if (outcome == Outcome::not_converged && beyond_sliding(clearly)) outcome = Outcome::no_solution;
  // Without coupling the tangential problem has no meaning under pressures that were not found.
  const bool worth_while = goal_ == Part::full || (goal_ == Part::tangential && pressures_found_);
  if (outcome == Outcome::not_converged && worth_while && iterations_left_ > 0)
    outcome = fall_back(tolerance, max_iterations);
  if (outcome == Outcome::not_converged || outcome == Outcome::cancelled) return_to_best();
  if (outcome == Outcome::not_converged && beyond_sliding(0)) outcome = Outcome::no_solution;
  if (predict && outcome == Outcome::converged)
    prediction_.solved();
  else
    prediction_.forget();
  report_.outcome = outcome;
  return report_;
}

}  // namespace rollcon
