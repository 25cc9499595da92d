#include "contact/cases/case_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/cases/solve_many.hpp"
#include "contact/solver.hpp"

namespace rollcon {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

}  // namespace

SharedFrameSolver::SharedFrameSolver(const Solver& scene)
    : solver_(scene.make_worker()), given_(solver_->solution().given), frictionless_(scene.solution().frictionless) {}

SharedFrameSolver::~SharedFrameSolver() = default;

void SharedFrameSolver::begin_chain() {
  solver_->engine().newton = Newton{};
  solver_->engine().published.reset();
  warm_ = false;
}

Status SharedFrameSolver::solve(std::span<const Parameter> parameter, const double* value, Monitor& monitor) {
  for (std::size_t j = 0; j < parameter.size(); ++j) {
    const double v = value[j] + 0.0;  // + 0.0 turns a negative zero
    const std::size_t m = motion_of(parameter[j]);
    if (parameter[j] == Parameter::friction)
      given_.friction = v;
    else if (m == approach)
      given_.prescribe_normal(given_.by_force[m], v, solver_->solution().prepared->problem.datum);
    else
      given_.value[m] = v;
  }
  const bool frictionless = frictionless_ || !(given_.friction > least_friction);
  const bool warm = std::exchange(warm_, false) && solver_->scene.options.warm_start != 0;
  const Status status = solver_->solve_given(given_, frictionless, warm, monitor);
  warm_ = solver_->solution().report.outcome == Outcome::converged;
  return status;
}

void SharedFrameSolver::write(const CaseColumn& column, std::span<const Parameter> parameter, const double* value,
                              double* to) {
  const Solution& s = solver_->solution();
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
      *to = column.number(*solver_);
      break;
  }
}

void SharedFrameSolver::derivatives(std::span<const Parameter> parameter, const double* value, double* d) {
  const Outcome outcome = solver_->solution().report.outcome;
  std::fill_n(d, 10 * parameter.size(), none);
  if (outcome != Outcome::converged && outcome != Outcome::no_contact) return;
  for (std::size_t j = 0; j < parameter.size(); ++j, d += 10) {
    double unit = 1;  // so far per relative change of the coefficients
    if (parameter[j] == Parameter::friction && !frictionless_) unit = value[j];
    if (unit == 0) continue;  // one-sided derivative: not in the system of a frictionless solution
    try {
      const Rates r = solver_->rates(parameter[j]);
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
  const auto nodes = static_cast<std::size_t>(solver_->solution().prepared->problem.nodes);
  return solver_->engine().bytes() + nodes * sizeof(double) * 30;
}

}  // namespace rollcon
