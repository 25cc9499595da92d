#include "contact/newton/newton.hpp"

#include <algorithm>
#include <cmath>

#include "contact/newton/start.hpp"
#include "contact/newton/strategies/strategies.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

constexpr double start_tolerance = 1e-2;  // tolerance of a coupled problem's frictionless start
constexpr double clearly = 0.05;          // excess over sliding at which no fallback is tried

bool finished(Outcome outcome) {
  return outcome != Outcome::not_converged;
}

}  // namespace

void Newton::use(const Procedure& procedure) {
  iteration_.procedure = procedure;
  iteration_.linear.method = procedure.linear;
}

void Newton::operators_changed() {
  iteration_.rows_changed();
  iteration_.prediction.forget();
}

void Newton::forget_all() {
  operators_changed();
  iteration_.linear.forget_all();
}

std::size_t Newton::bytes() const {
  return iteration_.bytes() + sizeof(double) * judged_.capacity();
}

Part Newton::goal(const Problem& problem, const Prescribed& given, bool frictionless) {
  if (frictionless) return Part::normal;
  // Tangential tractions carry a part of the loads of motions that change the gap, on curved frames and on flat ones
  // outside of the axes' plane.
  const bool tilted = given.by_force[tilt1] || given.by_force[tilt2];
  const bool together =
      problem.op->coupled || (!problem.turn.empty() && (given.by_force[approach] || tilted)) ||
      (tilted && std::any_of(problem.moment_z.begin(), problem.moment_z.end(), [](double z) { return z != 0; }));
  return together ? Part::full : Part::tangential;
}

// Begins the prediction while the iterate is still the last solution.
void Newton::begin_prediction() {
  const Problem& p = *solve_.problem;
  const Prescribed& given = solve_.given;
  const Iterate& it = *solve_.iterate;
  Prediction& prediction = iteration_.prediction;
  iteration_.prediction_ratio = 0;
  if (!predict) return;
  prediction.reserve(p.nodes);
  prediction.begin(given, it);
  double friction = 0;
  for (std::size_t k = 0; k < at(p.nodes); ++k) friction -= given.coefficient(p.mu, k) * p.weight[k] * it.lambda[2][k];
  MotionValues weight{};
  for (const int m : {xi1, xi2, spin})
    weight[at(m)] = given.by_force[at(m)] ? friction * (m == spin ? p.length : 1) : creep_scale(p, given, it, m);
  double load = 0;
  for (std::size_t k = 0; k < at(p.nodes); ++k) load -= p.weight[k] * it.lambda[2][k];
  weight[approach] = given.by_force[approach] ? given.value[approach] : std::abs(it.motion[approach]);
  for (const std::size_t m : {tilt1, tilt2})
    weight[m] = given.by_force[m] ? load * p.length : std::abs(it.motion[approach]) / p.length;
  iteration_.prediction_ratio = prediction.ratio(given, at(p.nodes), weight);
}

void Newton::begin_cold() {
  start_cold(*solve_.problem, solve_.given, *solve_.iterate);
  guess_start(*solve_.problem, solve_.given, *solve_.iterate);
}

// Solves the normal part first where the problems decouple, all together where they do not.
Outcome Newton::attempt(bool cold) {
  Solve& s = solve_;
  Outcome outcome = Outcome::converged;
  if (s.goal != Part::full || cold) {
    const double enough = s.goal == Part::full ? std::max(start_tolerance, s.tolerance) : s.tolerance;
    outcome = iteration_.run(Part::normal, s.given, {.tolerance = enough});
    if (outcome == Outcome::not_converged && s.iterations_left > 0) {
      ++s.report.fallbacks;
      outcome = bracket_approach(iteration_, enough);
      s.report.saved[static_cast<std::size_t>(Rung::approach_of_pressures)] += outcome == Outcome::converged;
    }
    pressures_found_ = outcome == Outcome::converged;
    judged_ = s.iterate->lambda[2];
    judged_motion_ = s.iterate->motion;
  }
  if (outcome != Outcome::converged || s.goal == Part::normal) return outcome;
  // Full stick finds both creepages and slip directions, which are not there to start from (9 instead of 15 iterations
  // on the linear quadrilaterals of the sphere example).
  if (cold && s.problem->law->falls()) {
    outcome = run_as_at_rest(iteration_);
    if (outcome != Outcome::converged && outcome != Outcome::not_converged) return outcome;
    return iteration_.run(s.goal, s.given);
  }
  return iteration_.run(s.goal, s.given,
                        {.free_steps = cold ? 0 : 2, .stick_first = cold && s.given.tangential_load()});
}

