/// Solves a patch for a step in time, and returns what it leaves.

#include <algorithm>
#include <cmath>

#include "contact/host.hpp"
#include "contact/solver.hpp"
#include "support/error.hpp"
#include "wheelrail/patch_contact.hpp"

namespace rollcon {

// Returns the part of the overlap's box that a contact fills, as Hertz's does.
StepContact PatchContact::step_contact(double accuracy) const {
  constexpr double filled = 0.707, margin = 1.15;
  const Rectangle all = box();
  const double left = filled * std::sqrt(std::max(1 - now_.give_way / now_.patch.overlap, 0.01));
  const double length = left * (all.x_greatest - all.x_least), width = left * (all.y_greatest - all.y_least);
  const double x = 0.5 * (all.x_least + all.x_greatest), y = 0.5 * (all.y_least + all.y_greatest);
  const double a = 0.5 * margin * length, b = 0.5 * margin * width;
  return {{x - a, x + a, y - b, y + b}, length, width, accuracy};
}

// Solves a step on a regular grid that stays from step to step, from what patches left there. The first trial of a step
// starts from its past, others from the last one.
void PatchContact::solve_step() {
  Solver& on = *contact_->solver;
  StepHistory& steps = on.steps();
  const bool first = begun_ != now_.step.past;
  begun_ = now_.step.past;
  shown_ = now_.on_strips = false;
  const RectangleCells cells =
      start_from(*now_.step.past, now_.axes, step_contact(0).box, now_.patch.overlap, steps.last, past_frame_);
  if (first && steps.last.loaded && !frames_.lies(on, cells)) frames_.lay(on, cells.box, cells.along, cells.across);
  if (first) on.forget_all_but_tractions();
  if (frames_.lies(on, cells)) steps.last.mesh = on.scene.revision.mesh;
  steps.of_steps = true;
  steps.failed = steps.can_repeat = false;
  steps.iterate_is_last = !first && on.solution().warm_usable;
  now_.status = frames_.solve(on, step_contact(now_.step.accuracy));
  now_.cells = frames_.laid();
}

PatchPast PatchContact::past() const {
  const Iterate& it = contact_->solver->solution().iterate;
  return {now_.axes,
          now_.patch.share,
          now_.patch.overlap - now_.give_way,
          now_.cells,
          {it.lambda[0], it.lambda[1], it.lambda[2]}};
}

PatchPast PatchContact::steady_past(double accuracy) {
  now_.step = {};
  stand(now_.motion);
  const PatchFriction friction = now_.friction;
  prescribe(now_.give_way, friction);
  Solver& on = *contact_->solver;
  on.reset();
  now_.on_strips = shown_ = false;
  now_.status = frames_.solve(on, step_contact(accuracy));
  if (!is_answer(now_.status))
    fail(Status::err_state,
         "the steady state from which a step starts was not found on the regular grid of a step: start "
         "from rest (rollcon_wheelrail_reset)");
  now_.cells = frames_.laid();
  return past();
}

}  // namespace rollcon
