#include "contact/convection/rows.hpp"

#include <algorithm>
#include <tuple>

namespace rollcon {

SparseRows RowBuilder::finish() {
  std::stable_sort(entry_.begin(), entry_.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.row, a.column) < std::tie(b.row, b.column);
  });
  SparseRows result;
  result.start.assign(static_cast<std::size_t>(rows_) + 1, 0);
  result.fallback.assign(static_cast<std::size_t>(rows_), 0);
  std::int32_t row = -1;
  for (const Entry& e : entry_) {
    if (e.row == row && result.column.back() == e.column) {
      result.value.back() += e.value;
      continue;
    }
    row = e.row;
    result.column.push_back(e.column);
    result.value.push_back(e.value);
    ++result.start[static_cast<std::size_t>(row) + 1];
  }
  for (std::size_t k = 1; k < result.start.size(); ++k) result.start[k] += result.start[k - 1];
  entry_.clear();
  return result;
}

}  // namespace rollcon
