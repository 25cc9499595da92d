#include "contact/solver.hpp"

#include <algorithm>
#include <new>
#include <utility>

#include "bodies/body.hpp"
#include "contact/prepare/time_step.hpp"
#include "contact/results/doubts.hpp"
#include "contact/results/extrapolation.hpp"
#include "contact/scene/host_interrupt.hpp"
#include "contact/settle/watch.hpp"
#include "linalg/blas_threads.hpp"
#include "support/clock.hpp"
#include "support/index.hpp"
#include "support/interrupt.hpp"
#include "support/memory_limit.hpp"

namespace rollcon {
namespace {

constexpr std::size_t history_rows = 512;  // rows that need no allocation
std::atomic<std::int64_t> next_number{1};  // number of the next solution in this process

}  // namespace

Solver::Solver(Host of, std::shared_ptr<Body> body1, std::shared_ptr<Body> body2, MakePublished published)
    : host(std::move(of)), body1_(std::move(body1)), body2_(std::move(body2)) {
  engine_.make_published = published;
}

std::unique_ptr<Solver> Solver::another() const {
  return std::make_unique<Solver>(host, body1_, body2_, engine_.make_published);
}

std::unique_ptr<Solver> Solver::make_half_space(double modulus) const {
  const auto make = [&](BodyKind kind) {
    return std::make_shared<Body>(host.context, static_cast<std::int32_t>(kind));
  };
  std::shared_ptr<Body> pair[2] = {make(BodyKind::halfspace), make(BodyKind::rigid)};
  const bool creeps = bodies().creeps();
  for (std::size_t b = 0; creeps && b < 2; ++b) {
    const Body& own = *bodies().body[b];
    pair[b] = make(own.rigid() ? BodyKind::rigid : BodyKind::halfspace);
    if (!own.rigid()) pair[b]->set_elastic(0, own.young(), own.poisson());
    if (own.creeps()) pair[b]->set_relaxation(0, own.relaxation());
  }
  if (!creeps) pair[0]->set_elastic(0, modulus, 0);
  auto pressed = std::make_unique<Solver>(host, pair[0], pair[1]);
  if (creeps) pressed->scene.set_speed(scene.speed({0, 0, 0}));
  pressed->host.progress = nullptr;
  pressed->host.quiet = true;
  return pressed;
}

std::unique_ptr<Solver> Solver::make_worker() const {
  auto worker = another();
  worker->scene.options = scene.options;
  if (!can_share()) worker->preparation_ = preparation_;
  Solution& to = worker->solution_;
  to.prepared = solution_.prepared;
  to.given = solution_.given;
  to.given.utilisation.clear();
  to.frictionless = solution_.frictionless;
  to.procedure = solution_.procedure;
  to.iterate.resize(to.prepared->problem.nodes);
  return worker;
}

Iterate& Solver::start(double seconds) {
  const double begin = now_seconds();
  forget();
  prepare();
  early_ = seconds + now_seconds() - begin;
  solution_.warm_usable = true;
  solution_.iterate.clear();
  solution_.iterate.invalidate();
  return solution_.iterate;
}

void Solver::forget() {
  moving_ = nullptr;
  solution_.solved = solution_.images_known = false;
  derived_.forget();
  effort_.begin();
}

void Solver::forget_all_but_tractions() {
  engine_.newton.forget_all();
  solution_.iterate.invalidate();
}

void Solver::reset() {
  solution_.iterate.clear();
  solution_.settled.utilisation.clear();
  solution_.warm_usable = false;
  engine_.newton.linear().forget();
  forget();
  forget_past(steps_);
}

// Clears without allocating, for use where memory ran out.
void Solver::clear() {
  solution_ = Solution{};
  derived_ = Derived{};
  effort_ = Effort{};
  engine_ = Engine{Newton{}, engine_.make_published, nullptr};
  rate_finder_ = RateFinder{};
  preparation_.reset();
  frictionless_share_.reset();
  early_.reset();
  steps_.iterate_is_last = false;
}

void Solver::return_to(const Solution& solution) {
  if (!solution.solved && !solution.warm_usable) return reset();
  forget();
  prepare();
  // Factors for derivatives belong to the solution that was here before.
  if (solution_.number != solution.number) engine_.newton.linear().forget_exact();
  const auto prepared = solution_.prepared;
  solution_ = solution;
  solution_.prepared = prepared;
  solution_.revision = scene.revision;
  solution_.options = scene.options.revision;
}

// Returns one thread on frames of fewer nodes, and where no rows are formed: there threads of the BLAS save little time
// and take twice the processor's (docs/howto/speed.md, two cores).
int Solver::blas_threads() const {
  constexpr std::int64_t least_nodes = 2000;
  const Prepared* on = solution_.prepared.get();
  const bool rows = !on || !on->problem.op || !on->problem.op->all_at_once();
  return rows && scene.mesh().nodes() >= least_nodes ? host.context->threads() : 1;
}

// Removes tractions that friction carried when friction is gone.
void Solver::take_friction(bool frictionless) {
  if (frictionless && !solution_.frictionless) {
    for (int c = 0; c < 2; ++c) std::fill(solution_.iterate.lambda[c].begin(), solution_.iterate.lambda[c].end(), 0.0);
    solution_.iterate.invalidate();
  }
  solution_.frictionless = frictionless;
}

void Solver::take_changes() {
  const Changes changes = std::exchange(preparation_->changes, {});
  Iterate& it = solution_.iterate;
  if (changes.nodes) {
    it.resize(solution_.prepared->problem.nodes);
    solution_.warm_usable = false;
  }
  if (changes.images) it.invalidate();
  if (changes.operators) engine_.newton.operators_changed();
  if (changes.system) engine_.published.reset();
  it.motion[approach] -= changes.datum;
  engine_.newton.move_datum(changes.datum);
}

void Solver::prepare_parts() {
  if (!preparation_) preparation_ = std::make_shared<Preparation>();
  solution_.prepared = preparation_->made;
  preparation_->timings = {};
  effort_.builds_before = preparation_->builds;
  {
    const BlasThreads blas(blas_threads());
    const HostInterrupt interrupt(host.progress, host.user, *host.cancel);
    rollcon::prepare(*preparation_, scene, *body1_, *body2_, host.context->threads());
  }
  effort_.timings.compliance += preparation_->timings.compliance;
  effort_.timings.convection += preparation_->timings.convection;
  solution_.procedure = preparation_->procedure;
  take_changes();
  take_friction(preparation_->made->frictionless);
  solution_.given = prescribed_by(scene, *preparation_);
  carry_past(steps_, *preparation_, scene);
}

void Solver::prepare() {
  try {
    prepare_parts();
  } catch (...) {
    clear();
    throw;
  }
}

PairOfBodies Solver::pair() {
  if (!preparation_) preparation_ = std::make_shared<Preparation>();
  if (!body1_->prepared() || !body2_->prepared()) {
    const BlasThreads blas(blas_threads());
    const HostInterrupt interrupt(host.progress, host.user, *host.cancel);
    prepare_bodies(*preparation_, *body1_, *body2_);
  }
  return bodies();
}

std::optional<FrictionShare> Solver::frictionless_share() {
  const double start = now_seconds();
  forget();
  prepare();
  solution_.revision = scene.revision;
  refuse_overflow(solution_);
  try {
    const BlasThreads blas(blas_threads());
    std::optional<FrictionShare> share;
    CancelOnly monitor(*host.cancel);
    if (solution_.procedure.standard() && !solution_.frictionless) {
      if (!frictionless_share_) frictionless_share_ = std::make_unique<FrictionlessShare>();
      share = frictionless_share_->find(solution_.prepared->problem, solution_.given, solution_.procedure,
                                        scene.options.tolerance, scene.options.max_iterations, monitor);
    }
    early_ = now_seconds() - start;
    return share;
  } catch (...) {
    clear();
    throw;
  }
}

Status Solver::solve() {
  bool whole = false;
  try {
    return solve_scene(whole);
  } catch (const Cancelled&) {
    clear();
    host.context->log(LogLevel::info, "cancelled during preparation");
    return Status::cancelled;
  } catch (const std::bad_alloc&) {
    const double there = static_cast<double>(bytes()) + memory_left();
    clear();
    refuse_more_memory(there, "take a coarser or smaller frame", "the solve on a frame of %lld nodes needs more than",
                       static_cast<long long>(scene.mesh().nodes()));
  } catch (...) {
    // Whatever was half built when memory ran out or a callback threw must not be taken for whole. A refused load
    // leaves everything but the solution intact.
    if (!whole) clear();
    throw;
  }
}

// Solves the scene; `whole` tells, also after an exception, whether nothing is half built.
Status Solver::solve_scene(bool& whole) {
  Solution& s = solution_;
  const double start = now_seconds();
  const double early = std::exchange(early_, std::nullopt).value_or(0);
  const Builds before = effort_.builds_before;
  const Timings timings = effort_.timings;
  forget();
  effort_.history.reserve(8 * history_rows);
  effort_.merit.reserve(history_rows);
  Watch watch(effort_, *host.context, host.progress, host.user, *host.cancel, start);
  begin_step(steps_, s, scene);
  prepare_parts();
  if (early > 0) {
    effort_.builds_before = before;
    effort_.timings.compliance += timings.compliance;
    effort_.timings.convection += timings.convection;
  }
  if (scene.step_kind() != StepKind::steady) {
    if (start_step(steps_, s)) engine_.newton.forget_prediction();
  } else {
    steps_.of_steps = false;
    steps_.failed = true;
  }
  steps_.iterate_is_last = false;
  s.load_factor = load_factor_;
  for (const int m : {xi1, xi2, spin})
    if (s.given.by_force[at(m)]) s.given.value[at(m)] *= load_factor_;
  s.revision = scene.revision;
  s.options = scene.options.revision;
  effort_.threads = blas_threads();
  const BlasThreads blas(effort_.threads);
  const double prepared = now_seconds();
  host.context->log(LogLevel::info, "compliance and operators: %lld nodes, %.3f s",
                    static_cast<long long>(s.prepared->problem.nodes), prepared - start);
  watch.tell(Phase::compliance, 0, 0, prepared - start);
  watch.prepared(prepared - start);
  const bool warm = s.warm_usable && scene.options.warm_start != 0;
  if (!warm) {
    s.iterate.clear();
    s.settled.utilisation.clear();
  }
  s.warm_usable = false;
  whole = true;
  if (s.frictionless) refuse_tangential_loads(s.given);
  refuse_load_beside_frame(s);
  refuse_overflow(s);
  whole = false;
  solve_prepared(engine_, s, effort_, scene.options, watch);
  whole = true;
  effort_.peak_bytes = std::max(effort_.peak_bytes, bytes());
  const double end = now_seconds();
  effort_.timings.newton = end - prepared;
  effort_.timings.total = end - start + early;
  host.context->log(
      LogLevel::info, "Newton: %lld normal, %lld tangential, %lld full iterations, %lld fallbacks, %.3f s",
      static_cast<long long>(s.report.normal_iterations), static_cast<long long>(s.report.tangential_iterations),
      static_cast<long long>(s.report.full_iterations), static_cast<long long>(s.report.fallbacks),
      effort_.timings.newton);

  const Status status = status_of(s);
  s.solved = true;
  s.number = next_number.fetch_add(1);
  s.warm_usable = s.report.outcome == Outcome::converged;
  steps_.failed = s.report.outcome != Outcome::converged && s.report.outcome != Outcome::no_contact;
  return status;
}

Status Solver::solve_given(const Prescribed& given, bool frictionless, bool warm, Monitor& monitor) {
  Solution& s = solution_;
  forget();
  if (!warm) {
    s.iterate.clear();
    s.settled.utilisation.clear();
  }
  s.given = given;
  take_friction(frictionless);
  if (frictionless) refuse_tangential_loads(given);
  refuse_load_beside_frame(s);
  refuse_overflow(s);
  solve_prepared(engine_, s, effort_, scene.options, monitor);
  const Status status = with_doubts(s, status_of(s));
  s.solved = true;
  return status;
}

void Solver::end_step(Status status) {
  if (scene.step_kind() != StepKind::steady && is_answer(status)) rollcon::end_step(steps_, solution_, scene);
}

void Solver::repeat_step() {
  rollcon::repeat_step(steps_);
}

void Solver::extrapolate_from(Solver& coarse, const FrameFamily& family) {
  const Extrapolation found =
      extrapolate(solution_, coarse.solution_, family, [this](Parameter p) -> const Rates& { return own_rates(p); });
  derived_.extrapolated = found.results;
  derived_.error_estimate = found.estimate;
  effort_.timings.total += coarse.effort_.timings.total;
  effort_.peak_bytes = std::max(effort_.peak_bytes, bytes() + coarse.bytes());
  coarser_ = &coarse;
}

std::size_t Solver::bytes() const {
  if (!solution_.prepared || !solution_.prepared->problem.op) return 0;
  const Problem& p = solution_.prepared->problem;
  const Compliance* compliance = solution_.prepared->compliance.get();
  const std::size_t kept = preparation_ ? preparation_->family.bytes() + preparation_->carried.bytes() : 0;
  return p.op->bytes() + kept + steps_.bytes() + engine_.bytes() + (compliance ? compliance->bytes() : 0) +
         at(p.nodes) * sizeof(double) * 30 + effort_.history.capacity() * sizeof(double);
}

}  // namespace rollcon
