#include "procedures/gnmls.hpp"

#include <algorithm>
#include <cmath>

#include "contact/newton/friction_limit.hpp"
#include "contact/newton/start.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

constexpr std::size_t merit_window = 5;      // window of the exact Jacobian's non-monotone search
constexpr double shorter = 0.5;              // beta: factor on a step
constexpr double slope = 1e-4;               // sigma: fraction of the predicted decrease that must be reached
constexpr double smallest_step = 1.0 / 256;  // a shorter step gives way to the best one seen
constexpr double short_step = 0.25;
constexpr int warm_patience = 12;  // iterations without progress
constexpr double progress = 0.7;   // factor on the best residual that counts as progress
constexpr int patience = 4;        // short steps in a row before a full one is taken
constexpr double finest_linear_tolerance = 1e-12;
constexpr double extrapolation = 1.2;  // theta of (92)

/// Gives the laws their values at a point.
struct AtPoint {
  static constexpr bool trial = false;
  const Problem& p;
  const Point& z;

  double lambda(int c, std::size_t k) const { return z.lambda[c][k]; }
  SummedGap gap(std::size_t k) const { return {p.rigid_gap(k, z.motion) - z.depth[k], 0}; }
  static bool slip_known(std::size_t) { return true; }
  SummedSlip slip(std::size_t k) const {
    const auto i = static_cast<std::int64_t>(k);
    return {p.rigid_slip1(i, z.motion) + z.slip[0][k], p.rigid_slip2(i, z.motion) + z.slip[1][k], 0};
  }
};

}  // namespace

// Evaluates the laws (17)-(24) as projections of the augmented tractions, at every pair.
Gnmls::Residual Gnmls::evaluate(const Point& z, bool measure) {
  const Problem& p = *problem_;
  const Part part = tangential_ ? Part::full : Part::normal;
  for (std::size_t k = 0; measure && k < at(p.nodes); ++k)
    step_.state[k] = p.used[k] ? PairState::open : PairState::unused;
  const LawSums sums = sum_laws(p, given_, part, AtPoint{p, z}, [&](std::size_t k, bool touching, bool sliding) {
    if (measure && touching) step_.state[k] = sliding ? PairState::slip : PairState::stick;
  });
  if (measure) scales_ = scales_of(sums);
  Residual r{residual_of(sums, scales_, load_error(p, given_, part, z.lambda), sums.contact)};
  const double imbalance = system_->imbalance(z) / scales_.pressure;
  r.merit += 0.5 * imbalance * imbalance;
  r.imbalance = imbalance / std::sqrt(std::max(1.0, static_cast<double>(r.contact)));
  return r;
}

// Says whether the loads are beyond what friction can carry, with pressures near those of the solution. Pressures that
// friction takes part in are not settled before the end: those of unlike bodies, unless only their sum matters, and on
// curved frames the loads that pressures carry.
bool Gnmls::beyond_friction() {
  constexpr double part_of_friction = 0.05, settling = 2e-3;
  const Problem& p = *problem_;
  const bool moment = given_.by_force[spin], curved = !p.turn.empty() && given_.by_force[approach];
  const bool known = !p.op->coupled, sum_known = known || friction_sum_known(p, given_, z_.lambda[2]);
  const double limit = 1 + (curved ? settling : -1e-12), far = 1 + part_of_friction;
  if (!moment && share_of_forces(p, given_, z_.lambda) < (sum_known ? limit : far)) return false;
  report_.share = share_of_friction(p, given_, z_.lambda);
  return report_.share.together >= (known ? limit : far) || (sum_known && report_.share.force >= limit);
}

bool Gnmls::creepage_unknown() const {
  const auto& by_force = given_.by_force;
  return by_force[xi1] || by_force[xi2] || by_force[spin];
}

bool Gnmls::any_sticks() const {
  for (std::size_t k = 0; k < step_.state.size(); ++k)
    if (step_.state[k] == PairState::stick && problem_->mu[k] > 0) return true;
  return false;
}

