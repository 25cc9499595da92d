#include "contact/prepare/time_step.hpp"

#include <algorithm>
#include <utility>

#include "contact/prepare/before_touch.hpp"
#include "mesh/lattice_values.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon {

void PastStep::take(const Iterate& it, double datum) {
  for (std::size_t c = 0; c < 3; ++c) lambda[c] = it.lambda[c];
  motion = it.motion;
  motion[approach] += datum;
  loaded = std::any_of(lambda[2].begin(), lambda[2].end(), [](double l) { return l < 0; });
}

std::size_t StepHistory::bytes() const {
  std::size_t sum = work.traction.capacity() + work.displacement.capacity();
  for (std::size_t c = 0; c < 3; ++c)
    sum += work.image[c].capacity() + last.lambda[c].capacity() + before.lambda[c].capacity() + carried[c].capacity();
  return sum * sizeof(double);
}

namespace {

bool same_places(const Frame& a, const Frame& b) {
  return a.x == b.x && a.y == b.y;
}

// Notes the frame that the last step lies on, as long as it is the scene's.
void note_frame(PastStep& past, const Prepared& on, const Scene& scene) {
  past.mesh = scene.revision.mesh;
  if (past.on && same_places(past.on->frame, on.frame)) return;
  past.on = std::make_shared<FrameOfPast>();
  past.on->frame = on.frame;
}

// Says whether the last step lies on this frame; nodes that a body carried along are still the same ones.
bool lies_on(const PastStep& past, const Prepared& on, const Scene& scene) {
  if (past.lambda[0].size() != on.frame.x.size()) return false;
  if (past.on && same_places(past.on->frame, on.frame)) return true;
  return past.mesh == scene.revision.mesh && (on.pair.meshed() || !past.on);
}

// Finds tangential displacements at the nodes, or where their particles were a step before.
enum class Where : std::int8_t { nodes, upstream };
void tangential_displacements(const Compliance& compliance, const Prepared& on, Where where,
                              const std::vector<double> (&lambda)[3], StepWorkspace& work, std::vector<double>* to) {
  const std::size_t n = on.frame.x.size(), sources = lambda[0].size();
  std::vector<double> x = on.frame.x;
  if (where == Where::upstream)
    for (std::size_t k = 0; k < n; ++k) x[k] += upstream(on, k);
  work.traction.resize(3 * sources);
  for (std::size_t k = 0; k < sources; ++k)
    for (std::size_t c = 0; c < 3; ++c) work.traction[3 * k + c] = lambda[c][k];
  work.displacement.resize(3 * n);
  compliance.apply({x, on.frame.y}, work.traction.data(), work.displacement.data());
  for (std::size_t c = 0; to && c < 2; ++c) {
    to[c].resize(n);
    for (std::size_t k = 0; k < n; ++k) to[c][k] = work.displacement[3 * k + c];
  }
}

// Carries displacements to another frame: half-spaces answer tractions on any frame exactly.
void carry_between_frames(StepHistory& h, const Prepared& on, int threads) {
  if (on.pair.meshed())
    fail(
        Status::err_state,
        "the frame is not that of the step before, and a body has a mesh: its displacements cannot be carried from one "
        "frame to another; keep the frame, or start from rest (rollcon_contact_reset)");
  FrameOfPast& past = *h.last.on;
  if (!past.compliance) past.compliance = make_pair_compliance(past.frame, on.pair, on.accuracy, threads);
  tangential_displacements(*past.compliance, on, Where::upstream, h.last.lambda, h.work, h.carried);
}

// Carries displacements by integrals at every step, where rows are not formed.
void carry_by_integrals(StepHistory& h, const Prepared& on, const std::vector<double> (&lambda)[3]) {
  tangential_displacements(*on.compliance, on, Where::upstream, lambda, h.work, h.carried);
}

using Tractions = std::vector<double>[3];

// Returns the tractions of the step before on the scene's frame. They are carried to `moved` if the frame is a lattice
// that the library chose. null: they lie on a frame of another kind.
const Tractions* tractions_before(const PastStep& last, const Prepared& on, const Scene& scene, Tractions& moved) {
  if (lies_on(last, on, scene)) return &last.lambda;
  if (scene.frame_given() || !on.lattice || !last.on || !lies_along_axes(*on.lattice)) return nullptr;
  const std::optional<Lattice> before = find_lattice(last.on->frame);
  if (!before || !lies_along_axes(*before)) return nullptr;
  for (std::size_t c = 0; c < 3; ++c) carry_to_lattice(*before, last.lambda[c], *on.lattice, moved[c]);
  return &moved;
}

}  // namespace

void begin_step(StepHistory& h, const Solution& s, const Scene& scene) {
  if (scene.step_kind() == StepKind::steady || h.of_steps) return;
  if (h.failed)
    fail(Status::err_state,
         "the steady solve before this step did not converge: there is no state to start from; solve again, or start "
         "from rest (rollcon_contact_reset)");
  // The step starts from the steady state that was found last, or from rest.
  if (s.warm_usable) {
    h.last.take(s.iterate, s.prepared->problem.datum);
    note_frame(h.last, *s.prepared, scene);
    h.iterate_is_last = true;
  } else {
    h.last.loaded = false;
  }
  h.of_steps = true;
}

