/// Implements the calls that list options and statistics.

#include "contact/scene/options.hpp"

#include <algorithm>
#include <string>

#include "bodies/body_options.hpp"
#include "bodies/body_results.hpp"
#include "capi/guard.hpp"
#include "capi/results.hpp"
#include "contact/statistics.hpp"

using namespace rollcon;
using namespace rollcon::capi;

namespace {

std::span<const Setting> options_of(int32_t kind) {
  switch (kind) {
    case ROLLCON_OF_BODY:
      return body_option_table().settings();
    case ROLLCON_OF_CONTACT:
      return option_table();
    case ROLLCON_OF_PROCEDURE:
      return procedure_table();
    case ROLLCON_OF_WHEELRAIL:
      return wheel_option_table().settings();
    default:
      return {};
  }
}

const StatisticInfo* statistic_of(int32_t kind, int32_t i) {
  switch (kind) {
    case ROLLCON_OF_BODY:
      return body_statistic_info(i);
    case ROLLCON_OF_CONTACT:
      return statistic_info(statistics(), i);
    case ROLLCON_OF_WHEELRAIL:
      return WheelRail::stat_info(i);
    case ROLLCON_OF_PATCH:
      return WheelRail::patch_stat_info(i);
    default:
      return nullptr;
  }
}

void require_row(int32_t kind, int32_t i, int32_t count, const char* what) {
  if (kind < ROLLCON_OF_BODY || kind > ROLLCON_OF_PROCEDURE)
    fail(Status::err_argument, "kind is %d; allowed: 2 (body), 3 (contact), 4 (wheelrail), 6 (patch), 7 (procedure)",
         kind);
  if (count == 0) fail(Status::err_argument, "kind is %d, of which there are no %s", kind, what);
  if (i < 0 || i >= count) fail(Status::err_argument, "i is %d; allowed: 0 to %d", i, count - 1);
}

/// Copies a name and its meaning, either of which may be unwanted, to places of one capacity.
void copy_texts(std::string_view name, std::string_view doc, int64_t capacity, char* to_name, char* to_doc,
                int64_t* needed) {
  if (capacity == 0 && !needed) return;  // the numbers alone are wanted
  const bool all = !to_name && !to_doc;
  const std::size_t longest = std::max(to_name || all ? name.size() : 0, to_doc || all ? doc.size() : 0);
  const void* to = to_name ? to_name : to_doc;
  if (!wants_copy(static_cast<int64_t>(longest) + 1, capacity, to, "name and doc", needed, "bytes")) return;
  if (to_name) copy_text(name, capacity, to_name, nullptr);
  if (to_doc) copy_text(doc, capacity, to_doc, nullptr);
}

}  // namespace

int32_t rollcon_option_count(int32_t kind) {
  return static_cast<int32_t>(options_of(kind).size());
}

rollcon_status rollcon_option_info(int32_t kind, int32_t i, int64_t capacity, char* name, char* doc, int64_t* needed,
                                   int32_t* type, double* low, double* high, double* standard) {
  return guarded(__func__, nullptr, [&] {
    require_row(kind, i, rollcon_option_count(kind), "options");
    const Setting& row = options_of(kind)[static_cast<std::size_t>(i)];
    std::string meaning = row.doc;
    if (row.choices) meaning += " Values: " + std::string(row.choices) + "; the first is the standard.";
    copy_texts(row.name, meaning, capacity, name, doc, needed);
    if (type) *type = static_cast<int32_t>(row.type);
    if (low) *low = row.low;
    if (high) *high = row.high;
    if (standard) *standard = row.standard;
  });
}

int32_t rollcon_stat_count(int32_t kind) {
  int32_t count = 0;
  while (statistic_of(kind, count)) ++count;
  return count;
}

rollcon_status rollcon_stat_info(int32_t kind, int32_t i, int64_t capacity, char* name, char* doc, int64_t* needed,
                                 int32_t* inside) {
  return guarded(__func__, nullptr, [&] {
    require_row(kind, i, rollcon_stat_count(kind), "statistics");
    const StatisticInfo& row = *statistic_of(kind, i);
    copy_texts(row.name, row.doc, capacity, name, doc, needed);
    if (inside) *inside = row.inside;
  });
}
