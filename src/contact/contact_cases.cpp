#include "contact/contact_cases.hpp"

#include <algorithm>
#include <limits>

#include "contact/solver.hpp"

namespace rollcon {

OwnFramesSolver::OwnFramesSolver(const Contact& asked, std::span<const Parameter> parameter) : asked_(asked) {
  if (asked.scene.step_kind() != StepKind::steady)
    fail(Status::err_state, "no frame was given: lists of cases in time steps need one");
  if (asked.scene.law() && std::find(parameter.begin(), parameter.end(), Parameter::friction) != parameter.end())
    fail(Status::err_unsupported,
         "no frame was given: cases of a list may then change the friction of Coulomb's law alone");
}

// Starts a new worker: the frames and operators that a case finds depend on its chain alone.
void OwnFramesSolver::begin_chain() {
  contact_ = asked_.make_worker();
}

Status OwnFramesSolver::solve(std::span<const Parameter> parameter, const double* value, Monitor&) {
  Scene& scene = contact_->scene;
  for (std::size_t j = 0; j < parameter.size(); ++j) {
    if (parameter[j] == Parameter::friction) {
      scene.scale_friction(asked_.scene, value[j]);
      continue;
    }
    const auto direction = static_cast<Direction>(parameter[j]);
    const How how = asked_.scene.load(direction).how == How::by_force ? How::by_force : How::by_motion;
    scene.prescribe(static_cast<std::int32_t>(direction), static_cast<std::int32_t>(how), value[j] + 0.0);
  }
  if (scene.options.warm_start == 0) contact_->reset();
  return status_ = contact_->solve_unless_cancelled();
}

void OwnFramesSolver::write(const CaseColumn& column, std::span<const Parameter> parameter, const double* value,
                            double* to) {
  switch (column.kind) {
    case CaseColumn::Kind::force:
      return contact_->resultant(InAxes::local, to, nullptr);
    case CaseColumn::Kind::moment:
      return contact_->resultant(InAxes::local, nullptr, to);
    case CaseColumn::Kind::approach:
      return contact_->motion(to, nullptr);
    case CaseColumn::Kind::creep:
      return contact_->motion(nullptr, to);
    case CaseColumn::Kind::tilt:
      return contact_->motion(nullptr, nullptr, to);
    case CaseColumn::Kind::number:
      *to = column.number(*contact_->solver);
      return;
    case CaseColumn::Kind::tractions:
      return;  // solve_many() refuses these before
    case CaseColumn::Kind::derivatives:
      break;
  }
  std::fill_n(to, 10 * parameter.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t j = 0; j < parameter.size(); ++j, to += 10) {
    const bool friction = parameter[j] == Parameter::friction;
    if (friction && value[j] == 0) continue;  // one-sided derivative: not in the system of a frictionless solution
    try {
      contact_->sensitivity(parameter[j], to, to + 3, to + 6, to + 7);
      for (int i = 0; friction && i < 10; ++i) to[i] /= value[j];
    } catch (const Error& error) {
      if (error.status() != Status::err_state && error.status() != Status::err_singular &&
          error.status() != Status::err_unsupported)
        throw;
    }
  }
}

std::size_t OwnFramesSolver::bytes() const {
  return contact_ ? contact_->solver->bytes() : 0;
}

}  // namespace rollcon
