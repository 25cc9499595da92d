#include "linalg/skeleton.hpp"

#include <algorithm>
#include <cmath>

#include "linalg/lapack.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

constexpr std::int64_t run = 3;  ///< neighbouring rows of a sample, which often belong to one point
constexpr std::size_t first_sample = 96, check_sample = 24;

/// Returns the places of `count` rows, in runs spread over a block.
std::vector<std::int64_t> spread(std::int64_t rows, std::size_t count, double offset) {
  std::vector<std::int64_t> chosen;
  const double step = static_cast<double>(rows) / (static_cast<double>(count) / run);
  for (double from = offset * step; from < static_cast<double>(rows); from += step)
    for (std::int64_t k = 0; k < run; ++k)
      if (const std::int64_t row = static_cast<std::int64_t>(from) + k; row < rows) chosen.push_back(row);
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  return chosen;
}

template <class Index>
std::vector<std::int32_t> named(std::span<const std::int32_t> all, const std::vector<Index>& which) {
  std::vector<std::int32_t> names;
  for (const auto k : which) names.push_back(all[static_cast<std::size_t>(k)]);
  return names;
}

double norm(const std::vector<double>& v) {
  double sum = 0;
  for (const double x : v) sum += x * x;
  return std::sqrt(sum);
}

// to -= a b, with a: m x k, b: k x n.
void subtract_product(int m, int n, int k, const double* a, const double* b, double* to) {
  const double minus = -1, one = 1;
  if (m > 0 && n > 0 && k > 0) dgemm_("N", "N", &m, &n, &k, &minus, a, &m, b, &k, &one, to, &m);
}

struct Chosen {
  std::vector<int> column;      ///< columns that the others are made of
  std::vector<double> weights;  ///< column-major: column.size() x all
};

/// Factorises a sample of rows with the largest columns first, and writes the other columns by the first ones.
Chosen choose_columns(std::vector<double>& sample, int m, int n, double accuracy) {
  std::vector<int> order(at(n), 0);
  std::vector<double> tau(at(std::min(m, n))), work(1);
  int info = 0, ask = -1;
  dgeqp3_(&m, &n, sample.data(), &m, order.data(), tau.data(), work.data(), &ask, &info);
  int size = static_cast<int>(work[0]);
  work.resize(at(size));
  dgeqp3_(&m, &n, sample.data(), &m, order.data(), tau.data(), work.data(), &size, &info);
  const auto diagonal = [&](int k) { return std::abs(sample[at(k) + at(k) * at(m)]); };
  int rank = 0;
  while (rank < std::min(m, n) && diagonal(rank) > accuracy * diagonal(0)) ++rank;
  Chosen chosen;
  if (rank == std::min(m, n)) return chosen;  // the sample may have missed something
  const double one = 1;
  const int others = n - rank;
  if (rank > 0)
    dtrsm_("L", "U", "N", "N", &rank, &others, &one, sample.data(), &m, sample.data() + at(rank) * at(m), &m);
  chosen.weights.assign(at(rank) * at(n), 0.0);
  for (int j = 0; j < n; ++j) {
    double* to = chosen.weights.data() + at(order[at(j)] - 1) * at(rank);
    if (j < rank)
      to[j] = 1;
    else
      std::copy_n(sample.data() + at(j) * at(m), rank, to);
  }
  for (int k = 0; k < rank; ++k) chosen.column.push_back(order[at(k)] - 1);
  return chosen;
}

}  // namespace

void Skeleton::write(std::int64_t row, std::int64_t row_count, std::int64_t column, std::int64_t column_count,
                     double* to) const {
  if (rank == 0) {
    for (std::int64_t j = 0; j < column_count; ++j)
      std::copy_n(own.data() + at(row + (column + j) * rows), at(row_count), to + at(j * row_count));
    return;
  }
  const auto m = static_cast<int>(row_count), n = static_cast<int>(column_count), k = static_cast<int>(rank),
             stride = static_cast<int>(rows);
  const double one = 1, zero = 0;
  dgemm_("N", "N", &m, &n, &k, &one, own.data() + row, &stride, weights.data() + at(column * rank), &k, &zero, to, &m);
}

Skeleton skeleton_of(const BlockMatrix& matrix, std::span<const std::int32_t> rows,
                     std::span<const std::int32_t> columns, double accuracy, std::int64_t whole) {
  Skeleton block;
  block.rows = static_cast<std::int64_t>(rows.size());
  block.columns = static_cast<std::int64_t>(columns.size());
  const auto n = static_cast<int>(columns.size());
  for (std::size_t count = first_sample; block.rows * block.columns > whole && 3 * count < rows.size(); count *= 2) {
    const std::vector<std::int64_t> seen = spread(block.rows, count, 0.2),
                                    check = spread(block.rows, check_sample, 0.7);
    std::vector<double> sample(seen.size() * columns.size()), rest(check.size() * columns.size());
    matrix.block(named(rows, seen), columns, sample.data());
    Chosen chosen = choose_columns(sample, static_cast<int>(seen.size()), n, 0.1 * accuracy);
    if (chosen.column.empty()) continue;
    block.rank = static_cast<std::int64_t>(chosen.column.size());
    block.own.resize(at(block.rows * block.rank));
    matrix.block(rows, named(columns, chosen.column), block.own.data());
    block.weights = std::move(chosen.weights);
    matrix.block(named(rows, check), columns, rest.data());
    const double size = norm(rest);
    std::vector<double> there(check.size() * at(block.rank));
    for (std::size_t k = 0; k < there.size(); ++k)
      there[k] = block.own[at(check[k % check.size()]) + k / check.size() * at(block.rows)];
    subtract_product(static_cast<int>(check.size()), n, static_cast<int>(block.rank), there.data(),
                     block.weights.data(), rest.data());
    if (norm(rest) <= accuracy * size) return block;
  }
  block.rank = 0;
  block.weights.clear();
  block.own.resize(at(block.rows * block.columns));
  matrix.block(rows, columns, block.own.data());
  return block;
}

}  // namespace rollcon
