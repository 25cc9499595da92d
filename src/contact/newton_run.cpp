/// The order in which Newton's parts run: normal first where the problems decouple, all together
/// where they do not, and what is tried when a part gets stuck.

#include <algorithm>
#include <cmath>

#include "contact/newton.hpp"

namespace rollcon {
namespace {

constexpr double start_tolerance = 1e-2;   // of the frictionless start of a coupled problem
constexpr std::int64_t stuck_after = 2;    // short steps in a row
constexpr double short_step = 1.0 / 8;
constexpr std::int64_t sweeps = 12;        // normal-tangential sweeps at most
constexpr std::int64_t sweep_iterations = 30;

}  // namespace

Outcome Newton::run(Part part, double tolerance, std::int64_t max_iterations,
                    std::int64_t& iterations) {
  freeze_other_part(part);
  merits_.clear();
  StepRecord record;
  record.part = part;
  double last_worst = INFINITY;
  std::int64_t short_steps = 0;
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
        const bool loaded = std::any_of(it.lambda[2].begin(), it.lambda[2].end(), [](double l) { return l != 0; });
        if (!loaded) return Outcome::no_contact;
        it.clear_tractions();
        continue;
      }
      guess_start();
      if (k > 0) return Outcome::not_converged;
      continue;
    }
    if (worst <= tolerance) return Outcome::converged;
    if (k >= max_iterations || iterations_left_ <= 0) return Outcome::not_converged;
    if (part != Part::normal && load_beyond_friction()) return Outcome::no_solution;
    // Forcing term: the linear residual need not be smaller than the next Newton residual can be.
    const double forcing = std::clamp(0.1 * std::min(worst, last_worst > 0 ? worst / last_worst : 1.0),
                                      std::min(1e-2, 0.05 * tolerance / std::max(worst, tolerance)), 1e-2);
    last_worst = worst;
    if (!newton_step(part, std::max(forcing, 1e-13))) return Outcome::not_converged;
    record.step = line_search(part, trial_merit(part, 0));
    advance(part, record.step);
    ++iterations;
    --iterations_left_;
    short_steps = record.step <= short_step ? short_steps + 1 : 0;
    if (short_steps >= stuck_after && part == Part::full) return Outcome::not_converged;
  }
}

// ||F_t|| >= mu F_n has no steady solution; neither has a spin moment beyond what full sliding
// about the origin can give.
bool Newton::load_beyond_friction() const {
  const Problem& p = *problem_;
  const bool f1 = p.by_force[xi1], f2 = p.by_force[xi2], m = p.by_force[spin];
  if (!f1 && !f2 && !m) return false;
  double capacity = 0, moment = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(p.nodes); ++k) {
    const double limit = -p.mu[k] * iterate_->lambda[2][k] * p.weight[k];
    capacity += limit;
    moment += std::abs(limit) * std::hypot(p.op.slip_x[k], p.op.slip_y[k]);
  }
  if (p.by_force[approach]) {
    // The pressure may not carry the load yet: scale to the load that it will carry.
    double carried = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(p.nodes); ++k) carried -= iterate_->lambda[2][k] * p.weight[k];
    if (!(carried > 0)) return false;
    capacity *= p.value[approach] / carried;
    moment *= p.value[approach] / carried;
  }
  const double force = std::hypot(f1 ? p.value[xi1] : 0, f2 ? p.value[xi2] : 0);
  return (force > 0 && force >= capacity * (1 - 1e-12)) ||
         (m && std::abs(p.value[spin]) > 0 && std::abs(p.value[spin]) >= moment);
}

Outcome Newton::run_coupled(bool cold, double tolerance, std::int64_t max_iterations) {
  if (cold) {
    const Outcome start = run(Part::normal, start_tolerance, max_iterations, report_.normal_iterations);
    if (start != Outcome::converged) return start;
  }
  Outcome outcome = run(Part::full, tolerance, max_iterations, report_.full_iterations);
  for (std::int64_t sweep = 0; sweep < sweeps && outcome == Outcome::not_converged; ++sweep) {
    if (iterations_left_ <= 0) break;
    // Alternate between the two half problems (each with the other's tractions held), which
    // contracts for moderate friction, then try the full step again.
    ++report_.fallbacks;
    const double loose = std::max(tolerance, 1e-3);
    outcome = run(Part::normal, loose, sweep_iterations, report_.normal_iterations);
    if (outcome != Outcome::converged && outcome != Outcome::not_converged) return outcome;
    outcome = run(Part::tangential, loose, sweep_iterations, report_.tangential_iterations);
    if (outcome != Outcome::converged && outcome != Outcome::not_converged) return outcome;
    outcome = run(Part::full, tolerance, max_iterations, report_.full_iterations);
  }
  return outcome;
}

NewtonReport Newton::solve(const Problem& problem, Iterate& iterate, bool frictionless,
                           double tolerance, std::int64_t max_iterations, Monitor& monitor) {
  problem_ = &problem;
  iterate_ = &iterate;
  monitor_ = &monitor;
  report_ = {};
  iterations_left_ = max_iterations;
  const auto n = static_cast<std::size_t>(problem.nodes);
  for (int c = 0; c < 3; ++c) {
    next_[c].resize(n);
    next_image_[c].resize(n);
    frozen_[c].resize(n);
    known_[c].reserve(n);
  }
  active_.reserve(n);
  is_active_.resize(n);
  merits_.reserve(8);
  for (int m = 0; m < 4; ++m)
    if (!problem.by_force[static_cast<std::size_t>(m)])
      iterate.motion[static_cast<std::size_t>(m)] = problem.value[static_cast<std::size_t>(m)];
  const bool cold = std::none_of(iterate.lambda[2].begin(), iterate.lambda[2].end(), [](double l) { return l != 0; });
  if (problem.by_force[approach]) {
    if (!(problem.value[approach] > 0)) {
      report_.outcome = Outcome::no_contact;
      return report_;
    }
  }
  if (cold) guess_start();
  if (frictionless) {
    report_.outcome = run(Part::normal, tolerance, max_iterations, report_.normal_iterations);
  } else if (problem.op.coupled) {
    report_.outcome = run_coupled(cold, tolerance, max_iterations);
  } else {
    report_.outcome = run(Part::normal, tolerance, max_iterations, report_.normal_iterations);
    if (report_.outcome == Outcome::converged)
      report_.outcome = run(Part::tangential, tolerance, max_iterations, report_.tangential_iterations);
  }
  return report_;
}

}  // namespace rollcon