void carry_past(StepHistory& h, Preparation& preparation, const Scene& scene) {
  preparation.made->problem.before_touch.clear();
  if (scene.step_kind() == StepKind::steady) return;
  Prepared& on = *preparation.made;
  Problem& p = on.problem;
  const std::size_t n = on.frame.x.size();
  const bool none = !h.last.loaded || on.frictionless;
  for (auto& v : h.carried) v.resize(n);
  if (!none) {
    Tractions moved;
    const Tractions* const lambda = tractions_before(h.last, on, scene, moved);
    const bool rolls_in = !scene.frame_given();
    if (!lambda)
      carry_between_frames(h, on, preparation.threads);
    else if (p.op->tangential || p.op->all_at_once())
      preparation.carried.apply(on, preparation.rows, *lambda, h.carried);
    else
      carry_by_integrals(h, on, *lambda);
    if (!lambda && rolls_in && on.lattice && on.distance != 0)
      tangential_displacements(*h.last.on->compliance, on, Where::nodes, h.last.lambda, h.work, nullptr);
    if (preparation.procedure.standard()) find_shift_before_touch(h.last, lambda, h.work, on, rolls_in);
  }
  for (const auto& [slip, c] : {std::pair{&p.slip1, std::size_t{0}}, std::pair{&p.slip2, std::size_t{1}}}) {
    slip->resize(n);
    for (std::size_t k = 0; k < n; ++k) {
      const double own = preparation.rigid[c].empty() ? 0 : preparation.rigid[c][k];
      (*slip)[k] = none ? own : own - h.carried[c][k];
    }
  }
}

bool start_step(const StepHistory& h, Solution& s) {
  if (h.iterate_is_last || h.last.lambda[0].size() != s.iterate.lambda[0].size()) return false;
  s.warm_usable = h.last.loaded;
  s.iterate.clear();
  if (!h.last.loaded) return true;
  for (std::size_t c = 0; c < 3; ++c) s.iterate.lambda[c] = h.last.lambda[c];
  s.iterate.motion = h.last.motion;
  s.iterate.motion[approach] -= s.prepared->problem.datum;
  s.iterate.invalidate();
  return true;
}

void end_step(StepHistory& h, const Solution& s, const Scene& scene) {
  std::swap(h.last, h.before);
  h.last.time = h.before.time + scene.step_time();
  h.last.steps = h.before.steps + 1;
  h.last.take(s.iterate, s.prepared->problem.datum);
  if (s.report.outcome == Outcome::no_contact) h.last.loaded = false;
  if (!h.last.on || !same_places(h.last.on->frame, s.prepared->frame)) h.last.on = h.before.on;
  note_frame(h.last, *s.prepared, scene);
  h.can_repeat = true;
  h.iterate_is_last = true;
}

void repeat_step(StepHistory& h) {
  if (!h.can_repeat)
    fail(Status::err_state,
         "there is no step to repeat: none was made since the contact was, or since rollcon_contact_reset, "
         "rollcon_contact_past_set or rollcon_contact_repeat_step");
  std::swap(h.last, h.before);
  h.can_repeat = h.iterate_is_last = false;
}

void find_changes_upstream(const Solution& s, Preparation* preparation, std::vector<double> (&change)[2]) {
  const Prepared& on = *s.prepared;
  const Problem& p = on.problem;
  const std::vector<double>(&lambda)[3] = s.iterate.lambda;
  std::vector<double> here[3], ahead[3];
  if (preparation && (p.op->tangential || p.op->all_at_once())) {
    std::vector<std::int32_t> used;
    for (std::size_t k = 0; k < p.used.size(); ++k)
      if (p.used[k]) used.push_back(static_cast<std::int32_t>(k));
    for (auto* field : {&here, &ahead})
      for (auto& v : *field) v.resize(p.used.size());
    p.op->images(slip_components, {}, used, lambda, here);
    preparation->carried.apply(on, preparation->rows, lambda, ahead);
  } else {
    StepWorkspace work;
    tangential_displacements(*on.compliance, on, Where::nodes, lambda, work, here);
    tangential_displacements(*on.compliance, on, Where::upstream, lambda, work, ahead);
  }
  for (std::size_t c = 0; c < 2; ++c) {
    change[c].resize(here[c].size());
    for (std::size_t k = 0; k < here[c].size(); ++k) change[c][k] = ahead[c][k] - here[c][k];
  }
}

void forget_past(StepHistory& h) {
  for (PastStep* past : {&h.last, &h.before}) {
    past->loaded = false;
    past->time = 0;
    past->steps = 0;
    past->motion = {};
    past->on.reset();
  }
  h.can_repeat = h.of_steps = h.failed = h.iterate_is_last = false;
}

}  // namespace rollcon
