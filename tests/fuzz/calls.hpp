#pragma once
/// Makes one call each, with arguments taken from the input.

#include <span>

#include "world.hpp"

namespace fuzz {

using Call = void (*)(World&);

std::span<const Call> context_calls();
std::span<const Call> body_calls();
std::span<const Call> contact_calls();
std::span<const Call> solve_calls();
std::span<const Call> result_calls();
std::span<const Call> wheelrail_calls();

/// Returns a count that the caller's array has, at most `most`, or a negative one.
std::int64_t array_size(Input& in, std::int64_t most = 24);
/// Returns the entries of an array, or seldom NULL.
template <class T>
const T* maybe_null(Input& in, const std::vector<T>& values) {
  return in.one_in(40) ? nullptr : values.data();
}
/// Returns ids, mostly of the nodes there are.
std::vector<std::int32_t> ids(Input& in, std::int64_t count, std::int64_t nodes);
/// Returns an element type, one that there is or any number.
std::int32_t element_type(Input& in);

/// Asks a function that fills capacity entries, or fewer, and tells the need, with any capacity; what it does not write
/// stays unchanged.
template <class T, class F>
void ask(World& world, std::int64_t need, F&& call) {
  const std::int64_t odd[] = {need, need + 3, need - 1, 0, 1, -1, INT64_MIN};
  const std::int64_t capacity = odd[world.in.below(7)];
  Output<T> out(capacity > 0 ? capacity : 0);
  std::int64_t told = -7;
  const std::int32_t status = call(capacity, out.data(), &told);
  require(status == ROLLCON_OK || out.untouched(), "a failed call wrote into its output");
  if (status == ROLLCON_OK && told >= 0 && told <= capacity)
    require(out.untouched(static_cast<std::size_t>(told)), "a call wrote beyond what it told");
  require(status != ROLLCON_OK || capacity == 0 || told <= capacity,
          "a call told that it needed more than it was given");
}

}  // namespace fuzz
