#include "wheelrail/patch_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "bodies/pair.hpp"
#include "contact/solver.hpp"
#include "framing/automatic_frames.hpp"
#include "framing/makers.hpp"
#include "framing/strips/strip_results.hpp"
#include "support/index.hpp"
#include "wheelrail/hertzian_patch.hpp"
#include "wheelrail/patch_snapshot.hpp"

namespace rollcon {
namespace {

Vec3 from_axes(const Axes& axes, const Vec3& v) {
  return v[0] * axes.t1 + v[1] * axes.t2 + v[2] * axes.n;
}

}  // namespace

PatchContact::PatchContact(std::shared_ptr<Context> context, std::shared_ptr<Body> wheel, std::shared_ptr<Body> rail,
                           const WholeBodies* whole)
    : wheel_(std::move(wheel)),
      rail_(std::move(rail)),
      contact_(std::make_shared<Contact>(context, wheel_, rail_)),
      strips_(std::make_unique<StripFrames>()) {
  if (!whole) return;
  whole_ = std::make_shared<Contact>(std::move(context), whole->body[0], whole->body[1], nullptr, make_frame_maker);
  whole_place_ = whole->place;
}

PatchContact::PatchContact(PatchContact&& other) noexcept = default;
PatchContact::~PatchContact() = default;

Status PatchContact::solve(const OverlapPatch& patch, const WheelMotion& motion, const PatchFriction& friction,
                           const Fineness& fineness, double give_way, const PatchStep& step) {
  now_.lattice = fineness.lattice;
  now_.step = step;
  now_.solves = ++solves_;
  now_.patch = patch;
  now_.motion = motion;
  lay_axes();
  take_creepages();
  now_.by_table = now_.hertzian = now_.whole = unfit_ = false;
  now_.give_way = give_way;
  bool known = false;
  if (friction.trust > 0 && friction.hertzian) {
    known = take_hertzian_results(friction, give_way);
  } else if (friction.trust > 0) {
    stand(motion);
    prescribe(give_way, {});
    solve_contact(fineness);
    known = take_table_results(friction);
  }
  if (known && friction.trust >= 1) return now_.status;
  const Vec3 force = now_.force, moment = now_.moment;
  const double power = now_.table_power;
  now_.by_table = now_.hertzian = false;
  stand(motion);
  prescribe(give_way, friction);
  step.kind == StepKind::steady ? solve_contact(fineness) : solve_step();
  const Loads loads = found_loads();
  take_results(loads.force, loads.moment);
  if (!known) return now_.status;
  now_.table_power = friction.trust * power + (1 - friction.trust) * friction_power();
  now_.force = friction.trust * force + (1 - friction.trust) * now_.force;
  now_.moment = friction.trust * moment + (1 - friction.trust) * now_.moment;
  now_.by_table = true;
  return now_.status;
}

Loads PatchContact::found_loads() const {
  if (now_.on_strips && now_.status == Status::no_contact) return {};
  if (!now_.on_strips || by_law()) return contact_->solver->loads();
  const Rates all = rates_of(strips_->totals());
  return {all.force, all.moment};
}

// Finds strips that fit the contact in a plane. Conformal contacts, and those that no strips fit, have a lattice over
// the overlap of the undeformed bodies, beyond which nothing touches.
void PatchContact::solve_contact(const Fineness& fineness) {
  shown_ = false;
  const bool may_fit = fineness.strips.along > 0 && !fineness.lattice.conformal && !now_.patch.parted;
  now_.on_strips = may_fit && solve_on_strips(fineness);
  unfit_ = may_fit && !now_.on_strips;
  if (now_.on_strips) return;
  // What is left of an overlap that is deepest near an end reaches beyond the smaller lattice.
  for (const bool whole : {false, true}) {
    now_.place = place(whole);
    put_frame(contact_->scene, fineness.lattice, now_.place, false);
    contact_->solver->forget_all_but_tractions();
    now_.status = contact_->solver->solve();
    if (now_.status != Status::rim_contact || now_.patch.cut || now_.give_way == 0) break;
  }
}

bool PatchContact::solve_on_strips(const Fineness& fineness) {
  Solver& on = *contact_->solver;
  on.pair();
  strips::StripStatus found = strips::StripStatus::unfit;
  for (const auto& [counts, patient] :
       {std::pair{fineness.strips, false}, {fineness.strips, true}, {fineness.finer, true}})
    if ((found == strips::StripStatus::unfit || found == strips::StripStatus::not_converged) &&
        (fineness.patient || !patient))
      found = strips_->fit(on, box(), counts, patient);
  if (found == strips::StripStatus::no_contact) {
    now_.status = Status::no_contact;
    if (strips_->by_law()) on.reset();
    return true;
  }
  if (found != strips::StripStatus::solved || (strips_->by_law() && !solve_law_on_strips())) return false;
  if (!strips_->by_law()) now_.status = Status::ok;
  if (now_.status == Status::ok && strips::largest_pressure(strips_->solution().strips).pressure > modulus())
    now_.status = Status::too_deep;
  return true;
}

// Solves what resists slip, which strips do not know, on the frame of the strips. Returns false without an answer.
bool PatchContact::solve_law_on_strips() {
  contact_->solver->forget_all_but_tractions();
  now_.status = strips_->show(*contact_->solver, strips_->seconds(), true);
  shown_ = true;
  const bool answered = is_answer(now_.status) || now_.status == Status::cancelled;
  if (!answered) strips_->forget();
  return answered;
}

Status PatchContact::show() const {
  if (!now_.on_strips || shown_) return now_.status;
  shown_ = true;
  if (now_.status != Status::no_contact) return strips_->show(*contact_->solver, strips_->seconds());
  put_frame(contact_->scene, now_.lattice, place(false), false);
  return contact_->solver->solve();
}

const std::shared_ptr<Contact>& PatchContact::contact() const {
  show();
  return now_.whole ? whole_ : contact_;
}

// Takes results from the table for pressures that were solved for; returns false where it does not have this patch.
bool PatchContact::take_table_results(const PatchFriction& friction) {
  const Loads loads = found_loads();
  if (now_.status != Status::ok && now_.status != Status::coarse && now_.status != Status::rim_contact &&
      now_.status != Status::no_contact)
    return false;
  now_.force = now_.moment = {};
  now_.table_power = 0;
  const HertzianPatch h = hertzian_patch(now_.patch, modulus(), now_.give_way);
  if (now_.status != Status::no_contact && !(h.load > 0 && take_table_forces(friction, h, -loads.force[2])))
    return false;
  const Vec3 along = now_.force, turning = now_.moment;
  take_results(loads.force, loads.moment);
  now_.force = now_.force + along;
  now_.moment = now_.moment + turning;
  now_.by_table = true;
  return true;
}

// Takes results for the patch's ellipse, without its pressures; returns false where the table does not have it.
bool PatchContact::take_hertzian_results(const PatchFriction& friction, double give_way) {
  const PatchCalibration& c = friction.calibration;
  const HertzianPatch h = hertzian_patch(now_.patch, modulus(), give_way);
  const double load = c.load * h.load;
  now_.force = now_.moment = {};
  now_.table_power = 0;
  if (h.load > 0 && !take_table_forces(friction, h, load)) return false;
  const Vec3 normal = -load * now_.axes.n;
  now_.force = now_.force + normal;
  if (h.load > 0) now_.moment = now_.moment + cross(now_.arm, normal);
  now_.hertzian_pressure = c.pressure * h.max_pressure;
  now_.hertzian_area = std::numbers::pi * c.a * c.b * h.a * h.b;
  now_.status = h.load > 0 ? Status::ok : Status::no_contact;
  if (now_.hertzian_pressure > modulus()) now_.status = Status::too_deep;
  now_.by_table = now_.hertzian = true;
  now_.on_strips = false;
  contact_->reset();
  return true;
}

double PatchContact::modulus() const {
  return contact_modulus(contact_->solver->pair());
}

double PatchContact::max_pressure() const {
  if (now_.hertzian) return now_.hertzian_pressure;
  if (!now_.on_strips) return solved().stat("max_pressure");
  return now_.status == Status::no_contact ? 0 : strips::largest_pressure(strips_->solution().strips).pressure;
}

double PatchContact::area() const {
  if (now_.hertzian) return now_.hertzian_area;
  if (!now_.on_strips) return solved().stat("contact_area");
  return now_.status == Status::no_contact ? 0 : strips::area(strips_->solution().strips);
}

double PatchContact::friction_power() const {
  if (now_.on_strips && !now_.by_table && !by_law()) {
    if (now_.status == Status::no_contact) return 0;
    if (const auto power = strips_->friction_power()) return *power;
  }
  return now_.by_table ? now_.table_power : contact()->stat("friction_power");
}

// Resets the patch so that nothing of it depends on what was solved before.
void PatchContact::reset() {
  now_.solves = ++solves_;
  now_.on_strips = shown_ = now_.whole = false;
  strips_->forget();
  contact_->reset();
  if (whole_) whole_->reset();
}

void PatchContact::keep(Kept& kept) const {
  kept.state = now_;
  kept.state.owner = this;
  if (now_.on_strips) kept.strips = strips_->solution();
  if (!now_.whole && (!now_.on_strips || by_law())) kept.solution = contact_->solver->solution();
}

void PatchContact::return_to(const Kept& kept) {
  if (kept.state.owner == this && kept.state.solves == now_.solves) return;
  now_ = kept.state;
  now_.solves = ++solves_;
  shown_ = false;
  begun_.reset();
  if (now_.whole) {
    solve_whole(now_.normal, now_.alone);
    return;
  }
  if (now_.on_strips) {
    stand(now_.motion);
    prescribe(now_.give_way, now_.friction);
    contact_->solver->pair();
    strips_->return_to(kept.strips, *contact_->solver, box());
    if (!by_law()) return;
    if (now_.status == Status::no_contact) return contact_->solver->reset();
    strips_->put_frame(contact_->scene);
    contact_->solver->return_to(kept.solution);
    shown_ = true;
    return;
  }
  if (!kept.solution.solved) {
    contact_->reset();
    return;
  }
  stand(now_.motion);
  prescribe(now_.give_way, now_.friction);
  if (now_.step.kind == StepKind::steady)
    put_frame(contact_->scene, kept.state.lattice, kept.state.place, false);
  else
    frames_.lay(*contact_->solver, now_.cells.box, now_.cells.along, now_.cells.across);
  contact_->solver->return_to(kept.solution);
}

namespace {

const FrictionGiven& without_friction() {
  static const FrictionGiven none = [] {
    FrictionGiven given;
    const double mu = 0;
    given.set_law("coulomb", 1, &mu);
    return given;
  }();
  return none;
}

}  // namespace

// Prescribes approach and friction; points across count from the middle of the frame, along t2.
void PatchContact::prescribe(double give_way, const PatchFriction& friction) {
  now_.give_way = give_way;
  now_.friction = friction;
  now_.friction.table = nullptr;  // the contact alone is solved here
  contact_->scene.prescribe(static_cast<std::int32_t>(Direction::normal), static_cast<std::int32_t>(How::by_motion),
                            -give_way);
  give_friction(contact_->scene);
}

void PatchContact::give_friction(Scene& scene) const {
  const PatchFriction& friction = now_.friction;
  scene.take_friction(friction.law ? *friction.law : without_friction(), friction.mu);
  const std::size_t n = friction.points;
  std::array<double, 2 * PatchFriction::most> point{};
  const bool along = dot(now_.axes.t2, now_.patch.lateral) > 0;
  const double sign = along ? 1 : -1, middle = dot(now_.axes.origin - now_.patch.reference, sign * now_.axes.t2);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t from = along ? i : n - 1 - i;
    point[2 * i] = sign * (friction.lateral[from] - middle);
    point[2 * i + 1] = friction.at[from];
  }
  scene.set_friction_across(static_cast<std::int64_t>(n), point.data());
}

