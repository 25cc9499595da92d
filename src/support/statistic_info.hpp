#pragma once
/// Describes statistics, which are numbers about an object, by name.

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <iterator>

#include "support/input_checks.hpp"

namespace rollcon {

struct StatisticInfo {
  const char* name;
  const char* doc;
  bool inside = false;  ///< counts work inside the library: other versions may count otherwise, or not
};

/// Returns the row of a table of statistics with this name. err_argument: null; err_option: there is none.
template <class Table>
const auto& statistic_row(const Table& table, const char* name) {
  require_pointer(name, "name");
  const auto found = std::find_if(std::begin(table), std::end(table),
                                  [&](const auto& row) { return std::strcmp(row.info.name, name) == 0; });
  if (found == std::end(table))
    fail(Status::err_option, "unknown statistic '%.60s'; rollcon_stat_info lists them", name);
  return *found;
}

/// Returns what a table of statistics says of its row i; null beyond its ends.
template <class Table>
const StatisticInfo* statistic_info(const Table& table, std::int64_t i) {
  return i >= 0 && i < std::ssize(table) ? &table[static_cast<std::size_t>(i)].info : nullptr;
}

}  // namespace rollcon
