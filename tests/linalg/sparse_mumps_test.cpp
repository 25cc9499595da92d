// Tests what MUMPS alone among the sparse factorisations does: it keeps factors on the disk.

#include <algorithm>
#include <cmath>
#include <numeric>

#include "linalg/sparse_factor.hpp"
#include "linalg/sparse_matrices.hpp"
#include "support/data_limit.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using namespace sparse;

std::vector<double> solution(const SparseMatrix& a, SparseStatistics& told) {
  const auto factor = factor_definite(a, {});
  std::vector<double> x(at(a.columns));
  for (std::size_t k = 0; k < x.size(); ++k) x[k] = std::sin(0.01 * static_cast<double>(k));
  factor->solve(x.data(), 1);
  told = factor->statistics();
  return x;
}

double apart(const std::vector<double>& a, const std::vector<double>& b) {
  double error = 0, size = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    error = std::max(error, std::abs(a[k] - b[k]));
    size = std::max(size, std::abs(b[k]));
  }
  return error / size;
}

TEST(MumpsFactor, factors_go_to_the_disk_where_memory_is_short) {
  const SparseMatrix a = springs(13, 3, 1);
  SparseStatistics in_memory, on_disk;
  const std::vector<double> exact = solution(a, in_memory);
  std::vector<double> x;
  {
    const DataLimit limit(0.8 * static_cast<double>(in_memory.peak_bytes));
    x = solution(a, on_disk);
  }
  expect_error("on the disk", apart(x, exact), 1e-13);
  EXPECT_LT(on_disk.peak_bytes, in_memory.peak_bytes);
  std::printf("bytes: in memory %zu, on the disk %zu\n", in_memory.peak_bytes, on_disk.peak_bytes);
}

TEST(MumpsFactor, takes_the_order_that_is_given_and_finds_a_better_one_than_rows) {
  const SparseMatrix a = springs(9, 3, 1);
  std::vector<std::int64_t> condensed(40), rows(at(a.columns));
  for (std::size_t k = 0; k < condensed.size(); ++k) condensed[k] = a.columns - 1 - 3 * static_cast<std::int64_t>(k);
  std::iota(rows.begin(), rows.end(), 0);
  std::stable_partition(rows.begin(), rows.end(), [&](std::int64_t u) {
    return std::find(condensed.begin(), condensed.end(), u) == condensed.end();
  });
  const auto by_rows = factor_definite(a, condensed, rows)->statistics(),
             dissected = factor_definite(a, condensed)->statistics();
  std::printf("entries of the factors: by rows %lld, dissected %lld\n", static_cast<long long>(by_rows.nonzeros),
              static_cast<long long>(dissected.nonzeros));
  EXPECT_LT(3 * dissected.nonzeros, by_rows.nonzeros);
}

}  // namespace
}  // namespace rollcon
