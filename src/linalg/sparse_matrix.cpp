#include "linalg/sparse_matrix.hpp"

#include <algorithm>
#include <numeric>

#include "support/index.hpp"

namespace rollcon {
namespace {

/// Counts, then places, the entries that each(matrix, put(row, column, value)) gives.
template <class Each>
SparseMatrix arranged(std::int64_t rows, std::int64_t columns, Each each) {
  SparseMatrix result;
  result.rows = rows;
  result.columns = columns;
  result.start.assign(at(columns) + 1, 0);
  each([&](std::int64_t, std::int64_t column, double) { ++result.start[at(column) + 1]; });
  std::partial_sum(result.start.begin(), result.start.end(), result.start.begin());
  result.row.resize(at(result.start.back()));
  result.value.resize(result.row.size());
  std::vector<std::int64_t> next(result.start.begin(), result.start.end() - 1);
  each([&](std::int64_t row, std::int64_t column, double value) {
    const std::size_t to = at(next[at(column)]++);
    result.row[to] = row;
    result.value[to] = value;
  });
  return result;
}

}  // namespace

void SparseMatrix::begin(std::int64_t row_count) {
  rows = row_count;
  columns = 0;
  start.assign(1, 0);
  row.clear();
  value.clear();
}

void SparseMatrix::end_column() {
  start.push_back(static_cast<std::int64_t>(row.size()));
  ++columns;
}

SparseMatrix transposed(const SparseMatrix& m) {
  return arranged(m.columns, m.rows, [&](auto put) {
    for (std::int64_t c = 0; c < m.columns; ++c)
      for (std::int64_t k = m.start[at(c)]; k < m.start[at(c) + 1]; ++k) put(c, m.row[at(k)], m.value[at(k)]);
  });
}

// Takes columns in turn: what column c sends to a later one precedes that one's own entries.
SparseMatrix both_triangles(const SparseMatrix& lower) {
  return arranged(lower.columns, lower.columns, [&](auto put) {
    for (std::int64_t c = 0; c < lower.columns; ++c)
      for (std::int64_t k = lower.start[at(c)]; k < lower.start[at(c) + 1]; ++k) {
        put(lower.row[at(k)], c, lower.value[at(k)]);
        if (lower.row[at(k)] != c) put(c, lower.row[at(k)], lower.value[at(k)]);
      }
  });
}

SparseBuilder::SparseBuilder(std::int64_t rows) : sum_(at(rows), 0.0), touched_(at(rows), 0) {
  result_.begin(rows);
}

void SparseBuilder::add(std::int64_t row, double value) {
  if (value == 0) return;
  if (!touched_[at(row)]) {
    touched_[at(row)] = 1;
    row_.push_back(row);
  }
  sum_[at(row)] += value;
}

void SparseBuilder::end_column() {
  std::sort(row_.begin(), row_.end());
  for (const std::int64_t r : row_) {
    result_.push(r, sum_[at(r)]);
    sum_[at(r)] = 0;
    touched_[at(r)] = 0;
  }
  row_.clear();
  result_.end_column();
}

}  // namespace rollcon
