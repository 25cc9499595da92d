// Solves, lists of load cases, and what happens inside callbacks.

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
  require(FUZZ_CALL(w, rollcon_event_get_int, event, key, integer.data()) == ROLLCON_OK ||
              integer.untouched(),
          "a failed call wrote into its output");
  require(FUZZ_CALL(w, rollcon_event_get_real, event, key, real.data()) == ROLLCON_OK ||
              real.untouched(),
          "a failed call wrote into its output");
  const std::span<const Call> kinds[] = {context_calls(), body_calls(), contact_calls(),
                                         solve_calls(), result_calls()};
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
  FUZZ_CALL(w, rollcon_contact_set_progress, w.contact(), w.in.one_in(4) ? nullptr : on_progress,
            &w);
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
  const std::int32_t m = w.in.one_in(20) ? w.in.integer32() : w.in.below(4);
  const auto width = static_cast<std::size_t>(m < 0 || m > 5 ? 0 : m);
  std::vector<std::int32_t> parameter(width);
  for (std::size_t j = 0; j < width; ++j)
    parameter[j] =
        w.in.one_in(12) ? w.in.integer32() : static_cast<std::int32_t>(j) + 1 + w.in.below(2);
  const std::vector<double> values = w.in.reals(cases * width);
  static const char* const lists[] = {nullptr, "", "iterations", " nodes_contact  max_pressure ",
                                      "friction_power nonsense"};
  const char* names = lists[w.in.below(5)];
  const std::size_t wanted = names == lists[2]   ? 1
                             : names == lists[3] ? 2
                             : names == lists[4] ? 2
                                                 : 0;
  std::int64_t nodes = 0;
  rollcon_contact_get_size(c, &nodes, nullptr);
  const std::int64_t capacity = nodes + w.in.below(4) - 1, room = capacity > 0 ? capacity : 0;
  const auto count = static_cast<std::int64_t>(cases);
  Output<std::int32_t> status(count);
  Output<double> force(3 * count), moment(3 * count), approach(count), creep(3 * count),
      derivatives(10 * count * static_cast<std::int64_t>(width)),
      statistics(count * static_cast<std::int64_t>(wanted)), tractions(3 * room * count);
  // Of a list that is longer than memory there is nothing to read or to write.
  const int asked = absurd ? 0 : w.in.byte();
  const auto if_asked = [&](int bit, Output<double>& out) {
    return asked & bit ? out.data() : nullptr;
  };
  const std::int32_t sum =
      FUZZ_CALL(w, rollcon_contact_solve_many, c, absurd && n > 0 ? 0 : m, parameter.data(), n,
                absurd ? nullptr : values.data(), absurd ? nullptr : names, capacity,
                asked & 1 ? status.data() : nullptr, if_asked(2, force), if_asked(4, moment),
                if_asked(8, approach), if_asked(16, creep), if_asked(32, derivatives),
                statistics.data(), if_asked(64, tractions));
  if (sum < 0) {
    require(status.untouched() && force.untouched() && moment.untouched() && approach.untouched() &&
                creep.untouched() && derivatives.untouched() && statistics.untouched() &&
                tractions.untouched(),
            "a failed call wrote into its output");
    return;
  }
  if ((asked & 3) != 3) return;
  for (std::size_t i = 0; i < cases; ++i) {
    const double* f = &force.values()[3 * i];
    const bool finite = all_finite({f[0], f[1], f[2]});
    require(finite == (status.values()[i] >= 0 && status.values()[i] != ROLLCON_CANCELLED),
            "a case of status " + std::to_string(status.values()[i]) +
                (finite ? " has a result" : " has a result that is not finite"));
  }
}

}  // namespace

std::span<const Call> solve_calls() {
  static const Call calls[] = {solve,        solve,  solve, solve_many,
                               set_progress, cancel, reset, old_event};
  return calls;
}

}  // namespace fuzz
