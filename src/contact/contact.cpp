#include "contact/contact.hpp"

#include <algorithm>
#include <string>

#include "contact/cases/case_solver.hpp"
#include "contact/cases/solve_many.hpp"
#include "contact/contact_cases.hpp"
#include "contact/results/doubts.hpp"
#include "contact/solver.hpp"
#include "linalg/blas_threads.hpp"
#include "mesh/corner_elements.hpp"
#include "support/index.hpp"
#include "support/interrupt.hpp"

namespace rollcon {
namespace {

// Tells whether a frame of these faces would have midside nodes: pressures at the vertices of tri6 have no resultant,
// and finite elements move there otherwise than at midside nodes, so that tractions swing from node to node. Linear
// frames, told from the displacements of the vertices, do not (docs/theory.md, section 10).
bool has_tri6(const SurfaceMesh& surface, std::int32_t tag) {
  for (std::size_t e = 0; e < surface.type.size(); ++e)
    if (surface.tag[e] == tag && surface.type[e] == ElementType::tri6) return true;
  return false;
}

}  // namespace

Contact::Contact(std::shared_ptr<Context> context, std::shared_ptr<Body> body1, std::shared_ptr<Body> body2,
                 MakePublished published, MakeFrameMaker frames)
    : solver(
          std::make_unique<Solver>(Host{.context = std::move(context), .cancel = &cancel_}, body1, body2, published)),
      scene(solver->scene),
      body1_(std::move(body1)),
      body2_(std::move(body2)),
      make_frames_(frames) {
  if (body1_->rigid() && body2_->rigid())
    fail(Status::err_argument, "body1 and body2 are both rigid: at least one body must be elastic (%s)",
         elastic_kinds().c_str());
}

Contact::~Contact() = default;

void Contact::request_cancel() noexcept {
  solver->host.cancel->store(true);
}

void Contact::forget_cancel() {
  solver->host.cancel->store(false);
}

void Contact::set_progress(ProgressFunction function, void* user) {
  solver->host.progress = function;
  solver->host.user = user;
}

void Contact::frame_from_body(std::int32_t which, std::int32_t tag) {
  if (which != 1 && which != 2) fail(Status::err_argument, "which is %d; allowed: 1, 2", which);
  Body& body = which == 1 ? *body1_ : *body2_;
  const SurfaceMesh surface = body.surface_copy();
  if (surface.nodes() == 0)
    fail(Status::err_state, "body %d has no mesh: the frame needs one of its own (rollcon_contact_frame_nodes)", which);
  if (surface.elements() == 0)
    fail(Status::err_state,
         "body %d has no %selements whose faces could be the frame: call rollcon_body_add_elements "
         "first",
         which, body.traits().volume ? "volume " : "");
  const bool corners = body.traits().volume && has_tri6(surface, tag);
  scene.set_frame_from(which - 1, corners ? corner_elements(surface) : surface, tag);
}

void Contact::reset() {
  solver->reset();
  if (frames_) frames_->reset();
}

void Contact::repeat_step() {
  solver->repeat_step();
  if (frames_ && !scene.frame_given()) frames_->repeat_step();
}

std::unique_ptr<Contact> Contact::make_worker() const {
  const auto silent = std::make_shared<Context>();
  silent->set_threads(1);
  auto worker = std::make_unique<Contact>(silent, body1_, body2_, solver->engine().make_published, make_frames_);
  worker->solver->host.cancel = solver->host.cancel;
  worker->solver->host.quiet = true;
  worker->scene.take_over(scene);
  return worker;
}

Status Contact::solve() {
  // A request belongs to the solve during which it was made.
  forget_cancel();
  return solve_unless_cancelled();
}

Status Contact::solve_unless_cancelled() {
  try {
    const bool own_frames = !scene.frame_given() && make_frames_;
    if (own_frames && !frames_) frames_ = make_frames_();
    const Status found = own_frames ? frames_->solve(*solver) : solver->solve();
    solver->end_step(found);
    if (own_frames) frames_->end_step(found);
    const Status status = found == Status::ok ? with_doubts(solver->solution(), found) : found;
    if (!own_frames || status != found) solver->tell(status);
    if (scene.options.pressure_length > 0 || (status != Status::ok && status != Status::inaccurate)) return status;
    const Line sharp = describe_sharp_end(solver->solution());
    if (!*sharp.text) return status;
    solver->host.caveat(Status::inaccurate, sharp.c_str());
    return Status::inaccurate;
  } catch (const Cancelled&) {  // cancelled while patches were searched for
    solver->forget();
    return Status::cancelled;
  } catch (...) {
    solver->forget();  // a pair may have solved one frame
    throw;
  }
}

Context& Contact::context() const {
  return *solver->host.context;
}

Status Contact::solve_many(const CaseList& cases, const CaseResults& results) {
  // Forgets the last solution if something was set since: it is then that of another scene.
  const Solution& last = solver->solution();
  if (scene.revision != last.revision || scene.options.revision != last.options) solver->forget();
  forget_cancel();
  if (!scene.frame_given() && make_frames_) return solve_on_own_frames(cases, results);
  try {
    solver->prepare();
  } catch (const Cancelled&) {
    cancel_cases(cases, results, solver->host);
    return Status::cancelled;
  }
  if (cases.cases == 0) return Status::ok;
  std::size_t bytes = 0;
  const Status status =
      solve_cases([&] { return std::make_unique<SharedFrameSolver>(*solver); },
                  solver->can_share() ? solver->host.context->threads() : 1, cases, results, solver->host, bytes);
  solver->effort().peak_bytes = std::max(solver->effort().peak_bytes, solver->bytes() + bytes);
  return status;
}

Status Contact::solve_on_own_frames(const CaseList& cases, const CaseResults& results) {
  for (const CaseColumn& column : results.column)
    if (column.kind == CaseColumn::Kind::tractions)
      fail(Status::err_state,
           "no frame was given, and those of the cases have different nodes: columns may not have 'tractions'; "
           "rollcon_contact_frame_ellipse or another maker gives a frame that all share");
  const OwnFramesSolver check(*this, cases.parameter);
  solver->pair();
  if (cases.cases == 0) return Status::ok;
  std::size_t bytes = 0;
  return solve_cases([&] { return std::make_unique<OwnFramesSolver>(*this, cases.parameter); },
                     solver->host.context->threads(), cases, results, solver->host, bytes);
}

}  // namespace rollcon
