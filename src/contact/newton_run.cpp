/// The order in which Newton's parts run: normal first where the problems decouple, all together
/// where they do not, cold again where a warm start gets stuck.

#include <algorithm>
#include <cmath>

#include "contact/newton.hpp"

namespace rollcon {
namespace {

constexpr double start_tolerance = 1e-2;  // of the frictionless start of a coupled problem
constexpr std::int64_t patience = 12;     // iterations without progress before a run is stuck
constexpr double settled = 1e-3;          // normal residual below which pressures are judged
constexpr double progress = 0.7;          // factor on the best residual that counts as progress

}  // namespace

Outcome Newton::run(Part part, double tolerance, std::int64_t max_iterations,
                    std::int64_t& iterations) {
  freeze_other_part(part);
  merits_.clear();
  StepRecord record;
  record.part = part;
  double last_worst = INFINITY, best = INFINITY;
  std::int64_t waiting = 0;
  for (std::int64_t k = 0;; ++k) {
    const Residual residual = evaluate(part);
    record.iteration = k;
    record.residual_normal = residual.normal;
    record.residual_tangential = residual.tangential;
    record.contact = residual.contact;
    record.sliding = residual.sliding;
    if (part != Part::tangential) report_.residual_normal = residual.normal;
    if (part != Part::normal) report_.residual_tangential = residual.tangential;
    if (monitor_->step(record)) return Outcome::cancelled;
    const double worst = residual.worst(part);
    if (!std::isfinite(worst)) return Outcome::not_converged;
    if (residual.contact == 0) {
      if (part == Part::tangential || !problem_->by_force[approach]) {
        Iterate& it = *iterate_;
        const bool loaded =
            std::any_of(it.lambda[2].begin(), it.lambda[2].end(), [](double l) { return l != 0; });
        if (!loaded) return Outcome::no_contact;
        it.clear_tractions();
        continue;
      }
      if (k > 1) return Outcome::not_converged;
      guess_start();
      if (k == 1) fit_approach();
      continue;
    }
    if (worst <= tolerance) return Outcome::converged;
    waiting = worst < progress * best ? 0 : waiting + 1;
    best = std::min(best, worst);
    remember_best(part, worst);
    if (waiting > patience) return Outcome::not_converged;
    if (k >= max_iterations || iterations_left_ <= 0) return Outcome::not_converged;
    if (part != Part::normal && pressures_settled(part, residual.normal) && load_beyond_friction())
      return Outcome::no_solution;
    // Forcing term: the linear residual need not be smaller than the next Newton residual can be.
    const double forcing =
        std::clamp(0.1 * std::min(worst, last_worst > 0 ? worst / last_worst : 1.0),
                   std::min(1e-2, 0.05 * tolerance / std::max(worst, tolerance)), 1e-2);
    last_worst = worst;
    if (!newton_step(part, std::max(forcing, 1e-13))) return Outcome::not_converged;
    if (stick_first_) free_steps_ = 1;
    stick_first_ = false;
    record.step = line_search(part, trial_merit(part, 0));
    advance(part, record.step);
    ++iterations;
    --iterations_left_;
  }
}

// True when the pressures are near those of the solution: capacities may be judged by them.
bool Newton::pressures_settled(Part part, double residual) const {
  if (part == Part::tangential) return true;
  if (!(residual < settled)) return false;
  if (!problem_->by_force[approach]) return true;
  const double load = problem_->value[approach];
  return std::abs(load_on_body1(*problem_, approach, iterate_->lambda).value - load) <=
         settled * load;
}

// ||F_t|| >= mu F_n has no steady solution; neither has a spin moment beyond what full sliding
// about the origin can give. On a curved frame pressures carry a part of these loads.
bool Newton::load_beyond_friction() const {
  const Problem& p = *problem_;
  const bool f1 = p.by_force[xi1], f2 = p.by_force[xi2], m = p.by_force[spin];
  if (!f1 && !f2 && !m) return false;
  const bool curved = !p.turn.empty();
  double scale = 1;
  if (p.by_force[approach]) {  // to the load that will be carried in the end
    const double carried = load_on_body1(p, approach, iterate_->lambda).value;
    if (!(carried > 0)) return false;
    scale = p.value[approach] / carried;
  }
  const auto by_friction = [&](int motion) {
    const auto k = static_cast<std::size_t>(motion);
    if (!p.by_force[k]) return 0.0;
    return p.value[k] - scale * load_of_pressures(p, motion, iterate_->lambda[2]);
  };
  const double along = by_friction(xi1), across = by_friction(xi2);
  const double force = std::hypot(along, across);
  // The part of a node's friction that can act in the direction of the force.
  const auto share = [&](std::size_t k) {
    if (!curved || !(force > 0)) return 1.0;
    const Turn& t = p.turn[k];
    return std::hypot(t[0][0] * along + t[0][1] * across, t[1][0] * along + t[1][1] * across) /
           force;
  };
  double capacity = 0, moment = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(p.nodes); ++k) {
    const double limit = -p.mu[k] * iterate_->lambda[2][k] * p.weight[k];
    capacity += limit * share(k);
    moment += std::abs(limit) * std::hypot(p.op.slip_x[k], p.op.slip_y[k]);
  }
  capacity *= scale;
  moment *= scale;
  // On a curved frame the share of friction in the normal load is not settled before the end.
  const double margin = curved && p.by_force[approach] ? 2 * settled : -1e-12;
  const double spin_moment = std::abs(by_friction(spin));
  return (force > 0 && force >= capacity * (1 + margin)) ||
         (m && spin_moment > 0 && spin_moment >= moment);
}