// Sets the laws' rows for the states that evaluate() found.
void Gnmls::linearise() {
  const Problem& p = *problem_;
  if (!tangential_) return;
  // Friction at sliding pairs does not depend on the creepages if directions are frozen: without a sticking pair
  // nothing would determine them.
  const bool frozen = procedure_.jacobian == Jacobian::simplified || procedure_.jacobian == Jacobian::reduced;
  // The creepages are weakly determined with other Jacobians, too, and steps that had to be cut short show that it was
  // not enough.
  if (creepage_unknown() && (frozen || sharpening_ < 1) && !any_sticks()) stick_first_ = true;
  for (std::size_t k = 0; k < at(p.nodes); ++k) {
    PairState& state = step_.state[k];
    if (state != PairState::stick && state != PairState::slip) continue;
    if (stick_first_ && p.mu[k] > 0) state = PairState::stick;
    if (state == PairState::stick) {
      step_.law[k] = stick_law();
      continue;
    }
    const auto i = static_cast<std::int64_t>(k);
    const double pressure = -(z_.lambda[2][k] + p.rn[k] * (p.rigid_gap(k, z_.motion) - z_.depth[k]));
    TangentialLaw& law = step_.law[k];
    law = linearise_friction(p, given_, k, z_.lambda, p.rigid_slip1(i, z_.motion) + z_.slip[0][k],
                             p.rigid_slip2(i, z_.motion) + z_.slip[1][k], pressure, true);
    if (procedure_.jacobian == Jacobian::exact || procedure_.jacobian == Jacobian::b_derivative) continue;
    // The direction of friction stays that of the last iterate, by (77)-(82).
    law.own[0][0] = law.own[1][1] = 1;
    law.own[0][1] = law.own[1][0] = 0;
    for (auto& row : law.slip) row[0] = row[1] = 0;
  }
  if (procedure_.jacobian == Jacobian::reduced) estimate_slip();
}

// Estimates the displacement of sticking pairs by (90)-(92) from w + tau (c + D w) = w, with tau the inverse of the
// derivative's diagonal (Jacobi), a multiple of it (extrapolation), or one time step for all, the shortest transit of a
// node.
void Gnmls::estimate_slip() {
  const Problem& p = *problem_;
  const SparseRows& d = p.convection.rows;
  MotionValues known{};
  for (std::size_t m = 0; m < motion_count; ++m) known[m] = given_.by_force[m] ? 0 : given_.value[m];
  double fastest = 0;
  for (std::size_t k = 0; k < at(p.nodes); ++k) {
    double own = 0, largest = 0;
    for (auto j = at(d.start[k]); j < at(d.start[k + 1]); ++j) {
      if (at(d.column[j]) == k) own = d.value[j];
      largest = std::max(largest, std::abs(d.value[j]));
    }
    // A fit over neighbours may leave a node little weight of its own.
    own = p.convection.factor[k] * std::max(own, 0.1 * largest);
    step_.reach[k] = own > 0 ? 1 / own : 0;
    fastest = std::max(fastest, own);
  }
  for (std::size_t k = 0; k < at(p.nodes); ++k) {
    if (step_.state[k] != PairState::stick) continue;
    double& tau = step_.reach[k];
    if (procedure_.estimate == SlipEstimate::extrapolation) tau *= extrapolation;
    if (procedure_.estimate == SlipEstimate::pseudo_temporal) tau = 1 / fastest;
    const auto i = static_cast<std::int64_t>(k);
    const double s[2] = {p.rigid_slip1(i, known) + z_.slip[0][k], p.rigid_slip2(i, known) + z_.slip[1][k]};
    for (int c = 0; c < 2; ++c) step_.target[c][k] = z_.shift[c][k] - tau * s[c];
  }
}

// Chooses the linear tolerance: as small as the next residual can use, and near the end what the tolerance needs.
double Gnmls::next_tolerance(const Residual& residual, double worst, double tolerance) {
  double eta = procedure_.eta;
  if (procedure_.linear == LinearMethod::gmres_adaptive)
    eta = adaptive_tolerance(procedure_.eta_max, residual.merit, last_merit_, eta_);
  else if (!(eta > 0))
    eta = std::clamp(0.05 * tolerance / std::max(worst, tolerance), finest_linear_tolerance, 1e-2);
  last_merit_ = residual.merit;
  eta_ = eta;
  return procedure_.eta > 0 ? eta : std::max(eta * sharpening_, finest_linear_tolerance);
}

