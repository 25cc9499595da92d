#include "contact/results/sensitivity.hpp"

#include <algorithm>

#include "contact/solution.hpp"
#include "support/clock.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

constexpr int no_motion = -1;

// Motion whose prescribed value, or whose load's, the parameter is.
int motion_changed(Parameter parameter) {
  return parameter == Parameter::friction ? no_motion : static_cast<int>(motion_of(parameter));
}

/// What changes: a parameter, or (not null) what is given at the nodes.
struct Change {
  Parameter parameter = Parameter::friction;
  const NodeGivens* nodes = nullptr;

  /// Motion that changes itself; no_motion: none.
  int motion() const { return nodes ? no_motion : motion_changed(parameter); }
  /// Growth of the coefficient over itself.
  double friction(const Problem& p, std::size_t k) const {
    if (nodes) return p.mu[k] > 0 ? nodes->mu[k] / p.mu[k] : 0;
    return parameter == Parameter::friction ? 1 : 0;
  }
};

// What the change does to the part's equations while the unknowns stay. The rate of pressures that the part holds given
// is in w.lambda[2] already.
void fill_right_side(SolverState& s, const ReducedSystem& system, const Change& change) {
  const Problem& p = s.prepared->problem;
  Sensitivities& w = s.sensitivities;
  const std::size_t na = at(system.active());
  for (std::vector<double>* v : {&w.gap, &w.slip[0], &w.slip[1], &w.bound[0], &w.bound[1]}) v->assign(na, 0.0);
  const int m = change.motion();
  const bool given = m != no_motion && !s.given.by_force[static_cast<std::size_t>(m)];
  for (std::size_t a = 0; a < na; ++a) {
    const auto k = static_cast<std::size_t>(system.nodes()[a]);
    if (given) w.gap[a] = -p.closing(m, k);
    if (change.nodes) w.gap[a] = change.nodes->gap[k];
    if (system.part() == Part::normal) continue;
    // mu p e grows by mu e (p dmu/mu + dp); own[i][2] is mu e_i.
    const double pressure =
        -change.friction(p, k) * s.iterate.lambda[2][k] - (system.part() == Part::tangential ? w.lambda[2][k] : 0);
    const TangentialLaw& law = system.law(static_cast<std::int64_t>(a));
    for (std::size_t c = 0; c < 2; ++c) w.bound[c][a] = law.own[c][2] * pressure;
    if (change.nodes)
      for (std::size_t c = 0; c < 2; ++c) w.slip[c][a] = change.nodes->slip[c][k];
    if (!given) continue;
    const std::array<double, 2> column = p.slip_column(m, k);
    for (std::size_t c = 0; c < 2; ++c) w.slip[c][a] = column[c];
  }
  MotionValues load{};
  if (m != no_motion && !given) load[static_cast<std::size_t>(m)] = 1;
  if (system.part() == Part::tangential)
    for (const int t : {xi1, xi2, spin}) load[static_cast<std::size_t>(t)] -= load_of_pressures(p, t, w.lambda[2]);
  system.rate_side(w.gap, w.slip[0], w.slip[1], w.bound[0], w.bound[1], load, w.b);
}

void solve_part(SolverState& s, Part part, const Change& change, Rates& rates) {
  Sensitivities& w = s.sensitivities;
  ReducedSystem& system = s.newton.linearise(s.prepared->problem, s.given, s.iterate, part);
  fill_right_side(s, system, change);
  // Nothing slides, or nothing is there that the parameter acts on.
  if (std::all_of(w.b.begin(), w.b.end(), [](double v) { return v == 0; })) return;
  ++w.right_sides;
  if (!s.newton.linear().solve_exactly(system, w.b, w.x))
    fail(Status::err_singular,
         "the linearised equations are singular: the solution does not change smoothly with what "
         "is prescribed (a load at the limit of friction, for instance)");
  const std::size_t na = at(system.active());
  for (int r = 0; r < system.components(); ++r)
    for (std::size_t a = 0; a < na; ++a)
      w.lambda[system.component(r)][static_cast<std::size_t>(system.nodes()[a])] =
          w.x[static_cast<std::size_t>(r) * na + a];
  for (int m = 0; m < int{motion_count}; ++m) {
    if (has_motion(part, m) && s.given.by_force[static_cast<std::size_t>(m)])
      rates.motion[static_cast<std::size_t>(m)] = system.motion(s.given, m, w.x.data());
  }
}

void solve_rates(SolverState& s, const Change& change, Rates& rates) {
  const Problem& p = s.prepared->problem;
  Sensitivities& w = s.sensitivities;
  rates = {};
  const int m = change.motion();
  const bool given = m != no_motion && !s.given.by_force[static_cast<std::size_t>(m)];
  if (given) rates.motion[static_cast<std::size_t>(m)] = 1;
  if (s.outcome == Outcome::no_contact) return;
  const bool tangential_load = m != no_motion && !changes_gap(m) && !given;
  if (s.frictionless && tangential_load)
    fail(Status::err_state,
         "direction %d is prescribed by force but the friction coefficient is 0 at every node: "
         "nothing can carry a change of that force",
         m + 1);
  w.reserve(at(p.nodes));
  for (auto& v : w.lambda) v.assign(at(p.nodes), 0.0);
  const Part goal = Newton::goal(p, s.given, s.frictionless);
  if (goal == Part::full) {
    solve_part(s, Part::full, change, rates);
  } else {
    if ((m != no_motion && changes_gap(m)) || change.nodes) solve_part(s, Part::normal, change, rates);
    if (goal == Part::tangential) solve_part(s, Part::tangential, change, rates);
  }
  sum_tractions(p, w.lambda, rates.force, rates.moment);
}

// Counts the work.
void find_rates_of(SolverState& s, const Change& change, Rates& rates) {
  Sensitivities& w = s.sensitivities;
  if (!s.frictionless && s.prepared->problem.law->of_field())
    fail(Status::err_unsupported,
         "friction follows the whole solution (its temperature, or its past): derivatives are not known then");
  const Stopwatch watch(w.seconds);
  LinearSolver& linear = s.newton.linear();
  const std::int64_t factors = linear.factorizations, iterations = linear.iterations;
  try {
    solve_rates(s, change, rates);
  } catch (...) {
    s.newton.operators_changed();  // what was gathered may be half done
    throw;
  }
  w.factorizations += linear.factorizations - factors;
  w.linear_iterations += linear.iterations - iterations;
  s.peak_bytes = std::max(s.peak_bytes, s.bytes());
}

}  // namespace

void Sensitivities::forget() {
  known.fill(false);
  right_sides = factorizations = linear_iterations = 0;
  seconds = 0;
}

// As a time loop changes the number of nodes in contact, nothing is allocated.
void Sensitivities::reserve(std::size_t nodes) {
  for (std::vector<double>* v : {&gap, &slip[0], &slip[1], &bound[0], &bound[1]}) v->reserve(nodes);
  b.reserve(3 * nodes + 4);
  x.reserve(3 * nodes + 4);
}

const Rates& find_rates(SolverState& s, Parameter parameter) {
  Sensitivities& w = s.sensitivities;
  const auto which = static_cast<std::size_t>(parameter) - 1;
  if (w.known[which]) return w.rates[which];
  find_rates_of(s, {parameter, nullptr}, w.rates[which]);
  w.known[which] = true;
  return w.rates[which];
}

Rates find_rates(SolverState& s, const NodeGivens& rate) {
  Rates rates;
  find_rates_of(s, {Parameter::friction, &rate}, rates);
  return rates;
}

}  // namespace rollcon