void Newton::remember_best(Part part, double worst) {
  if (part != goal_ || continuing_ || !(worst < best_.worst)) return;
  best_.worst = worst;
  best_.residual_normal = report_.residual_normal;
  best_.residual_tangential = report_.residual_tangential;
  for (int c = 0; c < 3; ++c) best_.lambda[c] = iterate_->lambda[c];
  best_.motion = iterate_->motion;
}

void Newton::return_to_best() {
  if (!std::isfinite(best_.worst)) return;
  report_.residual_normal = best_.residual_normal;
  report_.residual_tangential = best_.residual_tangential;
  for (int c = 0; c < 3; ++c) iterate_->lambda[c] = best_.lambda[c];
  iterate_->motion = best_.motion;
  iterate_->invalidate();
}

// Zero tractions; unknown motions start from zero, but bodies that carry no load just touch.
void Newton::start_cold() {
  Iterate& it = *iterate_;
  it.clear();
  for (int m = 0; m < 4; ++m) {
    const auto k = static_cast<std::size_t>(m);
    if (!problem_->by_force[k]) it.motion[k] = problem_->value[k];
  }
  if (!problem_->by_force[approach]) return;
  double low = INFINITY;
  for (std::size_t k = 0; k < problem_->gap.size(); ++k)
    if (problem_->used[k]) low = std::min(low, problem_->gap[k] / problem_->closing(k));
  if (std::isfinite(low)) it.motion[approach] = low;
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
  is_active_.resize(n);
  merits_.reserve(8);
}

Outcome Newton::attempt(bool cold, double tolerance, std::int64_t max_iterations) {
  Outcome outcome = Outcome::converged;
  if (goal_ != Part::full || cold) {
    const double enough = goal_ == Part::full ? std::max(start_tolerance, tolerance) : tolerance;
    outcome = run(Part::normal, enough, max_iterations, report_.normal_iterations);
    pressures_found_ = outcome == Outcome::converged;
  }
  if (outcome != Outcome::converged || goal_ == Part::normal) return outcome;
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
  pressures_found_ = false;
  reserve(static_cast<std::size_t>(problem.nodes));
  for (const int m : {xi1, xi2, approach, spin}) {
    const auto k = static_cast<std::size_t>(m);
    if (!problem.by_force[k])
      iterate.motion[k] = problem.value[k];
    else if (frictionless && m != approach)
      iterate.motion[k] = 0;
  }
  if (problem.by_force[approach] && !(problem.value[approach] > 0)) {
    start_cold();
    report_.outcome = Outcome::no_contact;
    return report_;
  }
  const bool cold = std::none_of(iterate.lambda[2].begin(), iterate.lambda[2].end(),
                                 [](double l) { return l != 0; });
  if (cold) guess_start();
  Outcome outcome = attempt(cold, tolerance, max_iterations);
  if (outcome == Outcome::not_converged && !cold && iterations_left_ > 0) {
    ++report_.fallbacks;
    start_cold();
    guess_start();
    outcome = attempt(true, tolerance, max_iterations);
  }
  // Without coupling the tangential problem has no meaning under pressures that were not found.
  const bool worth_while = goal_ == Part::full || (goal_ == Part::tangential && pressures_found_);
  if (outcome == Outcome::not_converged && worth_while && iterations_left_ > 0)
    outcome = fall_back(tolerance, max_iterations);
  if (outcome == Outcome::not_converged || outcome == Outcome::cancelled) return_to_best();
  report_.outcome = outcome;
  return report_;
}

}  // namespace rollcon
