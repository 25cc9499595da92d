#include "contact/cases/case_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/cases/solve_many.hpp"
#include "contact/results/power.hpp"
#include "contact/results/sensitivity.hpp"
#include "contact/solution.hpp"

namespace rollcon {

bool can_share(const SolverState& state) {
  return state.procedure.standard();
}

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// A solver of its own on the same preparation, which it may add to if no other solver reads it.
std::unique_ptr<SolverState> share(const SolverState& from) {
  auto to = std::make_unique<SolverState>();
  to->make_published = from.make_published;
  to->prepared = from.prepared;
  to->preparation = can_share(from) ? nullptr : from.preparation;
  to->given = from.given;
  to->frictionless = from.frictionless;
  to->reach = from.reach;
  to->reach.known = false;
  to->procedure = from.procedure;
  to->iterate.resize(to->prepared->problem.nodes);
  return to;
}

}  // namespace

CaseSolver::CaseSolver(const SolverState& scene, const Options& options)
    : options_(options), state_(share(scene)), frictionless_(scene.frictionless) {}

CaseSolver::~CaseSolver() = default;

void CaseSolver::begin_chain() {
  state_->newton = Newton{};
  state_->published.reset();
  warm_ = false;
}

void CaseSolver::prescribe(std::span<const Parameter> parameter, const double* value) {
  SolverState& s = *state_;
  for (std::size_t j = 0; j < parameter.size(); ++j) {
    const double v = value[j] + 0.0;  // no negative zero
    const auto m = static_cast<std::size_t>(parameter[j]) - 1;
    if (parameter[j] == Parameter::friction)
      s.given.friction = v;
    else if (m == approach)
      s.given.prescribe_normal(s.given.by_force[m], v, s.prepared->problem.datum);
    else
      s.given.value[m] = v;
  }
  const bool frictionless = frictionless_ || !(s.given.friction > 0);
  if (frictionless && !s.frictionless) {
    for (int c = 0; c < 2; ++c) std::fill(s.iterate.lambda[c].begin(), s.iterate.lambda[c].end(), 0.0);
    s.iterate.invalidate();
  }
  s.frictionless = frictionless;
}

Status CaseSolver::solve(std::span<const Parameter> parameter, const double* value, Monitor& monitor) {
  SolverState& s = *state_;
  s.derived = s.laws_checked = s.images_known = false;
  s.sensitivities.forget();
  s.reach.doubtful = false;
  if (!warm_ || options_.warm_start == 0) s.iterate.clear();
  warm_ = false;
  prescribe(parameter, value);
  if (s.frictionless) refuse_tangential_loads(s.given);
  refuse_overflow(s);
  solve_prepared(s, options_, monitor);
  s.outcome = s.report.outcome;
  warm_ = s.outcome == Outcome::converged;
  return status_of(s);
}

bool CaseSolver::out_of_reach() const {
  return state_->reach.doubtful;
}

void CaseSolver::resultant(double* force, double* moment) const {
  Vec3 f, m;
  sum_tractions(state_->prepared->problem, state_->prepared->frame, state_->iterate.lambda, f, m);
  if (force) std::copy(f.begin(), f.end(), force);
  if (moment) std::copy(m.begin(), m.end(), moment);
}

void CaseSolver::motion(double* depth, double* creep) const {
  const auto& m = state_->iterate.motion;
  if (depth) *depth = state_->given.approach_of(m, state_->prepared->problem.datum);
  if (creep) creep[0] = m[xi1], creep[1] = m[xi2], creep[2] = m[spin];
}

void CaseSolver::tractions(double* t) const {
  const auto& lambda = state_->iterate.lambda;
  for (std::size_t k = 0; k < lambda[0].size(); ++k) {
    t[3 * k] = lambda[0][k];
    t[3 * k + 1] = lambda[1][k];
    t[3 * k + 2] = std::min(lambda[2][k], 0.0);
  }
}

void CaseSolver::derivatives(std::span<const Parameter> parameter, const double* value, double* d) {
  SolverState& s = *state_;
  std::fill_n(d, 10 * parameter.size(), none);
  if (s.outcome != Outcome::converged && s.outcome != Outcome::no_contact) return;
  for (std::size_t j = 0; j < parameter.size(); ++j, d += 10) {
    double unit = 1;  // per relative change of the coefficients, so far
    if (parameter[j] == Parameter::friction && !frictionless_) unit = value[j];
    if (unit == 0) continue;  // one-sided: not in the system of a frictionless solution
    try {
      if (s.procedure.monolithic) require_operators(s, options_);
      const Rates& r = find_rates(s, parameter[j]);
      std::copy(r.force.begin(), r.force.end(), d);
      std::copy(r.moment.begin(), r.moment.end(), d + 3);
      d[6] = r.motion[approach];
      d[7] = r.motion[xi1], d[8] = r.motion[xi2], d[9] = r.motion[spin];
      for (int i = 0; i < 10; ++i) d[i] /= unit;
    } catch (const Error& error) {
      if (error.status() != Status::err_state && error.status() != Status::err_singular) throw;
    }
  }
}

double CaseSolver::number(CaseNumber which) {
  SolverState& s = *state_;
  const NewtonReport& report = s.report;
  const auto sum_in_contact = [&](auto term) {
    double sum = 0;
    for (std::size_t k = 0; k < s.prepared->problem.gap.size(); ++k)
      if (s.iterate.lambda[2][k] < 0) sum += term(k);
    return sum;
  };
  switch (which) {
    case CaseNumber::iterations:
      return static_cast<double>(report.normal_iterations + report.tangential_iterations + report.full_iterations);
    case CaseNumber::fallbacks:
      return static_cast<double>(report.fallbacks);
    case CaseNumber::residual_normal:
      return report.residual_normal;
    case CaseNumber::residual_tangential:
      return report.residual_tangential;
    case CaseNumber::nodes_contact:
      return sum_in_contact([](std::size_t) { return 1.0; });
    case CaseNumber::contact_area:
      return sum_in_contact([&](std::size_t k) { return s.prepared->problem.cell_area[k]; });
    case CaseNumber::max_pressure:
      return std::max(0.0, -*std::min_element(s.iterate.lambda[2].begin(), s.iterate.lambda[2].end()));
    case CaseNumber::friction_power_balance:
      return power_put_in(s);
    case CaseNumber::friction_power:
      break;
  }
  if (s.frictionless) return 0;
  if (!s.prepared->problem.op->tangential && !s.images_known) require_operators(s, options_);
  return sum_in_contact([&](std::size_t k) {
    const auto i = static_cast<std::int64_t>(k);
    const auto& it = s.iterate;
    s.iterate.update_slip(s.prepared->problem, i);
    const double s1 = s.prepared->problem.rigid_slip1(i, it.motion) + it.image[0][k];
    const double s2 = s.prepared->problem.rigid_slip2(i, it.motion) + it.image[1][k];
    return -s.prepared->problem.cell_area[k] * s.prepared->speed * (it.lambda[0][k] * s1 + it.lambda[1][k] * s2);
  });
}

std::size_t CaseSolver::bytes() const {
  const SolverState& s = *state_;
  return s.newton.bytes() + static_cast<std::size_t>(s.prepared->problem.nodes) * sizeof(double) * 30;
}

}  // namespace rollcon
