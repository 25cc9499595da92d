#include "contact/results/sensitivity.hpp"

#include <algorithm>

#include "support/clock.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

constexpr int no_motion = -1;

// Returns the motion that the parameter prescribes, directly or by its load.
int motion_changed(Parameter parameter) {
  return parameter == Parameter::friction ? no_motion : static_cast<int>(motion_of(parameter));
}

}  // namespace

/// Tells what changes: a parameter, or (not null) what is given at the nodes.
struct RateFinder::Change {
  Parameter parameter = Parameter::friction;
  const NodeGivens* nodes = nullptr;

  /// Returns the motion that changes itself; no_motion: none.
  int motion() const { return nodes ? no_motion : motion_changed(parameter); }
  /// Returns the growth of the coefficient over itself.
  double friction(const Problem& p, std::size_t k) const {
    if (nodes) return p.mu[k] > 0 ? nodes->mu[k] / p.mu[k] : 0;
    return parameter == Parameter::friction ? 1 : 0;
  }
};

// Finds what the change does to the part's equations while the unknowns stay. The rate of pressures that the part holds
// given is in lambda_[2] already.
void RateFinder::fill_right_side(const Solution& s, const ReducedSystem& system, const Change& change) {
  const Problem& p = s.prepared->problem;
  const std::size_t na = at(system.active());
  for (std::vector<double>* v : {&gap_, &slip_[0], &slip_[1], &bound_[0], &bound_[1]}) v->assign(na, 0.0);
  const int m = change.motion();
  const bool given = m != no_motion && !s.given.by_force[static_cast<std::size_t>(m)];
  for (std::size_t a = 0; a < na; ++a) {
    const auto k = static_cast<std::size_t>(system.nodes()[a]);
    if (given) gap_[a] = -p.closing(m, k);
    if (change.nodes) gap_[a] = change.nodes->gap[k];
    if (system.part() == Part::normal) continue;
    // mu p e grows by mu e (p dmu/mu + dp); own[i][2] is mu e_i.
    const TangentialLaw& law = system.law(static_cast<std::int64_t>(a));
    const double pressure = (law.sliding ? -change.friction(p, k) * s.iterate.lambda[2][k] : 0) -
                            (system.part() == Part::tangential ? lambda_[2][k] : 0);
    for (std::size_t c = 0; c < 2; ++c) bound_[c][a] = law.own[c][2] * pressure;
    if (change.nodes)
      for (std::size_t c = 0; c < 2; ++c) slip_[c][a] = change.nodes->slip[c][k];
    if (!given) continue;
    const std::array<double, 2> column = p.slip_column(m, k);
    for (std::size_t c = 0; c < 2; ++c) slip_[c][a] = column[c];
  }
  MotionValues load{};
  if (m != no_motion && !given) load[static_cast<std::size_t>(m)] = 1;
  if (system.part() == Part::tangential)
    for (const int t : {xi1, xi2, spin}) load[static_cast<std::size_t>(t)] -= load_of_pressures(p, t, lambda_[2]);
  system.rate_side(gap_, slip_[0], slip_[1], bound_[0], bound_[1], load, b_);
}

void RateFinder::solve_part(const Solution& s, Newton& newton, Derived& derived, Part part, const Change& change,
                            Rates& rates) {
  ReducedSystem& system = newton.linearise(s.prepared->problem, s.given, s.iterate, part);
  fill_right_side(s, system, change);
  // The right side is zero where nothing slides, or where the parameter acts on nothing.
  if (std::all_of(b_.begin(), b_.end(), [](double v) { return v == 0; })) return;
  ++derived.sensitivities.right_sides;
  if (!newton.linear().solve_exactly(system, b_, x_))
    fail(Status::err_singular,
         "the linearised equations are singular: the solution does not change smoothly with what "
         "is prescribed (a load at the limit of friction, for instance)");
  const std::size_t na = at(system.active());
  for (int r = 0; r < system.components(); ++r)
    for (std::size_t a = 0; a < na; ++a)
      lambda_[system.component(r)][static_cast<std::size_t>(system.nodes()[a])] =
          x_[static_cast<std::size_t>(r) * na + a];
  for (int m = 0; m < int{motion_count}; ++m) {
    if (has_motion(part, m) && s.given.by_force[static_cast<std::size_t>(m)])
      rates.motion[static_cast<std::size_t>(m)] = system.motion(s.given, m, x_.data());
  }
}

void RateFinder::solve(const Solution& s, Newton& newton, Derived& derived, const Change& change, Rates& rates) {
  const Problem& p = s.prepared->problem;
  rates = {};
  const int m = change.motion();
  const bool given = m != no_motion && !s.given.by_force[static_cast<std::size_t>(m)];
  if (given) rates.motion[static_cast<std::size_t>(m)] = 1;
  if (s.report.outcome == Outcome::no_contact) return;
  const bool tangential_load = m != no_motion && !changes_gap(m) && !given;
  if (s.frictionless && tangential_load)
    fail(Status::err_state,
         "direction %d is prescribed by force but the friction coefficient is 0 at every node: "
         "nothing can carry a change of that force",
         m + 1);
  // Storage is reserved, so that a time loop that changes the number of nodes in contact allocates nothing.
  for (std::vector<double>* v : {&gap_, &slip_[0], &slip_[1], &bound_[0], &bound_[1]}) v->reserve(at(p.nodes));
  for (std::vector<double>* v : {&b_, &x_}) v->reserve(3 * at(p.nodes) + motion_count);
  for (auto& v : lambda_) v.assign(at(p.nodes), 0.0);
  const Part goal = Newton::goal(p, s.given, s.frictionless);
  if (goal == Part::full) {
    solve_part(s, newton, derived, Part::full, change, rates);
  } else {
    if ((m != no_motion && changes_gap(m)) || change.nodes) solve_part(s, newton, derived, Part::normal, change, rates);
    if (goal == Part::tangential) solve_part(s, newton, derived, Part::tangential, change, rates);
  }
  sum_tractions(p, lambda_, rates.force, rates.moment);
}

// Finds the rates and counts the work.
void RateFinder::find(const Solution& s, Newton& newton, Derived& derived, const Change& change, Rates& rates) {
  Sensitivities& w = derived.sensitivities;
  if (!s.frictionless && s.prepared->problem.law->of_field())
    fail(Status::err_unsupported,
         "friction follows the whole solution (its temperature, or its past): derivatives are not known then");
  const Stopwatch watch(w.seconds);
  LinearSolver& linear = newton.linear();
  const std::int64_t factors = linear.factorizations, iterations = linear.iterations;
  try {
    solve(s, newton, derived, change, rates);
  } catch (...) {
    newton.operators_changed();  // gathered factors may be half done
    throw;
  }
  w.factorizations += linear.factorizations - factors;
  w.linear_iterations += linear.iterations - iterations;
}

const Rates& RateFinder::by(Parameter parameter, const Solution& s, Newton& newton, Derived& derived) {
  Sensitivities& w = derived.sensitivities;
  const auto which = static_cast<std::size_t>(parameter) - 1;
  if (w.known[which]) return w.rates[which];
  find(s, newton, derived, {parameter, nullptr}, w.rates[which]);
  w.known[which] = true;
  return w.rates[which];
}

Rates RateFinder::by(const NodeGivens& rate, const Solution& s, Newton& newton, Derived& derived) {
  Rates rates;
  find(s, newton, derived, {Parameter::friction, &rate}, rates);
  return rates;
}

}  // namespace rollcon
