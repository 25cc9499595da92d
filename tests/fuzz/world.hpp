#pragma once
/// Holds the handles of one input, alive and dead, and the number of references it owns.

#include <rollcon_layers.h>

#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "contract.hpp"
#include "input.hpp"

namespace fuzz {

template <class Handle>
struct Owned {
  Handle* handle;
  rollcon_context* context;  ///< context that the object was made from
  int references;
};

class World {
 public:
  explicit World(Input& input);
  /// Releases all; nothing may be alive then.
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  Input& in;
  std::vector<Owned<rollcon_context>> contexts;
  std::vector<Owned<rollcon_body>> bodies;
  std::vector<Owned<rollcon_contact>> contacts;
  std::vector<Owned<rollcon_wheelrail>> wheelrails;
  int solves_left = 5, prepares_left = 5, files_left = 2, depth = 0;

  /// Returns mostly a handle that was made, alive or not; else NULL, one of another kind, or garbage.
  rollcon_context* context();
  rollcon_body* body();
  rollcon_contact* contact();
  rollcon_wheelrail* wheelrail();
  const rollcon_event* event = nullptr;  ///< event of the last callback, perhaps over

  /// Adds new handles, to be released by the destructor.
  rollcon_context* add(rollcon_context* made);
  rollcon_body* add(rollcon_body* made, rollcon_context* of);
  rollcon_contact* add(rollcon_contact* made, rollcon_context* of);
  rollcon_wheelrail* add(rollcon_wheelrail* made, rollcon_context* of);

  /// Returns the context in which failures of calls on the handle leave their text; null if nowhere.
  const rollcon_context* context_of(const void* handle) const;
  /// Returns a name of a file in the folder of this process, or one that cannot be.
  std::string path();
};

/// Returns a folder of this process, removed at its end.
const std::string& own_folder();

template <class Function, class... Arguments>
std::int32_t call(World& world, const char* name, Function* function, const std::tuple<Arguments...>& arguments) {
  const std::int32_t status = std::apply(function, arguments);
  // The context is asked afterwards, because a callback may have released both.
  if constexpr (std::is_pointer_v<std::tuple_element_t<0, std::tuple<Arguments...>>>)
    return checked(name, world.context_of(std::get<0>(arguments)), status);
  else
    return checked(name, nullptr, status);
}

/// Calls the function and checks what holds for every call. Braces make every compiler take the
/// arguments from the input in their order.
#define FUZZ_CALL(world, function, ...) ::fuzz::call(world, #function, function, std::tuple{__VA_ARGS__})

}  // namespace fuzz
