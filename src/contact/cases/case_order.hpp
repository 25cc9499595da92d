#pragma once
/// Finds in which order a list of load cases is solved, and where each chain of warm starts begins.

#include <cstdint>
#include <span>
#include <vector>

namespace rollcon {

/// Orders by the values alone: not by the order in which cases are listed, nor by any number of threads.
struct CaseOrder {
  std::vector<std::int64_t> solved;       ///< one case of each set of equal ones, in solving order
  std::vector<std::int64_t> solved_as;    ///< case that is solved for each case
  std::vector<std::int64_t> chain_begin;  ///< into `solved`; one more than there are chains

  std::int64_t chains() const { return static_cast<std::int64_t>(chain_begin.size()) - 1; }
};

/// Orders cases by values that come row by row, `columns` to a case; columns at the front of `priority` change least
/// often. Neighbours are near each other: tables are walked to and fro, scattered cases in strips.
CaseOrder order_cases(std::int64_t cases, std::int64_t columns, const double* value,
                      std::span<const std::int64_t> priority);

}  // namespace rollcon
