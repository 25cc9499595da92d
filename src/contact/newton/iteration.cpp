#include "contact/newton/iteration.hpp"

#include <algorithm>
#include <cmath>

#include "contact/newton/friction_limit.hpp"
#include "contact/newton/start.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

constexpr std::int64_t patience = 12;  // iterations without progress before a run is stuck
constexpr double much_more = 1e3;      // factor on the traction found in the end
constexpr double progress = 0.7;       // factor on the best residual that counts as progress
constexpr double at_limit = 1 - 1e-12;
// Iterations before a search over directions, for loads with a spin moment: it is for runs that lead nowhere, and those
// that solve a load have fewer steps before them.
constexpr std::int64_t before_search = 4;

/// Gives values of the laws at an iterate, images brought up to date.
struct AtIterate {
  static constexpr bool trial = false;
  const Problem& p;
  Iterate& it;

  double lambda(int c, std::size_t k) const { return it.lambda[c][k]; }
  SummedGap gap(std::size_t k) const {
    it.update_gap(p, static_cast<std::int64_t>(k));
    return {p.rigid_gap(k, it.motion) - it.image[2][k],
            std::abs(p.tilted_gap(k, it.motion)) + std::abs(it.image[2][k])};
  }
  static bool slip_known(std::size_t) { return true; }
  SummedSlip slip(std::size_t k) const {
    const auto i = static_cast<std::int64_t>(k);
    it.update_slip(p, i);
    const double s1 = p.rigid_slip1(i, it.motion), s2 = p.rigid_slip2(i, it.motion);
    const double w1 = it.image[0][k], w2 = it.image[1][k];
    return {s1 + w1, s2 + w2, std::abs(s1) + std::abs(s2) + std::abs(w1) + std::abs(w2)};
  }
};

double traction_of(Part part, const LawResidual& r) {
  if (part == Part::normal) return r.pressure;
  if (part == Part::tangential) return r.traction;
  return std::min(r.pressure, r.traction > 0 ? r.traction : r.pressure);
}

bool any_pressure(const Iterate& it) {
  return std::any_of(it.lambda[2].begin(), it.lambda[2].end(), [](double l) { return l != 0; });
}

}  // namespace

void NewtonIteration::begin(Solve& solve) {
  solve_ = &solve;
  problem_ = solve.problem;
  iterate_ = solve.iterate;
  linear.forget_exact();
  forget_best();
  reserve(at(problem_->nodes));
}

void NewtonIteration::reserve(std::size_t n) {
  for (int c = 0; c < 3; ++c) {
    next_[c].resize(n);
    next_image_[c].resize(n);
    frozen_[c].resize(n);
    known_[c].reserve(n);
    best_.lambda[c].resize(n);
  }
  for (auto* list : {&active_, &listed_}) list->reserve(n);
  is_active_.resize(n);
  merits_.reserve(8);
}

std::size_t NewtonIteration::bytes() const {
  std::size_t sum = linear.bytes() + system_.bytes() + prediction.bytes();
  for (int c = 0; c < 3; ++c)
    sum += sizeof(double) *
           (frozen_[c].capacity() + next_[c].capacity() + next_image_[c].capacity() + known_[c].capacity());
  return sum + sizeof(double) * (b_.capacity() + x_.capacity() + correction_.capacity());
}

LawResidual NewtonIteration::evaluate(Part part, const Prescribed& given) {
  const Problem& p = *problem_;
  active_.clear();
  std::fill(is_active_.begin(), is_active_.end(), std::uint8_t{0});
  const LawSums sums = sum_laws(p, given, part, AtIterate{p, *iterate_}, [&](std::size_t k, bool touching, bool) {
    if (!touching) return;
    active_.push_back(static_cast<std::int32_t>(k));
    is_active_[k] = 1;
  });
  scales_ = scales_of(sums);
  return residual_of(sums, scales_, load_error(p, given, part, iterate_->lambda), sums.contact);
}

LawResidual NewtonIteration::judge(Part part, const Prescribed& given) {
  const Problem& p = *problem_;
  const LawSums sums = sum_laws(p, given, part, AtIterate{p, *iterate_}, [](std::size_t, bool, bool) {});
  return residual_of(sums, scales_of(sums), load_error(p, given, part, iterate_->lambda), sums.contact);
}

