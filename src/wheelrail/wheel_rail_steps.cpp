/// Follows a wheel on its rail in time: steps, what they start from, and that as numbers.

#include <algorithm>
#include <cmath>

#include "contact/host.hpp"
#include "support/checksum.hpp"
#include "support/error.hpp"
#include "support/index.hpp"
#include "support/input_checks.hpp"
#include "wheelrail/wheel_rail.hpp"

namespace rollcon {

void WheelRail::set_step(std::int32_t kind, double dt) {
  Scene checks;
  checks.set_step(kind, dt);
  in_.step = checks.step_kind();
  in_.dt = checks.step_time();
}

// Finds what the step starts from: what the last one left, or the steady state that was solved last, or rest.
void WheelRail::begin_step() {
  can_repeat_ = false;
  start_ = past_;
  if (in_.step == StepKind::steady) return;
  const char* what = has_sections()          ? "bodies by a section"
                     : in_.options.conformal ? "the option conformal"
                     : in_.table             ? "forces from a table (rollcon_wheelrail_set_table)"
                                             : nullptr;
  if (what) fail(Status::err_unsupported, "a step in time (rollcon_wheelrail_set_step) does not take %s", what);
  for (const auto& slot : slot_) slot->give_way = 0;
  if (past_) {
    sink_ = past_->sink;
    return;
  }
  auto rest = std::make_shared<WheelPast>();
  if (solved_ && !is_answer(solved_->status) && solved_->status != Status::derailed)
    fail(Status::err_state,
         "the steady solve before this step did not converge: there is no state to start from; solve again, or start "
         "from rest (rollcon_wheelrail_reset)");
  if (solved_)
    for (Slot* slot : active_) {
      if (slot->contact.by_table())
        fail(Status::err_state,
             "the steady state before this step has forces from a table, which has no tractions: solve it without one, "
             "or start from rest (rollcon_wheelrail_reset)");
      if (slot->contact.status() != Status::no_contact)
        rest->patch.push_back(slot->contact.steady_past(in_.options.accuracy));
    }
  start_ = past_ = std::move(rest);
}

// Makes a step that succeeded the start of the next one; a steady state is what a step after it starts from.
void WheelRail::end_step(Status status) {
  can_repeat_ = false;
  if (in_.step == StepKind::steady) {
    start_.reset();
    past_.reset();
    return;
  }
  if (!is_answer(status) && status != Status::derailed) return;
  auto next = std::make_shared<WheelPast>();
  next->time = start_->time + in_.dt;
  next->steps = start_->steps + 1;
  next->sink = sink_;
  for (const Slot* slot : active_)
    if (slot->contact.status() != Status::no_contact) next->patch.push_back(slot->contact.past());
  past_ = std::move(next);
  can_repeat_ = true;
}

void WheelRail::repeat_step() {
  if (!can_repeat_)
    fail(
        Status::err_state,
        "there is no step to repeat: none succeeded last, or since rollcon_wheelrail_reset, rollcon_wheelrail_past_set "
        "or rollcon_wheelrail_repeat_step");
  past_ = start_;
  can_repeat_ = false;
}

void WheelRail::refuse_lists() const {
  if (in_.step != StepKind::steady)
    fail(Status::err_unsupported,
         "positions of a list are steady, and this wheel makes steps in time: call rollcon_wheelrail_set_step with "
         "ROLLCON_STEADY first");
}

namespace {

// The numbers are magic, version, count of all, mark, time, steps, sink, patches; for each patch its axes, weight,
// depth, sides, cells and tractions t1, t2, n of all nodes; a checksum of all before it.
constexpr double magic = 7274831.5, version = 1;
constexpr std::size_t header = 8, of_patch = 12 + 2 + 4 + 2;

double checksum_of(const double* v, std::size_t n) {
  Checksum sum;
  sum.add(v, n * sizeof(double));
  return static_cast<double>(sum.value() >> 12);
}

std::size_t numbers_for(std::int64_t along, std::int64_t across) {
  return of_patch + 3 * at((along + 1) * (across + 1));
}

void write(const PatchPast& p, std::vector<double>& to) {
  for (const Vec3& v : {p.axes.origin, p.axes.t1, p.axes.t2, p.axes.n}) to.insert(to.end(), v.begin(), v.end());
  const RectangleCells& c = p.cells;
  const double numbers[] = {p.weight,
                            p.depth,
                            c.box.x_least,
                            c.box.x_greatest,
                            c.box.y_least,
                            c.box.y_greatest,
                            static_cast<double>(c.along),
                            static_cast<double>(c.across)};
  to.insert(to.end(), std::begin(numbers), std::end(numbers));
  for (const std::vector<double>& t : p.traction) to.insert(to.end(), t.begin(), t.end());
}

PatchPast read(const double* from) {
  PatchPast p;
  for (Vec3* v : {&p.axes.origin, &p.axes.t1, &p.axes.t2, &p.axes.n}) {
    std::copy_n(from, 3, v->begin());
    from += 3;
  }
  p.weight = from[0];
  p.depth = from[1];
  p.cells = {{from[2], from[3], from[4], from[5]}, to_index(from[6]), to_index(from[7])};
  from += of_patch - 12;
  for (std::vector<double>& t : p.traction) {
    t.assign(from, from + p.nodes());
    from += p.nodes();
  }
  return p;
}

}  // namespace

// Marks what the numbers belong to: side and elastic constants.
double WheelRail::mark_of_past() const {
  std::vector<double> own{side_};
  for (const Body* body : {given_wheel_.get(), given_rail_.get()})
    own.insert(own.end(),
               {body->rigid() ? 1.0 : 0.0, body->rigid() ? 0 : body->young(), body->rigid() ? 0 : body->poisson()});
  return checksum_of(own.data(), own.size());
}

std::vector<double> WheelRail::past_numbers() const {
  if (!past_)
    fail(Status::err_state, "no time step was solved yet: rollcon_wheelrail_set_step and rollcon_wheelrail_solve");
  std::vector<double> all{magic,       version,
                          0,           mark_of_past(),
                          past_->time, static_cast<double>(past_->steps),
                          past_->sink, static_cast<double>(past_->patch.size())};
  for (const PatchPast& p : past_->patch) write(p, all);
  all[2] = static_cast<double>(all.size() + 1);
  all.push_back(checksum_of(all.data(), all.size()));
  return all;
}

void WheelRail::past_set(std::int64_t count, const double* from) {
  require_count(count, "n");
  require_pointer(from, "past");
  require_finite(count, 1, from, "past", 0);
  const auto n = static_cast<std::size_t>(count);
  if (n < header + 1 || from[0] != magic)
    fail(Status::err_argument, "past does not begin as what rollcon_wheelrail_past_get gives");
  if (from[1] != version)
    fail(Status::err_argument, "past is of version %g; this library reads version %g", from[1], version);
  if (from[2] != static_cast<double>(n))
    fail(Status::err_argument, "n is %lld, but past says it has %.0f numbers", static_cast<long long>(count), from[2]);
  if (checksum_of(from, n - 1) != from[n - 1])
    fail(Status::err_argument, "past has changed since it was saved: its checksum does not fit");
  require_dimensions();
  prepare_search();
  if (from[3] != mark_of_past())
    fail(Status::err_argument, "past is of a wheel on the other side, or of bodies of other elastic constants");
  auto past = std::make_shared<WheelPast>();
  past->time = from[4];
  past->steps = to_index(from[5]);
  past->sink = from[6];
  const double* next = from + header;
  const double* const end = from + n - 1;
  for (double i = 0; i < from[7]; ++i) {
    constexpr double most = 2048;
    const auto counts = [&](double cells) { return cells >= 1 && cells <= most && cells == std::floor(cells); };
    const bool whole =
        end - next >= static_cast<std::ptrdiff_t>(of_patch) && counts(next[of_patch - 2]) && counts(next[of_patch - 1]);
    const std::size_t needed = whole ? numbers_for(to_index(next[of_patch - 2]), to_index(next[of_patch - 1])) : 0;
    if (!whole || end - next < static_cast<std::ptrdiff_t>(needed))
      fail(Status::err_argument, "past is not whole: patch %.0f (counting from 0) of %.0f ends beyond its numbers", i,
           from[7]);
    past->patch.push_back(read(next));
    const Rectangle& box = past->patch.back().cells.box;
    if (!(box.x_least < box.x_greatest && box.y_least < box.y_greatest))
      fail(Status::err_argument, "past has a patch without extent: patch %.0f (counting from 0)", i);
    next += needed;
  }
  if (next != end) fail(Status::err_argument, "past has numbers beyond its %.0f patches", from[7]);
  past_ = std::move(past);
  start_.reset();
  solved_.reset();
  can_repeat_ = false;
}

}  // namespace rollcon
