/// Going back to a solution.

#include "contact/contact.hpp"
#include "contact/kept_solution.hpp"
#include "contact/solution.hpp"

namespace rollcon {

void Contact::forget_all_but_tractions() {
  state_->newton.forget_all();
  state_->iterate.invalidate();
}

void Contact::keep(KeptSolution& kept) const {
  const SolverState& s = *state_;
  kept.solved = s.solved;
  kept.number = s.number;
  kept.warm_usable = s.warm_usable;
  kept.iterate = s.iterate;
  kept.images_known = s.images_known;
  kept.report = s.report;
  kept.settled_friction = s.settled_friction;
}

void Contact::return_to(const KeptSolution& kept) {
  if (!kept.solved && !kept.warm_usable) return reset();
  SolverState& s = *state_;
  forget_solution(s);
  prepare_or_clear();
  // Factors for derivatives belong to the solution that was here before.
  if (s.number != kept.number) s.newton.linear().forget_exact();
  s.number = kept.number;
  s.iterate = kept.iterate;
  s.images_known = kept.images_known;
  s.report = kept.report;
  s.settled_friction = kept.settled_friction;
  if (s.prepared->problem.law->of_field()) s.given.share = s.settled_friction.share;
  s.outcome = kept.report.outcome;
  s.revision_solved = scene.revision;
  s.options_solved = scene.options.revision;
  s.solved = kept.solved;
  s.warm_usable = kept.warm_usable;
}

}  // namespace rollcon
