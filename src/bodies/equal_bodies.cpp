#include "bodies/equal_bodies.hpp"

#include <algorithm>
#include <utility>

namespace rollcon {

std::shared_ptr<EqualBodies::Slot> EqualBodies::slot_of(const ContentDigest& digest, Slots& slots) {
  const std::lock_guard lock(mutex_);
  if (slots.size() >= clean_at_) {
    // Slots that threads hold are in use: their models may not be there yet.
    std::erase_if(slots,
                  [](const auto& entry) { return entry.second.use_count() == 1 && entry.second->model.expired(); });
    clean_at_ = std::max(clean_at_, 2 * slots.size());
  }
  std::shared_ptr<Slot>& slot = slots[digest];
  if (!slot) slot = std::make_shared<Slot>();
  return slot;
}

std::shared_ptr<BodyModel> EqualBodies::share(std::shared_ptr<BodyModel> model,
                                              const std::function<void(BodyModel&)>& make,
                                              const std::function<bool(const BodyModel&)>& serves) {
  const std::shared_ptr<Slot> slot = slot_of(digest_of(*model), slot_);
  const std::lock_guard lock(slot->turn);
  if (auto known = slot->model.lock(); known && serves(*known)) return known;
  make(*model);
  slot->model = model;
  return model;
}

void EqualBodies::share_equations(const std::shared_ptr<BodyModel>& model,
                                  const std::function<void(BodyModel&, std::shared_ptr<BodyModel>)>& make) {
  const std::shared_ptr<Slot> slot = slot_of(digest_without_loads(*model), equations_);
  const std::lock_guard lock(slot->turn);
  auto known = slot->model.lock();
  make(*model, known);
  if (!known) slot->model = model;
}

}  // namespace rollcon