// Follows section 11.1 (III). If it finds no decrease, the best step seen is taken.
double Gnmls::search(double merit, Point& trial) {
  const bool exact = procedure_.jacobian == Jacobian::exact;
  if (procedure_.line_search == LineSearch::off) return 1;
  double reference = merit;
  if (exact) {
    if (merits_.size() == merit_window) merits_.erase(merits_.begin());
    merits_.push_back(merit);
    reference = *std::max_element(merits_.begin(), merits_.end());
  }
  double best = 1, best_merit = INFINITY;
  for (double alpha = 1; alpha >= smallest_step; alpha *= shorter) {
    trial = z_;
    blend(trial, next_, alpha);
    const double there = evaluate(trial, false).merit;
    if (there <= (1 - 2 * slope * alpha) * reference) return alpha;
    if (there < best_merit) best = alpha, best_merit = there;
  }
  return best;
}

Outcome Gnmls::run(double tolerance, std::int64_t max_iterations, Monitor& monitor) {
  const Problem& p = *problem_;
  StepRecord record;
  record.part = tangential_ ? Part::full : Part::normal;
  bool raised = false;
  int short_steps = 0, waiting = 0;
  const bool newton = procedure_.jacobian == Jacobian::exact || procedure_.jacobian == Jacobian::b_derivative;
  for (std::int64_t k = 0;; ++k) {
    const Residual residual = evaluate(z_, true);
    const double worst = residual.greatest();
    record.iteration = k;
    record.residual_normal = report_.residual_normal = residual.normal;
    record.residual_tangential = report_.residual_tangential = residual.tangential;
    record.merit = residual.merit;
    record.contact = residual.contact;
    record.sliding = residual.sliding;
    if (monitor.step(record)) return Outcome::cancelled;
    if (!std::isfinite(worst) || !std::isfinite(residual.merit)) return Outcome::not_converged;
    if (residual.contact == 0) {
      const bool loaded = std::any_of(z_.lambda[2].begin(), z_.lambda[2].end(), [](double l) { return l != 0; });
      if (!loaded && !given_.by_force[approach]) return Outcome::no_contact;
      if (!loaded && raised) return Outcome::not_converged;
      // All pairs opened: the iteration starts from zero tractions again, at an approach that touches.
      raised = !loaded;
      for (auto& component : z_.lambda) std::fill(component.begin(), component.end(), 0.0);
      guess_approach(p, given_, z_.motion);
      system_->update(z_);
      if (k >= max_iterations) return Outcome::not_converged;
      continue;
    }
    if (worst <= tolerance) {
      if (!tangential_ || !friction_overdrawn(p, given_, z_.lambda)) return Outcome::converged;
      report_.share = share_of_friction(p, given_, z_.lambda);
      return Outcome::no_solution;
    }
    // A warm start that leads nowhere gives way to a cold one.
    waiting = worst < progress * best_worst_ ? 0 : waiting + 1;
    if (warm_ && newton && waiting > warm_patience) return Outcome::not_converged;
    if (worst < best_worst_) best_worst_ = worst, best_ = z_;
    if (k >= max_iterations) return Outcome::not_converged;
    if (tangential_ && pressures_settled(p, given_, z_.lambda, residual.normal) && beyond_friction())
      return Outcome::no_solution;
    const double eta = next_tolerance(residual, worst, tolerance);
    linearise();
    bool solved = system_->solve(step_, z_, eta, next_);
    if (!solved && creepage_unknown() && !stick_first_) {
      stick_first_ = true;
      evaluate(z_, true);
      linearise();
      solved = system_->solve(step_, z_, eta, next_);
    }
    if (!solved) return Outcome::not_converged;
    const bool free = stick_first_;
    stick_first_ = false;
    record.step = free ? 1 : search(residual.merit, trial_);
    // The estimates (77)-(92) contract although Psi need not fall along them.
    short_steps = record.step < short_step ? short_steps + 1 : 0;
    const bool stuck = short_steps == patience && procedure_.jacobian != Jacobian::exact;
    if (stuck) record.step = 1, short_steps = 0;
    // A step that has to be cut short may be due to a loose linear solution.
    sharpening_ = record.step < short_step ? std::max(0.1 * sharpening_, finest_linear_tolerance)
                                           : std::min(1.0, 2 * sharpening_);
    blend(z_, next_, record.step);
    ++(tangential_ ? report_.full_iterations : report_.normal_iterations);
  }
}

