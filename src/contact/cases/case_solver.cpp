#include "contact/cases/case_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/cases/solve_many.hpp"
#include "contact/results/doubts.hpp"
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
  to->given.share = {};
  to->frictionless = from.frictionless;
  to->procedure = from.procedure;
  to->iterate.resize(to->prepared->problem.nodes);
  return to;
}

}  // namespace

SharedFrameSolver::SharedFrameSolver(const SolverState& scene, const Options& options)
    : options_(options), state_(share(scene)), frictionless_(scene.frictionless) {}

SharedFrameSolver::~SharedFrameSolver() = default;

void SharedFrameSolver::begin_chain() {
  state_->newton = Newton{};
  state_->published.reset();
  warm_ = false;
}

void SharedFrameSolver::prescribe(std::span<const Parameter> parameter, const double* value) {
  SolverState& s = *state_;
  for (std::size_t j = 0; j < parameter.size(); ++j) {
    const double v = value[j] + 0.0;  // no negative zero
    const std::size_t m = motion_of(parameter[j]);
    if (parameter[j] == Parameter::friction)
      s.given.friction = v;
    else if (m == approach)
      s.given.prescribe_normal(s.given.by_force[m], v, s.prepared->problem.datum);
    else
      s.given.value[m] = v;
  }
  const bool frictionless = frictionless_ || !(s.given.friction > least_friction);
  if (frictionless && !s.frictionless) {
    for (int c = 0; c < 2; ++c) std::fill(s.iterate.lambda[c].begin(), s.iterate.lambda[c].end(), 0.0);
    s.iterate.invalidate();
  }
  s.frictionless = frictionless;
}

Status SharedFrameSolver::solve(std::span<const Parameter> parameter, const double* value, Monitor& monitor) {
  SolverState& s = *state_;
  forget_solution(s);
  if (!warm_ || options_.warm_start == 0) {
    s.iterate.clear();
    s.settled_friction.share.clear();
    s.given.share = {};
  }
  warm_ = false;
  prescribe(parameter, value);
  if (s.frictionless) refuse_tangential_loads(s.given);
  refuse_load_beside_frame(s);
  refuse_overflow(s);
  solve_prepared(s, options_, monitor);
  s.outcome = s.report.outcome;
  warm_ = s.outcome == Outcome::converged;
  return with_doubts(s, status_of(s));
}

void SharedFrameSolver::write(const CaseColumn& column, std::span<const Parameter> parameter, const double* value,
                              double* to) {
  SolverState& s = *state_;
  const Prepared& on = *s.prepared;
  const auto& motion = s.iterate.motion;
  switch (column.kind) {
    case CaseColumn::Kind::force:
    case CaseColumn::Kind::moment: {
      Vec3 force, moment;
      sum_tractions(on.problem, s.iterate.lambda, force, moment);
      std::copy_n(column.kind == CaseColumn::Kind::force ? force.begin() : moment.begin(), 3, to);
      break;
    }
    case CaseColumn::Kind::approach:
      *to = s.given.approach_of(motion, on.problem.datum);
      break;
    case CaseColumn::Kind::creep:
      to[0] = motion[xi1], to[1] = motion[xi2], to[2] = motion[spin];
      break;
    case CaseColumn::Kind::tilt:
      std::copy_n(&motion[tilt1], 2, to);
      break;
    case CaseColumn::Kind::derivatives:
      derivatives(parameter, value, to);
      break;
    case CaseColumn::Kind::tractions: {
      const auto& lambda = s.iterate.lambda;
      for (std::size_t k = 0; k < lambda[0].size(); ++k) {
        to[3 * k] = lambda[0][k];
        to[3 * k + 1] = lambda[1][k];
        to[3 * k + 2] = std::min(lambda[2][k], 0.0);
      }
      break;
    }
    case CaseColumn::Kind::number:
      *to = column.number(s);
      break;
  }
}

void SharedFrameSolver::derivatives(std::span<const Parameter> parameter, const double* value, double* d) {
  SolverState& s = *state_;
  std::fill_n(d, 10 * parameter.size(), none);
  if (s.outcome != Outcome::converged && s.outcome != Outcome::no_contact) return;
  for (std::size_t j = 0; j < parameter.size(); ++j, d += 10) {
    double unit = 1;  // per relative change of the coefficients, so far
    if (parameter[j] == Parameter::friction && !frictionless_) unit = value[j];
    if (unit == 0) continue;  // one-sided: not in the system of a frictionless solution
    try {
      if (s.procedure.monolithic) require_operators(s);
      const Rates& r = find_rates(s, parameter[j]);
      std::copy(r.force.begin(), r.force.end(), d);
      std::copy(r.moment.begin(), r.moment.end(), d + 3);
      d[6] = r.motion[approach];
      d[7] = r.motion[xi1], d[8] = r.motion[xi2], d[9] = r.motion[spin];
      for (int i = 0; i < 10; ++i) d[i] /= unit;
    } catch (const Error& error) {
      if (error.status() != Status::err_state && error.status() != Status::err_singular &&
          error.status() != Status::err_unsupported)
        throw;
    }
  }
}

std::size_t SharedFrameSolver::bytes() const {
  const SolverState& s = *state_;
  return s.newton.bytes() + static_cast<std::size_t>(s.prepared->problem.nodes) * sizeof(double) * 30;
}

}  // namespace rollcon
