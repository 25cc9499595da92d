/// Saves, restores and copies states of a wheel on its rail.

#include <algorithm>
#include <utility>

#include "support/error.hpp"
#include "wheelrail/patch_snapshot.hpp"
#include "wheelrail/wheel_rail.hpp"

namespace rollcon {

struct WheelRail::Kept {
  bool used = false;
  std::int64_t dimensions = 0;
  Inputs in;
  struct OfSlot {
    PatchContact::Kept contact;
    double wheel_y = 0, give_way = 0;
  };
  std::vector<OfSlot> slot;  ///< entries beyond `slots` are storage
  std::size_t slots = 0;
  std::vector<std::size_t> active;
  double z = 0, sink = 0;
  std::shared_ptr<const WheelPast> past, start;
  bool can_repeat = false;
  std::int64_t solves = 0;
  std::optional<Solved> solved;
};

void WheelRail::keep(Kept& kept) const {
  kept.used = true;
  kept.dimensions = dimensions_;
  kept.in = in_;
  kept.slots = search_ ? slot_.size() : 0;
  kept.slot.resize(std::max(kept.slot.size(), kept.slots));
  for (std::size_t i = 0; i < kept.slots; ++i) {
    slot_[i]->contact.keep(kept.slot[i].contact);
    kept.slot[i].wheel_y = slot_[i]->wheel_y;
    kept.slot[i].give_way = slot_[i]->give_way;
  }
  kept.active.clear();
  if (solved_)
    for (const Slot* slot : active_) {
      const auto is = [slot](const std::unique_ptr<Slot>& other) { return other.get() == slot; };
      kept.active.push_back(static_cast<std::size_t>(std::find_if(slot_.begin(), slot_.end(), is) - slot_.begin()));
    }
  kept.z = z_;
  kept.sink = sink_;
  kept.past = past_;
  kept.start = start_;
  kept.can_repeat = can_repeat_;
  kept.solves = solves_;
  kept.solved = solved_;
}

std::shared_ptr<WheelRail::Kept> WheelRail::keep_here() const {
  auto kept = std::make_shared<Kept>();
  keep(*kept);
  return kept;
}

void WheelRail::return_to(const Kept& kept) {
  in_ = kept.in;
  solved_.reset();
  derived_ = false;
  active_.clear();
  if (kept.slots > 0) prepare_search();
  if (kept.dimensions != dimensions_) return;  // the bodies have changed: inputs are all that is left
  while (slot_.size() > kept.slots) {
    spare_.push_back(std::move(slot_.back()));
    slot_.pop_back();
  }
  while (slot_.size() < kept.slots) add_slot();
  for (std::size_t i = 0; i < kept.slots; ++i) {
    slot_[i]->contact.return_to(kept.slot[i].contact);
    slot_[i]->wheel_y = kept.slot[i].wheel_y;
    slot_[i]->give_way = kept.slot[i].give_way;
  }
  for (const std::size_t i : kept.active) active_.push_back(slot_[i].get());
  z_ = kept.z;
  sink_ = kept.sink;
  past_ = kept.past;
  start_ = kept.start;
  can_repeat_ = kept.can_repeat;
  solves_ = kept.solves;
  solved_ = kept.solved;
}

namespace {

void require_place(std::int32_t place) {
  if (place < 0 || place >= WheelRail::places)
    fail(Status::err_argument, "place is %d; allowed: 0 to %d", place, WheelRail::places - 1);
}

}  // namespace

void WheelRail::snapshot(std::int32_t place) {
  require_place(place);
  const auto k = static_cast<std::size_t>(place);
  if (kept_.size() <= k) kept_.resize(k + 1);
  if (!kept_[k]) kept_[k] = std::make_shared<Kept>();
  kept_[k]->used = false;
  keep(*kept_[k]);
}

void WheelRail::rollback(std::int32_t place) {
  require_place(place);
  const auto k = static_cast<std::size_t>(place);
  if (kept_.size() <= k || !kept_[k] || !kept_[k]->used)
    fail(Status::err_state, "nothing was saved at place %d: call rollcon_wheelrail_snapshot first", place);
  if (track_ && wheelset_given_) follow_bodies();
  if (kept_[k]->dimensions != dimensions_)
    fail(Status::err_state,
         "what was saved at place %d was with other dimensions of track or wheelset, or other bodies", place);
  return_to(*kept_[k]);
}

std::unique_ptr<WheelRail> WheelRail::copy(const std::shared_ptr<Context>& context) const {
  auto other = std::make_unique<WheelRail>(context ? context : context_, given_wheel_, given_rail_,
                                           static_cast<std::int32_t>(side_));
  other->track_ = track_;
  other->roller_ = roller_;
  other->rail_shape_ = rail_shape_;
  other->wheel_curve_ = wheel_curve_;
  other->wheel_varies_ = wheel_varies_;
  other->rail_varies_ = rail_varies_;
  other->back_to_back_ = back_to_back_;
  other->flange_back_ = flange_back_;
  other->nominal_radius_ = nominal_radius_;
  other->radius_ = radius_;
  other->tape_ = tape_;
  other->wheelset_given_ = wheelset_given_;
  other->dimensions_ = dimensions_;
  if (search_) {
    other->wheel_ = wheel_;
    other->rail_ = rail_;
    other->search_.emplace(*search_);
  }
  Kept kept;
  keep(kept);
  other->return_to(kept);
  return other;
}

}  // namespace rollcon
