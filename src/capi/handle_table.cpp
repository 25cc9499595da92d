#include "capi/handle_table.hpp"

#include <utility>

namespace rollcon::capi {

const void* HandleTable::from_id(std::int32_t id) noexcept {
  return reinterpret_cast<const void*>(static_cast<std::uintptr_t>(static_cast<std::uint32_t>(id)));
}

const HandleTable::Slot* HandleTable::live(const void* handle) const noexcept {
  const auto value = reinterpret_cast<std::uintptr_t>(handle);
  if (value >> (slot_bits + generation_bits + kind_bits) != 0) return nullptr;
  const std::size_t index = value & (max_slots - 1);
  const std::uint32_t generation = (value >> slot_bits) & last_generation;
  const auto kind = static_cast<Kind>(value >> (slot_bits + generation_bits));
  if (index >= slot_.size()) return nullptr;
  const Slot& slot = slot_[index];
  return slot.object && slot.generation == generation && slot.kind == kind ? &slot : nullptr;
}

const HandleTable::Slot* HandleTable::live(Kind kind, const void* handle) const noexcept {
  const Slot* slot = live(handle);
  return slot && slot->kind == kind ? slot : nullptr;
}

HandleTable::Slot* HandleTable::live(Kind kind, const void* handle) noexcept {
  return const_cast<Slot*>(std::as_const(*this).live(kind, handle));
}

const void* HandleTable::insert(Kind kind, std::shared_ptr<Object> object) {
  const std::lock_guard lock(mutex_);
  std::size_t index = slot_.size();
  if (first_free_ >= 0) {
    index = static_cast<std::size_t>(first_free_);
    first_free_ = slot_[index].next_free;
    if (first_free_ < 0) last_free_ = -1;
  } else if (index < max_slots) {
    slot_.emplace_back();
  } else {
    fail(Status::err_memory, "no handle left: %zu objects are alive or were too many", max_slots);
  }
  Slot& slot = slot_[index];
  slot.object = std::move(object);
  slot.references = 1;
  slot.kind = kind;
  const std::uint32_t id = static_cast<std::uint32_t>(kind) << (slot_bits + generation_bits) |
                           slot.generation << slot_bits | static_cast<std::uint32_t>(index);
  return from_id(static_cast<std::int32_t>(id));
}

std::shared_ptr<Object> HandleTable::find(Kind kind, const void* handle) const noexcept {
  const std::lock_guard lock(mutex_);
  const Slot* slot = live(kind, handle);
  return slot ? slot->object : nullptr;
}

std::shared_ptr<Object> HandleTable::find(const void* handle) const noexcept {
  const std::lock_guard lock(mutex_);
  const Slot* slot = live(handle);
  return slot ? slot->object : nullptr;
}

bool HandleTable::retain(Kind kind, const void* handle) noexcept {
  const std::lock_guard lock(mutex_);
  Slot* slot = live(kind, handle);
  if (slot) ++slot->references;
  return slot != nullptr;
}

std::shared_ptr<Object> HandleTable::release(Kind kind, const void* handle) noexcept {
  const std::lock_guard lock(mutex_);
  Slot* slot = live(kind, handle);
  if (!slot || --slot->references > 0) return nullptr;
  // A slot whose generations are used up is never given out again.
  if (slot->generation < last_generation) {
    const auto index = static_cast<std::int32_t>(slot - slot_.data());
    ++slot->generation;
    slot->next_free = -1;
    (last_free_ >= 0 ? slot_[static_cast<std::size_t>(last_free_)].next_free : first_free_) = index;
    last_free_ = index;
  }
  return std::move(slot->object);
}

std::int32_t HandleTable::id_of(const void* handle) const noexcept {
  const std::lock_guard lock(mutex_);
  return live(handle) ? static_cast<std::int32_t>(reinterpret_cast<std::uintptr_t>(handle)) : 0;
}

HandleTable& handles() {
  static auto* const table = new HandleTable;
  return *table;
}

}  // namespace rollcon::capi
