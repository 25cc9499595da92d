#include "linalg/factored_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "linalg/lapack.hpp"

namespace rollcon {

double* FactoredMatrix::prepare(std::int64_t n) {
  release();
  a_ = std::make_unique_for_overwrite<double[]>(static_cast<std::size_t>(n * n));
  pivot_.resize(static_cast<std::size_t>(n));
  n_ = n;
  return a_.get();
}

bool FactoredMatrix::factor() {
  const auto n = static_cast<int>(n_);
  double norm = 0;
  for (std::int64_t j = 0; j < n_; ++j) {
    double sum = 0;
    const double* column = a_.get() + j * n_;
    for (std::int64_t i = 0; i < n_; ++i) sum += std::abs(column[i]);
    if (!std::isfinite(sum)) return false;
    norm = std::max(norm, sum);
  }
  int info = 0;
  dgetrf_(&n, &n, a_.get(), &n, pivot_.data(), &info);
  if (info != 0) return false;
  std::vector<double> work(static_cast<std::size_t>(4 * n_));
  std::vector<int> integers(static_cast<std::size_t>(n_));
  double reciprocal = 0;
  dgecon_("1", &n, a_.get(), &n, &norm, &reciprocal, work.data(), integers.data(), &info);
  condition_ = reciprocal > 0 ? 1 / reciprocal : std::numeric_limits<double>::infinity();
  factored_ = info == 0 && !std::isnan(reciprocal);
  return factored_;
}

void FactoredMatrix::solve(double* b, std::int64_t count) const {
  const auto n = static_cast<int>(n_), m = static_cast<int>(count);
  int info = 0;
  if (n > 0 && m > 0) dgetrs_("N", &n, &m, a_.get(), &n, pivot_.data(), b, &n, &info);
}

bool FactoredMatrix::restore(std::span<const std::int32_t> pivot, double condition) {
  const bool good = pivot.size() == pivot_.size() &&
                    std::all_of(pivot.begin(), pivot.end(),
                                [&](std::int32_t row) { return row >= 1 && row <= n_; });
  if (!good) return false;
  std::copy(pivot.begin(), pivot.end(), pivot_.begin());
  condition_ = condition;
  factored_ = true;
  return true;
}

void FactoredMatrix::release() {
  a_.reset();
  std::vector<int>().swap(pivot_);
  n_ = 0;
  factored_ = false;
}

}  // namespace rollcon