Outcome NewtonIteration::run(Part part, const Prescribed& given, const RunSettings& settings) {
  Solve& s = *solve_;
  const double tolerance = settings.tolerance > 0 ? settings.tolerance : s.tolerance;
  const std::int64_t most = settings.max_iterations > 0 ? settings.max_iterations : s.max_iterations;
  given_ = &given;
  freeze_other_part(part);
  images_fresh_ = false;
  merits_.clear();
  last_worst_ = INFINITY;
  last_merit_ = eta_ = 0;
  StepRecord record;
  record.part = part;
  double best = INFINITY;
  double largest = 0;  // largest traction since the images were made
  std::int64_t waiting = 0, taken = 0;
  for (std::int64_t k = 0;; ++k) {
    LawResidual residual = evaluate(part, given);
    if (k == 0 && prediction_ratio != 0 && !residual.within(part, tolerance) && start_predicted(part))
      residual = evaluate(part, given);
    record.iteration = k;
    record.merit = residual.merit;
    record.residual_normal = residual.normal;
    record.residual_tangential = residual.tangential;
    record.contact = residual.contact;
    record.sliding = residual.sliding;
    if (has_normal(part)) s.report.residual_normal = residual.normal;
    if (has_tangential(part)) s.report.residual_tangential = residual.tangential;
    s.report.residual_load = residual.load;
    if (s.monitor->step(record)) return Outcome::cancelled;
    const double worst = residual.worst(part);
    // A greatest value may pass over what is not a number; a sum does not.
    if (!std::isfinite(worst) || !std::isfinite(residual.merit)) return Outcome::not_converged;
    if (residual.contact == 0) {
      if (const std::optional<Outcome> end = touch_again(part, k)) return *end;
      continue;
    }
    largest = std::max(largest, traction_of(part, residual));
    if (residual.within(part, tolerance)) {
      // Images follow the steps. On the way from a load beyond all comparison they keep its rounding.
      if (largest <= much_more * traction_of(part, residual)) return Outcome::converged;
      largest = traction_of(part, residual);
      images_fresh_ = false;
      iterate_->invalidate();
      freeze_other_part(part);
      continue;
    }
    waiting = worst < progress * best ? 0 : waiting + 1;
    best = std::min(best, worst);
    if (part == s.goal && !settings.rehearsal) remember_best(worst);
    if (waiting > patience || k >= most || s.iterations_left <= 0) return Outcome::not_converged;
    if (beyond_friction(part, k, residual.normal)) return Outcome::no_solution;
    const double forcing = forcing_of(k, residual, worst, tolerance);
    const bool stick = settings.stick_first && taken == 0;
    if (!newton_step(part, stick, forcing)) return Outcome::not_converged;
    record.step = line_search(part, stick || taken < settings.free_steps);
    advance(part, record.step);
    ++taken;
    ++s.report.iterations_of(part);
    --s.iterations_left;
  }
}

// Goes on where no node touches, from zero tractions again or closer. Nothing: the run goes on.
std::optional<Outcome> NewtonIteration::touch_again(Part part, std::int64_t iteration) {
  Iterate& it = *iterate_;
  if (part == Part::tangential || !given_->by_force[approach]) {
    // Friction alone cannot tell whether the bodies of a coupled problem touch.
    const bool open = part != Part::tangential || solve_->goal != Part::full;
    if (!any_pressure(it)) return open ? Outcome::no_contact : Outcome::not_converged;
    it.clear_tractions();
    return std::nullopt;
  }
  if (iteration > 1) return Outcome::not_converged;
  guess_start(*problem_, *given_, it);
  if (iteration == 1) fit_approach();
  return std::nullopt;
}

// Returns the linear tolerance: the linear residual need not be smaller than the next Newton residual can be. Where
// GMRES applies the operators anew in each iteration, decades that Newton's step may waste cost more than another step.
double NewtonIteration::forcing_of(std::int64_t iteration, const LawResidual& residual, double worst,
                                   double tolerance) {
  constexpr double loosest = 1e-2;
  double forcing =
      std::clamp(iteration == 0 ? 1e-3 * worst : 0.1 * std::min(worst, last_worst_ > 0 ? worst / last_worst_ : 1.0),
                 std::min(loosest, 0.05 * tolerance / std::max(worst, tolerance)), loosest);
  if (problem_->op->all_at_once()) forcing = loosest;
  if (procedure.eta > 0) forcing = procedure.eta;
  if (procedure.linear == LinearMethod::gmres_adaptive)
    forcing = eta_ = adaptive_tolerance(procedure.eta_max, residual.merit, last_merit_, eta_);
  last_worst_ = worst;
  last_merit_ = residual.merit;
  return std::max(forcing, 1e-13);
}

