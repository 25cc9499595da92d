#pragma once
/// Maps handles of the C API to objects. The value of a handle is a number - kind (3 bits), generation (12 bits), slot
/// (16 bits) - that is looked up here and never dereferenced, so that released, garbage and wrong-kind handles are told
/// from live ones.

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "bodies/body.hpp"
#include "contact/contact.hpp"
#include "rollcon_layers.h"
#include "support/context.hpp"
#include "tables/force_table.hpp"
#include "wheelrail/wheel_rail.hpp"

namespace rollcon::capi {

enum class Kind : std::uint32_t { context = 1, body = 2, contact = 3, wheelrail = 4, table = 5 };

/// What a handle stands for. Each call holds a reference, so a release in another thread is harmless.
struct Object {
  std::shared_ptr<Context> context;  ///< the object itself, or where it reports its failures
  std::shared_ptr<Body> body;        ///< the body, if the kind is body
  std::shared_ptr<Contact> contact;  ///< the contact, if the kind is contact
  std::unique_ptr<WheelRail> wheelrail;
  std::shared_ptr<ForceTable> table;
  /// Set while a call may change the object or needs it unchanged; a wheel on its rail and its contacts have one flag
  /// together.
  std::shared_ptr<std::atomic<bool>> busy = std::make_shared<std::atomic<bool>>(false);
  std::vector<std::shared_ptr<Object>> patches;  ///< objects of the contacts asked for, if the kind is wheelrail
  bool read_only = false;                        ///< true for a contact whose scene belongs to a wheel on its rail
  rollcon_progress_fn progress = nullptr;
  void* progress_user = nullptr;
};

class HandleTable {
 public:
  /// Inserts the object with one reference. Throws Error(err_memory) when all slots are taken.
  const void* insert(Kind kind, std::shared_ptr<Object> object);
  /// Returns null if the handle is not a live one of this kind.
  std::shared_ptr<Object> find(Kind kind, const void* handle) const noexcept;
  /// Returns the object of a live handle of any kind, else null.
  std::shared_ptr<Object> find(const void* handle) const noexcept;
  /// Adds a reference; returns false if the handle is not a live one of this kind.
  bool retain(Kind kind, const void* handle) noexcept;
  /// Drops a reference. Takes the object out with its last one and returns it for the caller to destroy; else null.
  std::shared_ptr<Object> release(Kind kind, const void* handle) noexcept;
  /// Returns 0 if the handle is not alive.
  std::int32_t id_of(const void* handle) const noexcept;

  static const void* from_id(std::int32_t id) noexcept;

 private:
  struct Slot {
    std::shared_ptr<Object> object;
    std::int64_t references = 0;
    std::uint32_t generation = 1;
    Kind kind = Kind::context;
    std::int32_t next_free = -1;
  };
  static constexpr std::uint32_t slot_bits = 16, generation_bits = 12, kind_bits = 3;
  static constexpr std::size_t max_slots = std::size_t{1} << slot_bits;
  static constexpr std::uint32_t last_generation = (1U << generation_bits) - 1;

  const Slot* live(const void* handle) const noexcept;
  const Slot* live(Kind kind, const void* handle) const noexcept;
  Slot* live(Kind kind, const void* handle) noexcept;

  mutable std::mutex mutex_;
  std::vector<Slot> slot_;
  /// Free slots are linked first in, first out, so that a number comes back as late as possible.
  std::int32_t first_free_ = -1, last_free_ = -1;
};

/// The process has one table. It is never destroyed, because hosts may release handles while they exit.
HandleTable& handles();

}  // namespace rollcon::capi
