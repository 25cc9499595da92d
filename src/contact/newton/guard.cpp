/// The last guard before a success: what was found keeps every law and carries every prescribed
/// load, whichever part was solved last and whatever fallbacks did on the way.

#include <algorithm>
#include <cmath>
#include <cstring>

#include "contact/newton/newton.hpp"
#include "contact/newton/start.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

constexpr double slack = 10;  // images made anew have another rounding

}  // namespace

// The tangential problem of equal bodies stands on pressures that were found before it: they are to
// be those still, or are judged again. The part solved last was judged when it ended, by the
// problem as it was then; after fallbacks, which change problems for a while, all is judged by the
// problem as it is.
bool Newton::holds(double tolerance) {
  const Problem& p = *problem_;
  const Iterate& it = *iterate_;
  for (std::size_t m = 0; m < 4; ++m)
    if (!p.by_force[m] && it.motion[m] != p.value[m]) return false;
  const std::vector<double>& pressures = it.lambda[2];
  const bool as_judged =
      report_.fallbacks == 0 && it.motion[approach] == judged_approach_ &&
      judged_.size() == pressures.size() &&
      std::memcmp(judged_.data(), pressures.data(), pressures.size() * sizeof(double)) == 0;
  if (goal_ == Part::tangential && !as_judged) {
    const Residual normal = normal_laws();
    report_.residual_normal = normal.normal;
    report_.residual_load = std::max(report_.residual_load, normal.load);
    if (!normal.within(Part::normal, slack * tolerance)) return false;
  }
  if (report_.fallbacks == 0) return true;
  const Residual last = evaluate(goal_);
  if (goal_ != Part::tangential) report_.residual_normal = last.normal;
  if (goal_ != Part::normal) report_.residual_tangential = last.tangential;
  report_.residual_load = std::max(report_.residual_load, last.load);
  return last.within(goal_, slack * tolerance);
}

// As evaluate(Part::normal), but the active nodes stay those of the part that was solved last.
Newton::Residual Newton::normal_laws() {
  const Problem& p = *problem_;
  Iterate& it = *iterate_;
  Residual r;
  const double delta = it.motion[approach];
  double worst = 0, pressure = 0, terms = 0, sum = 0;
  for (std::int64_t i = 0; i < p.nodes; ++i) {
    const std::size_t k = at(i);
    if (!p.used[k]) continue;
    it.update_gap(p, i);
    const double ln = it.lambda[2][k];
    const double augmented = ln + p.rn[k] * (p.rigid_gap(k, delta) - it.image[2][k]);
    const double rest = std::abs(ln - std::min(augmented, 0.0));
    worst = std::max(worst, rest);
    sum += rest;  // what is not a number passes over a greatest value, not over a sum
    pressure = std::max(pressure, -ln);
    if (augmented < 0)
      terms = std::max(terms, p.rn[k] * (std::abs(p.gap[k]) + std::abs(it.image[2][k])));
  }
  const double scale = pressure > 0 ? pressure : 1;
  r.normal = std::isfinite(sum) ? worst / scale : INFINITY;
  r.normal_rounding = rounding_of_terms * terms / scale;
  r.load = load_residual(Part::normal, 0);
  return r;
}

// A converged part is a solution if the guard lets it pass. Else what it stood on is found anew,
// for whatever is tried next, and nothing returns to it.
Outcome Newton::guarded(Outcome outcome, double tolerance, std::int64_t max_iterations) {
  if (outcome != Outcome::converged) return outcome;
  if (holds(tolerance)) {
    if (goal_ == Part::normal || !friction_overdrawn(*problem_, iterate_->lambda)) return outcome;
    report_.share = share_of_friction(*problem_, iterate_->lambda);
    return Outcome::no_solution;
  }
  ++report_.refuted;
  best_.worst = INFINITY;
  start_cold(*problem_, *iterate_);
  guess_start(*problem_, *iterate_);
  if (goal_ == Part::tangential && iterations_left_ > 0)
    pressures_found_ = run(Part::normal, tolerance, max_iterations, report_.normal_iterations) ==
                       Outcome::converged;
  const Residual now = evaluate(goal_);
  if (goal_ != Part::tangential) report_.residual_normal = now.normal;
  if (goal_ != Part::normal) report_.residual_tangential = now.tangential;
  report_.residual_load = now.load;
  return Outcome::not_converged;
}

// No tangential tractions; where pressures depend on them a new guess of those too, else those that
// were found.
void Newton::start_anew() {
  Iterate& it = *iterate_;
  if (goal_ == Part::full) {
    it.clear_tractions();
    guess_start(*problem_, it);
    return;
  }
  for (int c = 0; c < 2; ++c) std::fill(it.lambda[c].begin(), it.lambda[c].end(), 0.0);
  std::fill(it.slip_valid.begin(), it.slip_valid.end(), std::uint8_t{0});
}

}  // namespace rollcon