// Takes force and moment on the wheel, in and about the axes of the contact.
void PatchContact::take_results(const Vec3& force, const Vec3& moment) {
  now_.force = from_axes(now_.axes, force);
  now_.moment = from_axes(now_.axes, moment) + cross(now_.axes.origin - now_.patch.reference, now_.force);
}

double speed_through(const OverlapPatch& patch, const WheelMotion& motion) {
  const Vec3 wheel = motion.velocity.at(patch.reference - patch.overlap * patch.normal),
             rail = motion.rail.at(patch.reference);
  return dot(Vec3{motion.speed, 0, 0} - 0.5 * (wheel + rail), patch.along);
}

void PatchContact::take_creepages() {
  const WheelMotion& motion = now_.motion;
  // The wheel's surface is as far inside the rail as both overlap, which belongs to its rolling radius.
  const Vec3 wheel = motion.velocity.at(now_.patch.reference + now_.patch.overlap * now_.axes.n),
             rail = motion.rail.at(now_.patch.reference), slip = wheel - rail;
  const Vec3 turning = motion.velocity.angular - motion.rail.angular;
  if (now_.step.kind == StepKind::shift) {
    const double dt = now_.step.dt;
    now_.creepages = {dt * dot(slip, now_.patch.along), dt * dot(slip, now_.patch.lateral),
                      -dt * dot(turning, now_.patch.normal)};
    return;
  }
  const double speed = std::abs(speed_through(now_.patch, motion));
  now_.creepages = {dot(slip, now_.patch.along) / speed, dot(slip, now_.patch.lateral) / speed,
                    -dot(turning, now_.patch.normal) / speed};
}

}  // namespace rollcon
