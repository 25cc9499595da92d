#include "wheelrail/wheel_rail.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "contact/results/doubts.hpp"
#include "contact/solver.hpp"
#include "framing/hertz.hpp"
#include "support/error.hpp"
#include "wheelrail/fineness.hpp"

namespace rollcon {
namespace {

double depth_of(const OverlapPatch& patch) {
  return patch.share * patch.overlap;
}

// Fractions of the wheel's radius. Overlaps of steel wheels under 200 kN are a third of the first at most; at it
// pressures are 2 to 5 percent of the modulus of contact.
constexpr double too_deep = 1e-3, nonsense = 0.1;
// Fraction of the wheel's vertical force: a patch that carries less may have few nodes.
constexpr double little_load = 0.01;

}  // namespace

void WheelRail::require_dimensions() const {
  const char* missing = !track_            ? "rollcon_wheelrail_set_track"
                        : !wheelset_given_ ? "rollcon_wheelrail_set_wheelset"
                                           : nullptr;
  if (missing) fail(Status::err_state, "something is missing: call %s first", missing);
}

void WheelRail::prepare() {
  require_dimensions();
  const char* missing = !in_.position_given   ? "rollcon_wheelrail_set_position"
                        : !in_.velocity_given ? "rollcon_wheelrail_set_velocity"
                                              : nullptr;
  if (missing) fail(Status::err_state, "something is missing: call %s first", missing);
  require_friction();
  if (in_.step != StepKind::shift && onward(in_) == 0)
    fail(Status::err_argument, "%s is 0; allowed: any other",
         roller_ > 0 ? "the speed along the roller, its rate times its radius plus entry 0 of velocity,"
                     : "the forward speed, entry 0 of velocity,");
  prepare_search();
  const char* bent = wheel_varies_ != 0  ? "the profile of the wheel varies"
                     : rail_varies_ != 0 ? "the profile of the rail varies"
                     : roller_ > 0       ? "the rail is a roller"
                                         : nullptr;
  if (bent && (in_.table || in_.options.conformal))
    fail(Status::err_unsupported, "%s, which %s does not take: %s", bent,
         in_.table ? "a table" : "the option conformal",
         in_.table ? "call rollcon_wheelrail_set_table with NULL" : "set the option to 0");
}

void WheelRail::require_ready_for_positions() {
  refuse_lists();
  require_dimensions();
  require_friction();
  prepare_search();
}

void WheelRail::prepare_search() {
  follow_bodies();
  if (has_sections()) refuse_for_sections();
  if (search_) return;
  if (roller_ > 0 && rail_varies_ != 0)
    fail(Status::err_unsupported,
         "the rail is a roller (rollcon_wheelrail_set_roller), and its profile varies; allowed: "
         "profiles that are the same all round");
  wheel_ = given_wheel_->with_profile_alone();
  rail_ = given_rail_->with_profile_alone();
  if (roller_ > 0) rail_->turn_profile_over();
  const Vec3 centre{0, 0, -radius_}, axis{0, 1, 0};
  place_profiles(*wheel_, *rail_);
  rail_shape_.slices = rail_->slices();
  search_.emplace(WheelShape{wheel_curve_, centre, axis, radius_, wheel_->slices()}, rail_shape_);
  active_.clear();
  slot_.clear();
  spare_.clear();
  sink_ = 0;
  derived_ = can_repeat_ = false;
  past_.reset();
}

WheelRail::Slot& WheelRail::add_slot() {
  if (!spare_.empty()) {
    slot_.push_back(std::move(spare_.back()));
    spare_.pop_back();
    Slot& slot = *slot_.back();
    slot.contact.reset();
    slot.give_way = slot.wheel_y = 0;
    slot.taken = slot.unfit = false;
    return slot;
  }
  const WholeBodies whole = whole_bodies();
  return *slot_.emplace_back(
      std::make_unique<Slot>(Slot{PatchContact(context_, wheel_, rail_, has_sections() ? &whole : nullptr)}));
}

WheelRail::Slot& WheelRail::slot_for(const OverlapPatch& patch) {
  Slot* nearest = nullptr;
  const auto far = [&](const Slot& slot) { return std::abs(slot.wheel_y - patch.wheel_y); };
  for (const auto& slot : slot_)
    if (!slot->taken && (!nearest || far(*slot) < far(*nearest))) nearest = slot.get();
  if (!nearest) nearest = &add_slot();
  nearest->taken = true;
  nearest->wheel_y = patch.wheel_y;
  return *nearest;
}

Status WheelRail::solve_at(double z) {
  z_ = z;
  const WheelMotion motion = motion_at(z);
  search_->find(motion.pose, found_, merge_rule(in_), motion.along);
  for (const auto& slot : slot_) slot->taken = false;
  active_.clear();
  double deepest = 0;
  for (const OverlapPatch& patch : found_) deepest = std::max(deepest, patch.overlap);
  if (!in_.by_force && deepest > nonsense * radius_)
    fail(Status::err_argument,
         "z is %g (y is %g): wheel and rail overlap by %g, more than a tenth of the wheel's radius (%g); check z, y, "
         "both profiles and all units",
         z, side_ * in_.position.y, deepest, radius_);
  Status worst = Status::ok;
  if (found_.empty())
    worst = std::isfinite(search_->first_touch(motion.pose, motion.along)) ? Status::no_contact : Status::derailed;
  else if (deepest > too_deep * radius_)
    worst = Status::too_deep;
  for (const OverlapPatch& patch : found_) active_.push_back(&slot_for(patch));
  if (active_.size() == 1 && !has_sections()) active_.front()->give_way = 0;
  // A few rounds settle what patches give way under each other, a small part of their overlap.
  constexpr int most_rounds = 30;
  for (int round = 0;; ++round) {
    if (round == most_rounds) {
      worst = Status::not_converged;
      break;
    }
    for (std::size_t i = 0; i < active_.size() && !cancelled(); ++i)
      if (round == 0 || way_[i].moved) solve_patch(*active_[i], found_[i], motion);
    if (active_.size() == 1 || has_sections() || cancelled() || !foresee_ways()) break;
  }
  for (const Slot* slot : active_) {
    Status status = slot->contact.status();
    if (status == Status::coarse && length(slot->contact.force()) < little_load * std::abs(vertical_force()))
      status = Status::ok;
    if (status == Status::ok && slot->contact.overlap().cut) status = Status::rim_contact;
    if (status != Status::no_contact) worst = worse(worst, status);
  }
  ++solves_;
  if (cancelled()) worst = Status::cancelled;
  return worst;
}

void WheelRail::solve_patch(Slot& slot, const OverlapPatch& patch, const WheelMotion& motion) {
  require_onward(patch, motion);
  try {
    PatchFriction friction = friction_of(patch);
    calibrate(patch, slot.give_way, friction);
    Fineness fineness = fineness_for(in_.options, on_lattices_, patch);
    fineness.patient = !slot.unfit;
    slot.contact.solve(patch, motion, friction, fineness, slot.give_way,
                       {in_.step, in_.dt, in_.options.accuracy, start_});
    hasty_ = hasty_ || (slot.contact.unfit() && slot.unfit);
    slot.unfit = slot.unfit || slot.contact.unfit();
  } catch (const Error& e) {
    if (!in_.options.conformal || e.status() != Status::err_mesh) throw;
    fail(Status::err_mesh,
         "the patch at y = %g of the wheel's profile turns by more than 60 degrees from its mean normal to a side, "
         "which conformal frames do not: check load and profiles, or set the option conformal to 0",
         patch.wheel_y);
  }
}

// Uses Boussinesq's point load; tangential loads and tilted normals are left out.
double WheelRail::give_way_per_load(const OverlapPatch& here, const OverlapPatch& there, double modulus) const {
  const double distance = length(here.reference - there.reference), along = dot(here.normal, there.normal);
  return distance > 0 && along > 0 ? there.beside(here) * along / (distance * std::numbers::pi * modulus) : 0;
}

// Sets what patches give way under each other for the next round; returns false where none has to be solved again.
// Loads are foreseen to grow as the power 3/2 of what is left of the overlap.
bool WheelRail::foresee_ways() {
  constexpr int most = 50;
  constexpr double settled = 1e-6;  // part of the overlap
  way_.clear();
  for (const Slot* slot : active_)
    way_.push_back({dot(slot->contact.force(), slot->contact.overlap().normal), slot->give_way, slot->give_way});
  const auto under_others = [&](std::size_t i) {
    const OverlapPatch& here = active_[i]->contact.overlap();
    const double modulus = active_[i]->contact.modulus();
    double sum = 0;
    for (std::size_t j = 0; j < way_.size(); ++j) {
      if (j == i) continue;
      const OverlapPatch& there = active_[j]->contact.overlap();
      const double left = there.overlap - way_[j].before,
                   part = left > 0 ? std::max(0.0, there.overlap - way_[j].now) / left : 1;
      sum += give_way_per_load(here, there, modulus) * way_[j].load * part * std::sqrt(part);
    }
    return std::max(sum, 0.0);
  };
  double change = 1;
  for (int round = 0; round < most && change > 0; ++round) {
    change = 0;
    for (std::size_t i = 0; i < way_.size(); ++i) {
      const double found = under_others(i);
      change = std::max(change, std::abs(found - way_[i].now));
      way_[i].now = found;
    }
  }
  bool any = false;
  for (std::size_t i = 0; i < way_.size(); ++i) {
    Way& way = way_[i];
    way.moved = std::abs(way.now - way.before) > settled * active_[i]->contact.overlap().overlap;
    any = any || way.moved;
    if (way.moved) active_[i]->give_way = way.now;
  }
  return any;
}

double WheelRail::vertical_force() const {
  double force = 0;
  for (const Slot* slot : active_) force -= slot->contact.overlap().share * slot->contact.force()[2];
  return force;
}

// Returns Hertz's approach under the load, for the curvatures where the wheel touches first.
double WheelRail::first_sink(double touch) {
  const double little = 1e-6 * radius_;
  const WheelMotion motion = motion_at(touch + little);
  search_->find(motion.pose, found_, merge_rule(in_), motion.along);
  if (found_.empty()) return little;
  const OverlapPatch& patch = *std::max_element(found_.begin(), found_.end(),
                                                [](const auto& a, const auto& b) { return depth_of(a) < depth_of(b); });
  const double half = 0.5 * (patch.high - patch.low), a = 0.5 * patch.curvature.along;
  if (slot_.empty()) add_slot();
  const double modulus = slot_.front()->contact.modulus(), tilt = std::cos(patch.angle);
  return hertz_by_load({a, patch.overlap / (half * half), 0}, modulus, in_.load / tilt).approach / tilt;
}

// Takes secants of the force's power 2/3: it grows as the sink to the power 3/2, whatever the patches are.
Status WheelRail::meet_force() {
  const WheelMotion above = motion_at(in_.position.z);
  const double touch = in_.position.z + search_->first_touch(above.pose, above.along);
  if (!std::isfinite(touch))
    fail(Status::err_load, "no height of the wheelset brings the wheel on the rail (y is %g): it has derailed",
         side_ * in_.position.y);
  if (in_.load == 0) {
    solve_at(touch);
    return Status::no_contact;
  }
  constexpr int most = 60;
  constexpr double tolerance = 1e-6, jump = 1e-3, jump_within = 1e-5;
  const double deepest = nonsense * radius_;
  double low = 0, high = INFINITY, force_low = 0, force_high = 0, before = 0, force_before = 0;
  double sink = std::min(sink_ > 0 ? sink_ : first_sink(touch), deepest);
  Status status = Status::ok;
  for (int i = 0; i < most; ++i) {
    status = solve_at(touch + sink);
    if (status == Status::cancelled) return status;
    const double force = vertical_force();
    if (std::abs(force - in_.load) <= tolerance * in_.load) {
      sink_ = sink;
      return status;
    }
    (force < in_.load ? low : high) = sink;
    (force < in_.load ? force_low : force_high) = force;
    // Where no height between two that are so near has the force, it jumps.
    if (high - low <= 1e-3 * tolerance * low) break;
    if (high - low <= jump_within * low && force_high - force_low > jump * in_.load) break;
    if (low == deepest)
      fail(Status::err_load,
           "no height of the wheelset carries the vertical force %g: sunk by a tenth of its radius, the wheel carries "
           "%g; check force, profiles and units",
           in_.load, force);
    const auto root = [](double f) { return f > 0 ? std::cbrt(f * f) : 0.0; };
    const double rise = (root(force) - root(force_before)) / (sink - before);
    double next = rise > 0 ? sink + (root(in_.load) - root(force)) / rise : 2 * sink;
    if (!(next > low && next < high)) next = std::isfinite(high) ? 0.5 * (low + high) : 2 * sink;
    next = std::min(next, deepest);
    before = sink;
    force_before = force;
    sink = next;
  }
  sink_ = 0;
  return Status::not_converged;
}

void WheelRail::seek_strips() {
  for (const auto& slot : slot_) slot->unfit = false;
  hasty_ = false;
}

Status WheelRail::find_height() {
  return has_sections() ? find_height_of_sections() : find_height_of_half_spaces();
}

Status WheelRail::find_height_of_half_spaces() {
  on_lattices_ = false;
  Status status = Status::ok;
  // All starts are tried once on the way to a height, and again there.
  for (int pass = 0; pass == 0 || (pass == 1 && hasty_ && is_answer(status)); ++pass) {
    seek_strips();
    status = in_.by_force ? meet_force() : solve_at(in_.position.z);
  }
  // Forces may jump where strips begin to fit a patch, and no height have the one that is wanted.
  if (in_.by_force && status == Status::not_converged && in_.step == StepKind::steady) {
    on_lattices_ = true;
    status = meet_force();
  }
  return status;
}

Status WheelRail::solve() {
  forget_cancel();
  prepare();
  for (const auto& slot : slot_) slot->contact.forget_cancel();
  begin_step();
  solved_.reset();
  derived_ = false;
  const Inputs given = in_;
  Status status = Status::ok;
  try {
    status = find_deflection();
  } catch (...) {
    in_ = given;
    throw;
  }
  for (const Slot* slot : active_)
    if (slot->contact.held() && slot->contact.show() == Status::cancelled) status = Status::cancelled;
  if (status == Status::not_converged && in_.by_force)
    context_->caveat(status, "the vertical force is %.10g for %.10g; no height tried brought it nearer",
                     vertical_force(), in_.load);
  solved_ = Solved{in_.position,
                   in_.velocity,
                   in_.deviation,
                   in_.rate,
                   in_.bend,
                   in_.bend_rate,
                   in_.by_force,
                   in_.by_pull,
                   in_.stiffness,
                   {in_.deviation.y - given.deviation.y, in_.deviation.z - given.deviation.z},
                   z_,
                   status};
  in_.velocity = given.velocity;
  in_.deviation = given.deviation;
  end_step(status);
  tell(status);
  return status;
}

// Notes what a caller should know of a solve that is not plain success.
void WheelRail::tell(Status status) const {
  if (status == Status::ok) return;
  double deepest = 0;
  for (const OverlapPatch& patch : found_) deepest = std::max(deepest, patch.overlap);
  if (status == Status::derailed)
    context_->caveat(status, "the wheel is beside its rail (y is %g): it has derailed", side_ * in_.position.y);
  if (status == Status::too_deep && deepest > too_deep * radius_)
    context_->caveat(
        status,
        "wheel and rail overlap by %g, more than a thousandth of the wheel's radius (%g): check %s and all "
        "units",
        deepest, radius_, in_.by_force ? "the vertical force" : "z");
  for (const Slot* slot : active_) {
    const PatchContact& patch = slot->contact;
    if (patch.status() != status || patch.whole()) continue;
    if (const Line deep = describe_pressure(patch.max_pressure(), patch.modulus()); *deep.text)
      context_->caveat(status, "%s", deep.c_str());
    else
      patch.contact()->solver->tell(status);
  }
  for (std::size_t i = 0; i < active_.size(); ++i)
    if (const OverlapPatch& patch = active_[i]->contact.overlap(); patch.cut && status == Status::rim_contact)
      context_->caveat(Status::rim_contact,
                       "patch %d (counting from 0), at y = %g of the wheel, ends where a profile does",
                       static_cast<int>(i), patch.wheel_y);
}

void WheelRail::reset() {
  // All slots go, because which contact serves a patch depends on those that are there.
  for (auto& slot : slot_) spare_.push_back(std::move(slot));
  slot_.clear();
  active_.clear();
  sink_ = 0;
  solved_.reset();
  past_.reset();
  can_repeat_ = false;
}

void WheelRail::require_solved() const {
  if (!solved_) fail(Status::err_state, "there is no solution yet: call rollcon_wheelrail_solve first");
}

std::int64_t WheelRail::patches() const {
  require_solved();
  return static_cast<std::int64_t>(active_.size());
}

const WheelRail::Slot& WheelRail::active(std::int64_t i) const {
  require_solved();
  const auto n = static_cast<std::int64_t>(active_.size());
  if (i < 0 || i >= n)
    fail(Status::err_argument, "patch is %lld; allowed: 0 to %lld", static_cast<long long>(i),
         static_cast<long long>(n - 1));
  return *active_[static_cast<std::size_t>(i)];
}

std::shared_ptr<Contact> WheelRail::contact(std::int64_t i) const {
  return active(i).contact.contact();
}

}  // namespace rollcon
