#include "linalg/sparse_order.hpp"

#include <algorithm>
#include <numeric>

#include "support/index.hpp"

namespace rollcon {

bool is_permutation(std::span<const std::int64_t> order) {
  std::vector<bool> found(order.size(), false);
  for (const std::int64_t i : order) {
    if (i < 0 || at(i) >= order.size() || found[at(i)]) return false;
    found[at(i)] = true;
  }
  return true;
}

SparseOrder order_unknowns(const SparseMatrix& matrix, std::span<const std::int64_t> condensed) {
  const SparseGroups groups = group_unknowns(matrix, condensed);
  GraphOrder order = dissect(groups);
  move_condensed_last(groups, order.group);
  postorder_interior(groups, order.group);
  SparseOrder out;
  out.unknown.reserve(at(matrix.columns));
  for (const std::int64_t g : order.group)
    for (std::int64_t k = groups.member_start[at(g)]; k < groups.member_start[at(g + 1)]; ++k)
      out.unknown.push_back(groups.member[at(k)]);
  out.peak_bytes = order.peak_bytes +
                   sizeof(std::int64_t) * (2 * groups.start.size() + groups.neighbour.size() + 2 * at(matrix.columns));
  return out;
}

SparseMatrix permuted(const SparseMatrix& matrix, std::span<const std::int64_t> unknown) {
  std::vector<std::int64_t> place(unknown.size());
  for (std::size_t k = 0; k < unknown.size(); ++k) place[at(unknown[k])] = static_cast<std::int64_t>(k);
  SparseMatrix out;
  out.columns = matrix.columns;
  out.start.assign(at(matrix.columns + 1), 0);
  for (std::int64_t j = 0; j < matrix.columns; ++j)
    for (std::int64_t k = matrix.start[at(j)]; k < matrix.start[at(j + 1)]; ++k)
      ++out.start[at(std::min(place[at(j)], place[at(matrix.row[at(k)])]) + 1)];
  std::partial_sum(out.start.begin(), out.start.end(), out.start.begin());
  out.row.resize(matrix.row.size());
  out.value.resize(matrix.row.size());
  std::vector<std::int64_t> next(out.start.begin(), out.start.end() - 1);
  for (std::int64_t j = 0; j < matrix.columns; ++j) {
    for (std::int64_t k = matrix.start[at(j)]; k < matrix.start[at(j + 1)]; ++k) {
      const std::int64_t a = place[at(j)], b = place[at(matrix.row[at(k)])];
      const std::size_t to = at(next[at(std::min(a, b))]++);
      out.row[to] = std::max(a, b);
      out.value[to] = matrix.value[at(k)];
    }
  }
  return out;
}

}  // namespace rollcon