void Gnmls::begin(Iterate& iterate, bool frictionless) {
  const Problem& p = *problem_;
  tangential_ = !frictionless;
  merits_.clear();
  eta_ = last_merit_ = 0;
  sharpening_ = 1;
  const std::size_t n = at(p.nodes);
  for (std::size_t m = 0; m < motion_count; ++m)
    if (!given_.by_force[m]) iterate.motion[m] = given_.value[m];
  for (const int m : {xi1, xi2, spin})
    if (frictionless && given_.by_force[at(m)]) iterate.motion[at(m)] = 0;
  warm_ = std::any_of(iterate.lambda[2].begin(), iterate.lambda[2].end(), [](double l) { return l != 0; });
  if (!warm_) {
    iterate.clear_tractions();
    for (const int m : {xi1, xi2, spin})
      if (given_.by_force[at(m)]) iterate.motion[at(m)] = 0;
    if (procedure_.jacobian == Jacobian::exact)
      guess_start(p, given_, iterate);
    else
      guess_approach(p, given_, iterate.motion);
  }
  for (int c = 0; c < 3; ++c) z_.lambda[c] = iterate.lambda[c];
  for (int c = 0; c < 2; ++c) {
    z_.slip[c].assign(n, 0.0);
    z_.shift[c].assign(procedure_.jacobian == Jacobian::reduced && tangential_ ? n : 0, 0.0);
  }
  z_.depth.assign(n, 0.0);
  z_.motion = iterate.motion;
  z_.inner.clear();
  if (warm_ || procedure_.jacobian == Jacobian::exact) system_->update(z_);
  step_.state.assign(n, PairState::unused);
  step_.law.assign(n, stick_law());
  for (auto& t : step_.target) t.assign(n, 0.0);
  step_.reach.assign(n, 0.0);
  // The direction of slip to start from is missing while creepages are unknown; full stick finds both.
  stick_first_ = procedure_.jacobian == Jacobian::exact && !warm_ && tangential_ && creepage_unknown();
}

NewtonReport Gnmls::solve(const Problem& problem, const Prescribed& given, Iterate& iterate, StepSystem& system,
                          const Procedure& procedure, bool frictionless, double tolerance, std::int64_t max_iterations,
                          Monitor& monitor) {
  problem_ = &problem;
  given_ = step_.given = given;
  system_ = &system;
  procedure_ = procedure;
  report_ = {};
  best_worst_ = INFINITY;
  if (given_.by_force[approach] && !(given_.value[approach] > 0)) {
    start_cold(problem, given_, iterate);
    report_.outcome = Outcome::no_contact;
    return report_;
  }
  begin(iterate, frictionless);
  report_.outcome = run(tolerance, max_iterations, monitor);
  const std::int64_t left = max_iterations - report_.full_iterations - report_.normal_iterations;
  if (report_.outcome == Outcome::not_converged && warm_ && left > 0) {
    ++report_.fallbacks;
    start_cold(problem, given_, iterate);
    begin(iterate, frictionless);
    report_.outcome = run(tolerance, left, monitor);
  }
  const bool stopped = report_.outcome == Outcome::not_converged || report_.outcome == Outcome::cancelled;
  if (stopped && std::isfinite(best_worst_)) {
    z_ = best_;
    const Residual best = evaluate(z_, true);
    report_.residual_normal = best.normal;
    report_.residual_tangential = best.tangential;
  }
  if (report_.outcome == Outcome::not_converged && !std::isfinite(best_worst_)) {
    start_cold(problem, given_, iterate);
    return report_;
  }
  for (int c = 0; c < 3; ++c) iterate.lambda[c] = z_.lambda[c];
  for (int c = 0; c < 2; ++c) iterate.image[c] = z_.slip[c];
  iterate.image[2] = z_.depth;
  iterate.motion = z_.motion;
  std::fill(iterate.slip_valid.begin(), iterate.slip_valid.end(), std::uint8_t{1});
  std::fill(iterate.gap_valid.begin(), iterate.gap_valid.end(), std::uint8_t{1});
  return report_;
}

}  // namespace rollcon
