// Calls solves, lists of load cases, and what happens inside callbacks.

#include "calls.hpp"
#include "scenes.hpp"

namespace fuzz {
namespace {

/// Does something to the library now and then, and cancels some solves.
std::int32_t ROLLCON_CALL on_progress(const rollcon_event* event, void* user) {
  World& w = *static_cast<World*>(user);
  w.event = event;
  const int how = w.in.byte();
  if (how < 180 || w.depth > 2) return 0;
  if (how < 200) return 1;
  ++w.depth;
  Output<std::int64_t> integer(1);
  Output<double> real(1);
  static constexpr std::int32_t keys[] = {1, 2, 101, 102};
  const std::int32_t key = w.in.one_in(4) ? w.in.integer32() : keys[w.in.below(4)];
  require(FUZZ_CALL(w, rollcon_event_get_int, event, key, integer.data()) == ROLLCON_OK || integer.untouched(),
          "a failed call wrote into its output");
  require(FUZZ_CALL(w, rollcon_event_get_real, event, key, real.data()) == ROLLCON_OK || real.untouched(),
          "a failed call wrote into its output");
  const std::span<const Call> kinds[] = {context_calls(), body_calls(), contact_calls(), solve_calls(), result_calls()};
  const std::span<const Call> calls = kinds[how % 5];
  calls[static_cast<std::size_t>(w.in.byte()) % calls.size()](w);
  --w.depth;
  return 0;
}

void solve(World& w) {
  rollcon_contact* c = w.contact();
  if (w.solves_left-- > 0) solve_and_check(w, c);
}

void set_progress(World& w) {
  FUZZ_CALL(w, rollcon_contact_set_progress, w.contact(), w.in.one_in(4) ? nullptr : on_progress, &w);
}

void cancel(World& w) {
  FUZZ_CALL(w, rollcon_contact_request_cancel, w.contact());
}

void reset(World& w) {
  FUZZ_CALL(w, rollcon_contact_reset, w.contact());
}

void old_event(World& w) {
  double value = 0;
  if (w.depth == 0 && w.event)
    require(rollcon_event_get_real(w.event, ROLLCON_EVENT_SECONDS, &value) == ROLLCON_ERR_HANDLE,
            "an event outlives its callback");
}

void solve_many(World& w) {
  rollcon_contact* c = w.contact();
  if (w.solves_left-- <= 0) return;
  std::int64_t n = w.in.one_in(12) ? w.in.integer() : w.in.below(5);
  const bool absurd = n < 0 || n > 8;
  // Lists for which a large machine might have room would only take long.
  if (n > 8) n = (n | std::int64_t{1} << 62U) >> (w.in.one_in(2) ? 0 : 23);
  const auto cases = static_cast<std::size_t>(absurd ? 0 : n);
  static constexpr const char* known[] = {"longitudinal", "lateral", "normal", "spin", "friction", "nonsense"};
  std::string parameters;
  const int first = w.in.below(6), width = w.in.below(4);
  for (int j = 0; j < width; ++j) parameters += std::string(" ") + known[(first + (w.in.one_in(12) ? 0 : j)) % 6];
  const std::vector<double> values = w.in.reals(cases * static_cast<std::size_t>(width));
  static constexpr const char* lists[] = {"", "force", " force  moment max_pressure ",
                                          "force tractions derivatives approach creep", "force iterations nonsense"};
  const int list = w.in.below(5);
  std::int64_t nodes = 0;
  rollcon_contact_get_size(c, &nodes, nullptr);
  const std::int64_t widths[] = {0, 3, 7, 3 + 3 * nodes + 10 * width + 4, 5};
  std::int64_t capacity = widths[list] + w.in.below(4) - 1, told = 0;
  if (w.in.one_in(12)) capacity = w.in.integer();
  const auto count = static_cast<std::int64_t>(cases);
  const bool asks = capacity == 0 && list > 0;
  const std::int64_t room = capacity > 0 && capacity < 100000 ? capacity : 0;
  Output<std::int32_t> status(count);
  Output<double> result(room * count);
  // A list that is longer than memory has nothing to read or to write.
  const bool some = !absurd && room == capacity;
  const std::int32_t sum =
      FUZZ_CALL(w, rollcon_contact_solve_many, c, absurd && n > 0 ? nullptr : parameters.c_str(), n,
                absurd ? nullptr : values.data(), some || asks ? lists[list] : "", some || asks ? capacity : 0,
                some ? result.data() : nullptr, &told, absurd ? nullptr : status.data());
  if (sum < 0 || asks) {
    require(status.untouched() && result.untouched(), "a failed call wrote into its output");
    return;
  }
  if (absurd || !some || list == 0) return;
  require(told == widths[list], "numbers per case");
  for (std::size_t i = 0; i < cases; ++i) {
    const double* f = &result.values()[static_cast<std::size_t>(room) * i];
    const bool finite = all_finite({f[0], f[1], f[2]});
    require(finite == (status.values()[i] >= 0 && status.values()[i] != ROLLCON_CANCELLED),
            "a case of status " + std::to_string(status.values()[i]) +
                (finite ? " has a result" : " has a result that is not finite"));
  }
}

}  // namespace

std::span<const Call> solve_calls() {
  static const Call calls[] = {solve, solve, solve, solve_many, set_progress, cancel, reset, old_event};
  return calls;
}

}  // namespace fuzz
