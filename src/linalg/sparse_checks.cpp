#include "linalg/sparse_checks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "linalg/dense.hpp"
#include "support/error.hpp"
#include "support/index.hpp"
#include "support/memory_limit.hpp"

namespace rollcon {
namespace {

constexpr char factorisation_needs[] = "the factorisation of a sparse matrix with %lld unknowns needs";
constexpr char remedy[] = "take a coarser mesh or fewer faces where contact is possible";

// Returns the largest row sum of the scaled matrix.
double scaled_norm(const SparseMatrix& matrix, const std::vector<double>& scale) {
  std::vector<double> sum(scale.size());
  for (std::int64_t j = 0; j < matrix.columns; ++j) {
    for (std::int64_t k = matrix.start[at(j)]; k < matrix.start[at(j + 1)]; ++k) {
      const std::int64_t i = matrix.row[at(k)];
      const double a = std::abs(matrix.value[at(k)]) * scale[at(i)] * scale[at(j)];
      sum[at(j)] += a;
      if (i != j) sum[at(i)] += a;
    }
  }
  return sum.empty() ? 1 : *std::max_element(sum.begin(), sum.end());
}

}  // namespace

void check_sparse(const SparseMatrix& matrix, std::span<const std::int64_t> condensed) {
  for (std::int64_t j = 0; j < matrix.columns; ++j) {
    const std::int64_t first = matrix.start[at(j)];
    if (first == matrix.start[at(j + 1)] || matrix.row[at(first)] != j)
      fail(Status::err_internal, "sparse matrix: column %lld does not start with its diagonal",
           static_cast<long long>(j));
    for (std::int64_t k = first; k < matrix.start[at(j + 1)]; ++k)
      if (!std::isfinite(matrix.value[at(k)]))
        fail(Status::err_nonfinite, "sparse matrix: entry (%lld, %lld) is not finite",
             static_cast<long long>(matrix.row[at(k)]), static_cast<long long>(j));
  }
  std::vector<bool> seen(at(matrix.columns));
  for (const std::int64_t c : condensed) {
    if (c < 0 || c >= matrix.columns || seen[at(c)])
      fail(Status::err_internal, "sparse matrix: condensed unknown %lld is listed twice or not among 0..%lld",
           static_cast<long long>(c), static_cast<long long>(matrix.columns - 1));
    seen[at(c)] = true;
  }
}

void require_memory(std::int64_t unknowns, double bytes, double held) {
  require_memory({bytes - held, bytes}, remedy, factorisation_needs, static_cast<long long>(unknowns));
}

void out_of_memory(std::int64_t unknowns, double bytes) {
  refuse_more_memory(bytes, remedy, factorisation_needs, static_cast<long long>(unknowns));
}

std::vector<double> diagonal_scale(const SparseMatrix& matrix) {
  std::vector<double> scale(at(matrix.columns));
  for (std::int64_t j = 0; j < matrix.columns; ++j) {
    const double d = std::abs(matrix.value[at(matrix.start[at(j)])]);
    scale[at(j)] = d > 0 ? 1 / std::sqrt(d) : 1;
  }
  return scale;
}

double estimate_condition(const SparseMatrix& matrix, const std::function<void(double*)>& solve) {
  if (matrix.columns == 0) return 1;
  const std::vector<double> scale = diagonal_scale(matrix);
  std::vector<double> x(at(matrix.columns));
  // The start has no pattern, so that no mode of a structure is orthogonal to it.
  std::uint64_t state = 1;
  for (double& value : x) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    value = static_cast<double>(state >> 11) * 0x1p-53 - 0.5;
  }
  double growth = 0;
  for (int step = 0; step < 2; ++step) {
    const double before = norm2(x.data(), matrix.columns);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] /= scale[i] * before;
    solve(x.data());
    for (std::size_t i = 0; i < x.size(); ++i) x[i] /= scale[i];
    growth = norm2(x.data(), matrix.columns);
    if (!std::isfinite(growth)) return std::numeric_limits<double>::infinity();
  }
  return growth * scaled_norm(matrix, scale);
}

}  // namespace rollcon