NewtonReport Newton::solve(const Problem& problem, const Prescribed& given, Iterate& iterate, bool frictionless,
                           double tolerance, std::int64_t max_iterations, Monitor& monitor) {
  Solve& s = solve_;
  s = {.problem = &problem,
       .iterate = &iterate,
       .monitor = &monitor,
       .given = given,
       .goal = goal(problem, given, frictionless),
       .tolerance = tolerance,
       .max_iterations = max_iterations,
       .iterations_left = max_iterations,
       .report = {}};
  iteration_.begin(s);
  pressures_found_ = compared_ = false;
  judged_.reserve(at(problem.nodes));
  begin_prediction();
  for (std::size_t m = 0; m < motion_count; ++m) {
    if (!given.by_force[m])
      iterate.motion[m] = given.value[m];
    else if (frictionless && !changes_gap(static_cast<int>(m)))
      iterate.motion[m] = 0;
  }
  if (given.by_force[approach] && !(given.value[approach] > 0)) {
    start_cold(problem, given, iterate);
    s.report.outcome = Outcome::no_contact;
    return s.report;
  }
  const bool cold = s.report.from_nothing =
      std::none_of(iterate.lambda[2].begin(), iterate.lambda[2].end(), [](double l) { return l != 0; });
  if (cold) {
    iteration_.prediction.forget();
    iteration_.prediction_ratio = 0;
    guess_start(problem, given, iterate);
  }
  Outcome outcome = guarded(attempt(cold));
  iteration_.prediction_ratio = 0;
  if (outcome == Outcome::not_converged && beyond_sliding(clearly)) outcome = Outcome::no_solution;
  if (outcome == Outcome::not_converged && !cold && s.iterations_left > 0) {
    ++s.report.fallbacks;
    s.report.from_nothing = true;
    begin_cold();
    outcome = guarded(attempt(true));
    s.report.saved[static_cast<std::size_t>(Rung::cold)] += outcome == Outcome::converged;
  }
  if (outcome == Outcome::not_converged && beyond_sliding(clearly)) outcome = Outcome::no_solution;
  // Without coupling the tangential problem has no meaning under pressures that were not found.
  const bool worth_while = s.goal == Part::full || (s.goal == Part::tangential && pressures_found_);
  if (outcome == Outcome::not_converged && worth_while && s.iterations_left > 0) outcome = fall_back();
  if (outcome == Outcome::not_converged || outcome == Outcome::cancelled) iteration_.return_to_best();
  if (outcome == Outcome::not_converged && beyond_sliding(0)) outcome = Outcome::no_solution;
  if (predict && outcome == Outcome::converged)
    iteration_.prediction.solved();
  else
    iteration_.prediction.forget();
  s.report.outcome = outcome;
  return s.report;
}

// Tries the fallbacks, the cheapest first.
Outcome Newton::fall_back() {
  Outcome outcome = Outcome::not_converged;
  const auto next = [&](Rung rung, auto strategy) {
    if (finished(outcome) || solve_.iterations_left <= 0) return;
    ++solve_.report.fallbacks;
    outcome = guarded(strategy(iteration_));
    solve_.report.saved[static_cast<std::size_t>(rung)] += finished(outcome);
  };
  if (solve_.given.tangential_load()) next(Rung::follow_loads, follow_loads);
  next(Rung::rescale_slip, rescale_slip);
  if (solve_.goal == Part::full) next(Rung::alternate, alternate);
  next(Rung::grow_friction, grow_friction);
  return outcome;
}

// Says, after iterations that led nowhere, whether the loads exceed those of sliding against them by so much. Ends at
// the best iterate.
bool Newton::beyond_sliding(double by) {
  const Solve& s = solve_;
  const Problem& p = *s.problem;
  constexpr double suspicious = 0.9;  // utilisation under pressures that are not those of the solution
  if (!s.given.tangential_load() || s.goal == Part::normal) return false;
  // Pressures carry a part of the force across the rolling direction where a frame is curved.
  if (!p.turn.empty() && s.given.by_force[xi2]) return false;
  FrictionShare& share = solve_.report.share;
  if (s.goal == Part::tangential) {
    // Clear cases were seen before.
    if (by > 0 || !pressures_found_) return false;
    share = share_of_friction(p, s.given, s.iterate->lambda);
    return share.sliding >= 1 + by;
  }
  if (by > 0 && !(share_of_friction(p, s.given, iteration_.best_tractions()).together >= suspicious)) return false;
  if (!compared_) {
    compared_ = true;
    slides_ = slide_against_loads(iteration_);
    iteration_.return_to_best();
  }
  share = slides_;
  return slides_.sliding >= 1 + by - 10 * sliding_tolerance;
}

}  // namespace rollcon
