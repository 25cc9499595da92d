// Calls the functions of contexts, and those without an object.

#include "calls.hpp"

namespace fuzz {

std::int64_t array_size(Input& in, std::int64_t most) {
  const std::int64_t n = in.integer();
  return n < 0 ? n : n % (most + 1);
}

std::vector<std::int32_t> ids(Input& in, std::int64_t count, std::int64_t nodes) {
  std::vector<std::int32_t> list(static_cast<std::size_t>(count > 0 ? count : 0));
  for (std::int32_t& id : list) {
    const int how = in.byte();
    id = how < 250 && nodes > 0 ? static_cast<std::int32_t>(how % nodes) : in.integer32();
  }
  return list;
}

std::int32_t element_type(Input& in) {
  static const std::int32_t types[] = {ROLLCON_TRI3,    ROLLCON_TRI6, ROLLCON_QUAD4, ROLLCON_QUAD8,
                                       ROLLCON_QUAD9,   ROLLCON_TET4, ROLLCON_TET10, ROLLCON_WEDGE6,
                                       ROLLCON_WEDGE15, ROLLCON_HEX8, ROLLCON_HEX20};
  const int how = in.below(12);
  return how < 11 ? types[how] : in.integer32();
}

namespace {

void create(World& w) {
  if (w.contexts.size() >= 3) return;
  rollcon_context* made = reinterpret_cast<rollcon_context*>(&w);
  const std::int32_t abi = w.in.one_in(8) ? w.in.integer32() : ROLLCON_ABI;
  if (FUZZ_CALL(w, rollcon_context_create, abi, w.in.one_in(8) ? nullptr : &made) == ROLLCON_OK)
    rollcon_context_set_threads(w.add(made), 1);
  else
    require(made == nullptr || made == reinterpret_cast<rollcon_context*>(&w), "a handle of nothing");
}

void retain(World& w) {
  rollcon_context* c = w.context();
  if (FUZZ_CALL(w, rollcon_context_retain, c) != ROLLCON_OK) return;
  for (auto& entry : w.contexts)
    if (entry.handle == c) ++entry.references;
}

void release(World& w) {
  rollcon_context* c = w.context();
  // Nobody could tell afterwards whether what was made from it answers with a failure that is remembered.
  for (const auto& entry : w.contexts)
    if (entry.handle == c && entry.references == 1) rollcon_context_set_latch(c, 0);
  rollcon_context_release(c);
  for (auto& entry : w.contexts)
    if (entry.handle == c && entry.references > 0) --entry.references;
}

void ROLLCON_CALL on_message(std::int32_t level, const char* message, void* user) {
  require(level >= 1 && level <= 4, "level of a message");
  require(user == own_folder().data(), "the user of a log sink");
  require(message[0] != 0, "a message without text");
}

void set_log(World& w) {
  // The solver's own lines come, too, at level 4.
  FUZZ_CALL(w, rollcon_context_set_log, w.context(), w.in.one_in(8) ? w.in.integer32() : w.in.below(5),
            w.in.one_in(8) ? nullptr : on_message, const_cast<char*>(own_folder().data()));
}

void set_threads(World& w) {
  const std::int32_t n = w.in.integer32();
  // Counts that make threads are left to the tests that are about them.
  FUZZ_CALL(w, rollcon_context_set_threads, w.context(), n >= 0 && n <= 4096 ? 1 : n);
}

void report(World& w) {
  const std::int32_t status = w.in.integer32();
  const std::string text = w.in.text(known_names());
  require(rollcon_report(w.body(), status, text.c_str()) == (status < 0 ? status : ROLLCON_ERR_ARGUMENT),
          "status of a report");
  require(std::string(rollcon_last_error()) == text.substr(0, 2047), "text of a report");
}

void latch(World& w) {
  rollcon_context* c = w.context();
  // The latch is rarely left on, because what follows would do nothing.
  FUZZ_CALL(w, rollcon_context_set_latch, c, w.in.one_in(8) ? w.in.integer32() : 1);
  FUZZ_CALL(w, rollcon_context_set_threads, c, -1);
  rollcon_context_check(c);
  if (!w.in.one_in(16)) FUZZ_CALL(w, rollcon_context_set_latch, c, 0);
}

void facts(World& w) {
  const std::int32_t n = w.in.integer32();
  const std::string text = w.in.text(known_names());
  require(rollcon_status_string(n) != nullptr, "no text for a status");
  require(rollcon_has_feature(text.c_str()) == 0, "a feature of this name");
  rollcon_has_feature(nullptr);
  require(rollcon_build_info() != nullptr && rollcon_version() > 0 && rollcon_abi() == ROLLCON_ABI,
          "facts of the library");
  const std::int32_t id = rollcon_id_of(w.body());
  require(id >= 0 && rollcon_id_of(rollcon_body_from_id(id)) == id, "number of a handle");
}

void tables(World& w) {
  const std::int32_t i = w.in.one_in(6) ? w.in.integer32() : w.in.byte() % 90;
  const std::int32_t kind = w.in.one_in(6) ? w.in.integer32() : w.in.byte() % 8;
  const bool statistic = w.in.one_in(2);
  const char* call = statistic ? "rollcon_stat_info" : "rollcon_option_info";
  Output<double> range(3);
  std::int32_t number = 0;
  const auto info = [&](std::int64_t capacity, char* name, char* doc, std::int64_t* needed) {
    return checked(call, nullptr,
                   statistic ? rollcon_stat_info(kind, i, capacity, name, doc, needed, &number)
                             : rollcon_option_info(kind, i, capacity, name, doc, needed, &number, range.data(),
                                                   range.data() + 1, range.data() + 2));
  };
  std::int64_t need = 1;
  info(0, nullptr, nullptr, &need);
  ask<char>(w, need, [&](std::int64_t capacity, char* text, std::int64_t* needed) {
    return info(capacity, nullptr, text, needed);
  });
  const std::int64_t capacity = w.in.below(40);
  Output<char> name(capacity);
  Output<double> untouched(3);
  range = untouched;
  const std::int32_t status = info(capacity, name.data(), nullptr, nullptr);
  require(status == ROLLCON_OK || (name.untouched() && range.untouched()), "a failed call wrote into its output");
}

}  // namespace

std::span<const Call> context_calls() {
  static const Call calls[] = {create, retain, release, set_log, set_threads, report, latch, facts, tables};
  return calls;
}

}  // namespace fuzz
