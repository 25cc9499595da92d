#include "contact/contact.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <new>
#include <string>

#include "contact/cases/case_solver.hpp"
#include "contact/cases/solve_many.hpp"
#include "contact/contact_cases.hpp"
#include "contact/estimate/error_estimate.hpp"
#include "contact/estimate/few_nodes.hpp"
#include "contact/prepare/time_step.hpp"
#include "contact/results/doubts.hpp"
#include "contact/results/extrapolation.hpp"
#include "contact/results/outcome_text.hpp"
#include "contact/scene/host_interrupt.hpp"
#include "contact/scene/known_gap.hpp"
#include "contact/settle/watch.hpp"
#include "contact/solution.hpp"
#include "linalg/blas_threads.hpp"
#include "mesh/corner_elements.hpp"
#include "support/clock.hpp"
#include "support/index.hpp"
#include "support/interrupt.hpp"

namespace rollcon {
namespace {

constexpr std::size_t history_rows = 512;  // room without allocation
std::atomic<std::int64_t> next_number{1};  // number of the next solution in this process

// Pressures at the vertices of tri6 have no resultant, and under a smooth one finite elements move there otherwise than
// at midside nodes: tractions on both swing from node to node. Linear ones, told from the displacements of the
// vertices, do not (docs/theory.md, section 10).
bool has_tri6(const SurfaceMesh& surface, std::int32_t tag) {
  for (std::size_t e = 0; e < surface.type.size(); ++e)
    if (surface.tag[e] == tag && surface.type[e] == ElementType::tri6) return true;
  return false;
}

}  // namespace

Contact::Contact(std::shared_ptr<Context> context, std::shared_ptr<Body> body1, std::shared_ptr<Body> body2,
                 MakePublished published, MakeFrameMaker frames)
    : context_(std::move(context)),
      body1_(std::move(body1)),
      body2_(std::move(body2)),
      state_(std::make_unique<SolverState>()),
      make_frames_(frames) {
  state_->make_published = published;
  if (body1_->rigid() && body2_->rigid())
    fail(Status::err_argument, "body1 and body2 are both rigid: at least one body must be elastic (%s)",
         elastic_kinds().c_str());
}

Contact::~Contact() = default;

void Contact::clear_state() {
  // Where memory ran out, nothing may be allocated.
  const MakePublished published = state_->make_published;
  StepHistory steps = std::move(state_->steps);
  steps.iterate_is_last = false;
  *state_ = SolverState{};
  state_->make_published = published;
  state_->steps = std::move(steps);
}

void Contact::prepare_or_clear() {
  state_->settled = false;
  try {
    const BlasThreads blas(blas_threads());
    prepare(*state_, scene, *body1_, *body2_, context_->threads());
  } catch (...) {
    clear_state();
    throw;
  }
  state_->settled = true;
}

// On frames of fewer nodes, and where no rows are formed, threads of the BLAS save little time and take twice the
// processor's (docs/howto/speed.md, two cores).
int Contact::blas_threads() const {
  constexpr std::int64_t least_nodes = 2000;
  const bool rows = !state_->prepared || !state_->prepared->problem.op || !state_->prepared->problem.op->all_at_once();
  return rows && scene.mesh().nodes() >= least_nodes ? context_->threads() : 1;
}

void Contact::set_progress(ProgressFunction function, void* user) {
  progress_ = function;
  progress_user_ = user;
}

void Contact::frame_from_body(std::int32_t which, std::int32_t tag) {
  if (which != 1 && which != 2) fail(Status::err_argument, "which is %d; allowed: 1, 2", which);
  Body& body = which == 1 ? *body1_ : *body2_;
  const SurfaceMesh surface = body.surface_copy();
  if (surface.nodes() == 0)
    fail(Status::err_state, "body %d has no mesh: the frame needs one of its own (rollcon_contact_set_frame_nodes)",
         which);
  if (surface.elements() == 0)
    fail(Status::err_state,
         "body %d has no %selements whose faces could be the frame: call rollcon_body_add_elements "
         "first",
         which, body.traits().volume ? "volume " : "");
  const bool corners = body.traits().volume && has_tri6(surface, tag);
  scene.set_frame_from(which - 1, corners ? corner_elements(surface) : surface, tag);
}

std::int64_t Contact::nodes() const {
  return scene.mesh().nodes();
}
std::int64_t Contact::elements() const {
  return scene.mesh().elements();
}

void Contact::reset() {
  SolverState& s = *state_;
  s.iterate.clear();
  s.settled_friction.share.clear();
  s.newton.linear().forget();
  s.warm_usable = false;
  forget_solution(s);
  forget_past(s);
  if (frames_) frames_->reset();
}

void Contact::end_step(Status status) {
  if (scene.step_kind() != StepKind::steady && is_answer(status)) rollcon::end_step(*state_, scene);
}

bool Contact::is_answer(Status status) {
  return status == Status::ok || status == Status::rim_contact || status == Status::coarse ||
         status == Status::no_contact || status == Status::inaccurate || status == Status::too_deep;
}

std::unique_ptr<Contact> Contact::make_follower() const {
  auto follower = std::make_unique<Contact>(context_, body1_, body2_, state_->make_published);
  follower->cancel_ = cancel_;
  follower->quiet_ = quiet_;
  return follower;
}

std::unique_ptr<Contact> Contact::make_twin() const {
  const auto silent = std::make_shared<Context>();
  silent->set_threads(1);
  auto twin = std::make_unique<Contact>(silent, body1_, body2_, state_->make_published, make_frames_);
  twin->cancel_ = cancel_;
  twin->quiet_ = true;
  twin->scene.follow(scene);
  return twin;
}

std::size_t Contact::bytes() const {
  return state_->prepared && state_->prepared->problem.op ? state_->bytes() : 0;
}

std::unique_ptr<Contact> Contact::make_half_space(double modulus) const {
  const auto elastic = std::make_shared<Body>(context_, static_cast<std::int32_t>(BodyKind::halfspace));
  elastic->set_elastic(0, modulus, 0);
  const auto rigid = std::make_shared<Body>(context_, static_cast<std::int32_t>(BodyKind::rigid));
  auto follower = std::make_unique<Contact>(context_, elastic, rigid);
  follower->cancel_ = cancel_;
  follower->quiet_ = true;
  return follower;
}

void Contact::follow(const Contact& lead) {
  scene.follow(lead.scene);
  progress_ = lead.progress_;
  progress_user_ = lead.progress_user_;
}

Status Contact::solve() {
  // A request belongs to the solve during which it was made.
  cancel_->store(false);
  return solve_unless_cancelled();
}

Status Contact::solve_unless_cancelled() {
  try {
    const bool own_frames = !scene.frame_given() && make_frames_;
    if (own_frames && !frames_) frames_ = make_frames_();
    const Status found = own_frames ? frames_->solve(*this) : solve_on_frame();
    end_step(found);
    if (own_frames) frames_->end_step(found);
    const Status status = with_doubts(*state_, found);
    if (!own_frames || status != found) tell(status);
    return status;
  } catch (const Cancelled&) {  // while patches were searched for
    forget_solution(*state_);
    return Status::cancelled;
  } catch (...) {
    forget_solution(*state_);  // a pair may have solved one frame
    throw;
  }
}

void Contact::tell(Status status) const {
  const SolverState& s = *state_;
  if (!s.solved || status == Status::ok || with_doubts(s, status_of(s)) != status) return;
  if (const Line doubt = describe_meshes(s); *doubt.text && is_answer(status)) caveat(status, doubt.c_str());
  if (status == Status::coarse) {
    if (nodes_at_rim(s) > 0) caveat(status, describe_outcome(s).c_str());
    caveat(status, describe_few_nodes(s).c_str());
  } else if (status == Status::not_converged || status == Status::rim_contact || status == Status::too_deep) {
    caveat(status, describe_outcome(s).c_str());
  }
}

void Contact::extrapolate_from(const Contact& coarse, const FrameFamily& family) {
  extrapolate(*state_, *coarse.state_, family);
  state_->timings.total += coarse.state_->timings.total;
  state_->peak_bytes = std::max(state_->peak_bytes, state_->bytes() + coarse.state_->bytes());
  coarser_ = &coarse;
}

double Contact::modulus() {
  prepare_bodies(*state_, *body1_, *body2_);
  return contact_modulus({{body1_.get(), body2_.get()}, {scene.pose(0), scene.pose(1)}});
}

double Contact::dundurs_beta() {
  prepare_bodies(*state_, *body1_, *body2_);
  return rollcon::dundurs_beta({{body1_.get(), body2_.get()}, {scene.pose(0), scene.pose(1)}});
}

bool Contact::knows_gap_between_nodes() const {
  if (scene.has_gap()) return scene.gap_grid() || (scene.quadratic_gap() && meshed());
  return body1_->has_surface() || body2_->has_surface();
}

std::unique_ptr<KnownGap> Contact::gap_between_nodes() {
  prepare_bodies(*state_, *body1_, *body2_);
  return known_gap(scene, {{body1_.get(), body2_.get()}, {scene.pose(0), scene.pose(1)}});
}

bool Contact::meshed() const {
  return body1_->meshed() || body2_->meshed();
}

bool Contact::half_spaces() const {
  return !meshed() && PairOfBodies{{body1_.get(), body2_.get()}}.half_spaces();
}

bool Contact::surfaces_deform() const {
  const auto deforms = [](const Body& body) { return !body.has_surface() || (body.meshed() && !body.rigid()); };
  return deforms(*body1_) && deforms(*body2_);
}

double Contact::error_estimate() const {
  return find_error_estimate(*state_).worst();
}

void Contact::caveat(Status status, const char* text) const {
  if (quiet_) return;
  context_->caveat(status, "%s", text);
}

void Contact::log(LogLevel level, const char* text) const {
  context_->log(level, "%s", text);
}

Status Contact::solve_on_frame() {
  try {
    return solve_scene();
  } catch (const Cancelled&) {
    clear_state();
    context_->log(LogLevel::info, "cancelled during preparation");
    return Status::cancelled;
  } catch (const std::bad_alloc&) {
    const double held = 1e-9 * static_cast<double>(bytes());
    clear_state();
    fail(Status::err_memory, "%s; the solve on a frame of %lld nodes held %.3g GB", out_of_memory_text(),
         static_cast<long long>(nodes()), held);
  } catch (...) {
    // Whatever was half built when memory ran out or a callback threw must not be taken for whole. A refused load
    // leaves everything but the solution intact.
    if (!state_->settled) clear_state();
    throw;
  }
}

Status Contact::solve_scene() {
  SolverState& s = *state_;
  const double start = now_seconds();
  forget_solution(s);
  s.settled = false;
  s.history.reserve(8 * history_rows);
  s.merit.reserve(history_rows);
  const BlasThreads blas(blas_threads());
  Watch watch(s, *context_, progress_, progress_user_, *cancel_, start);
  begin_step(s, scene);
  {
    const HostInterrupt interrupt(progress_, progress_user_, *cancel_);
    prepare(s, scene, *body1_, *body2_, context_->threads());
  }
  if (scene.step_kind() != StepKind::steady)
    start_step(s);
  else
    s.steps.of_steps = false, s.steps.failed = true;
  s.steps.iterate_is_last = false;
  double ahead = 0;
  if (s.ahead.known) {
    s.work_before = s.ahead.work_before;
    s.assemblies_before = s.ahead.assemblies_before;
    s.timings.compliance += s.ahead.timings.compliance;
    s.timings.convection += s.ahead.timings.convection;
    ahead = s.ahead.seconds;
    s.ahead.known = false;
  }
  s.load_factor = load_factor_;
  for (const int m : {xi1, xi2, spin})
    if (const auto k = static_cast<std::size_t>(m); s.given.by_force[k]) s.given.value[k] *= load_factor_;
  s.revision_solved = scene.revision;
  s.options_solved = scene.options.revision;
  s.threads = blas_threads();
  const BlasThreads fewer(s.threads);  // one where the frame needs no rows
  const double prepared = now_seconds();
  context_->log(LogLevel::info, "compliance and operators: %lld nodes, %.3f s",
                static_cast<long long>(s.prepared->problem.nodes), prepared - start);
  watch.tell(Phase::compliance, 0, 0, prepared - start);
  watch.prepared(prepared - start);
  const bool warm = s.warm_usable && scene.options.warm_start != 0;
  if (!warm) {
    s.iterate.clear();
    s.settled_friction.share.clear();
  }
  s.warm_usable = false;

  s.settled = true;
  if (s.frictionless) refuse_tangential_loads(s.given);
  refuse_load_beside_frame(s);
  refuse_overflow(s);
  s.settled = false;
  solve_prepared(s, scene.options, watch);
  s.settled = true;
  s.outcome = s.report.outcome;
  s.peak_bytes = std::max(s.peak_bytes, s.bytes());
  const double end = now_seconds();
  s.timings.newton = end - prepared;
  s.timings.total = end - start + ahead;
  context_->log(
      LogLevel::info, "Newton: %lld normal, %lld tangential, %lld full iterations, %lld fallbacks, %.3f s",
      static_cast<long long>(s.report.normal_iterations), static_cast<long long>(s.report.tangential_iterations),
      static_cast<long long>(s.report.full_iterations), static_cast<long long>(s.report.fallbacks), s.timings.newton);

  const Status status = status_of(s);
  s.solved = true;
  s.number = next_number.fetch_add(1);
  s.warm_usable = s.outcome == Outcome::converged;
  s.steps.failed = s.outcome != Outcome::converged && s.outcome != Outcome::no_contact;
  return status;
}

Status Contact::solve_many(const CaseList& cases, const CaseResults& results) {
  SolverState& s = *state_;
  // What was set since the last solve makes its results those of another scene.
  if (scene.revision != s.revision_solved || scene.options.revision != s.options_solved) forget_solution(s);
  cancel_->store(false);
  const CaseHost host{*context_, progress_, progress_user_, *cancel_};
  const bool own_frames = !scene.frame_given() && make_frames_;
  if (own_frames) return solve_on_own_frames(cases, results, host);
  try {
    const HostInterrupt interrupt(progress_, progress_user_, *cancel_);
    prepare_or_clear();
  } catch (const Cancelled&) {
    cancel_cases(cases, results, host);
    return Status::cancelled;
  }
  if (cases.cases == 0) return Status::ok;
  std::size_t bytes = 0;
  const Status status = solve_cases([&] { return std::make_unique<SharedFrameSolver>(s, scene.options); },
                                    can_share(s) ? context_->threads() : 1, cases, results, host, bytes);
  s.peak_bytes = std::max(s.peak_bytes, s.bytes() + bytes);
  return status;
}

Status Contact::solve_on_own_frames(const CaseList& cases, const CaseResults& results, const CaseHost& host) {
  for (const CaseColumn& column : results.column)
    if (column.kind == CaseColumn::Kind::tractions)
      fail(Status::err_state,
           "no frame was given, and those of the cases have different nodes: columns may not have 'tractions'; "
           "rollcon_contact_frame_ellipse or another maker gives a frame that all share");
  const OwnFramesSolver check(*this, cases.parameter);
  prepare_bodies(*state_, *body1_, *body2_);
  if (cases.cases == 0) return Status::ok;
  std::size_t bytes = 0;
  return solve_cases([&] { return std::make_unique<OwnFramesSolver>(*this, cases.parameter); }, context_->threads(),
                     cases, results, host, bytes);
}

}  // namespace rollcon