// Judges by what is certain: pressures that were found before friction, or the sum of those that friction changes.
bool NewtonIteration::beyond_friction(Part part, std::int64_t iteration, double residual_normal) {
  const Problem& p = *problem_;
  const Prescribed& given = *given_;
  if (part == Part::normal || !given.tangential_load()) return false;
  const auto& lambda = iterate_->lambda;
  FrictionShare& share = solve_->report.share;
  if (part == Part::tangential && !p.op->coupled) {
    const bool moment = given.by_force[spin];
    if (iteration != (moment ? before_search : 0)) return false;
    if (!moment && share_of_forces(p, given, lambda) < at_limit) return false;
    share = share_of_friction(p, given, lambda);
    return share.together >= at_limit;
  }
  if (!friction_sum_known(p, given, lambda[2]) || !pressures_settled(p, given, lambda, residual_normal)) return false;
  if (share_of_forces(p, given, lambda) < at_limit) return false;
  share = share_of_friction(p, given, lambda);
  return true;
}

// Moves the bodies together until the gap of the loaded nodes closes on average: a body that gives way more than a
// half-space (a rim, a ring) parts everywhere under the guessed pressures at the guessed approach.
void NewtonIteration::fit_approach() {
  const Problem& p = *problem_;
  Iterate& it = *iterate_;
  double sum = 0, weight = 0;
  for (std::size_t k = 0; k < at(p.nodes); ++k) {
    if (!(it.lambda[2][k] < 0)) continue;
    it.update_gap(p, static_cast<std::int64_t>(k));
    sum += it.lambda[2][k] * (p.tilted_gap(k, it.motion) - it.image[2][k]) / p.closing(k);
    weight += it.lambda[2][k];
  }
  if (weight < 0) it.motion[approach] = sum / weight;
}

void NewtonIteration::remember_best(double worst) {
  if (!(worst < best_.worst)) return;
  const NewtonReport& report = solve_->report;
  best_.worst = worst;
  best_.residual_normal = report.residual_normal;
  best_.residual_tangential = report.residual_tangential;
  best_.residual_load = report.residual_load;
  for (int c = 0; c < 3; ++c) best_.lambda[c] = iterate_->lambda[c];
  best_.motion = iterate_->motion;
}

void NewtonIteration::return_to_best() {
  Iterate& it = *iterate_;
  if (!std::isfinite(best_.worst)) {
    // A cold start replaces what is not finite where there is nothing to return to.
    bool finite = true;
    for (const auto& lambda : it.lambda)
      for (const double l : lambda) finite = finite && std::isfinite(l);
    for (const double m : it.motion) finite = finite && std::isfinite(m);
    if (!finite) start_cold(*problem_, solve_->given, it);
    return;
  }
  NewtonReport& report = solve_->report;
  report.residual_normal = best_.residual_normal;
  report.residual_tangential = best_.residual_tangential;
  report.residual_load = best_.residual_load;
  for (int c = 0; c < 3; ++c) it.lambda[c] = best_.lambda[c];
  it.motion = best_.motion;
  it.invalidate();
}

const std::vector<double> (&NewtonIteration::best_tractions() const)[3] {
  return std::isfinite(best_.worst) ? best_.lambda : iterate_->lambda;
}

ReducedSystem& NewtonIteration::linearise(const Problem& problem, const Prescribed& given, const Iterate& iterate,
                                          Part part) {
  problem_ = &problem;
  iterate_ = const_cast<Iterate*>(&iterate);  // the iterate changes in runs alone
  given_ = &given;
  reserve(at(problem.nodes));
  evaluate(part, given);
  system_.gather(problem, given, part, active_, iterate.lambda, rows_changed_);
  rows_changed_ = false;
  if (has_tangential(part))
    for (std::size_t a = 0; a < active_.size(); ++a)
      system_.law(static_cast<std::int64_t>(a)) = law_of(part, active_[a], true);
  return system_;
}

}  // namespace rollcon
