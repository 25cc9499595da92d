#include "linalg/kept_lu.hpp"

#include <algorithm>
#include <cmath>

namespace rollcon {

bool KeptLu::factor(std::span<const std::int64_t> key, const double* matrix) {
  const auto n = static_cast<std::int64_t>(key.size());
  float* to = lu_.prepare(n);
  for (std::int64_t i = 0; i < n * n; ++i) to[i] = static_cast<float>(matrix[i]);
  valid_ = lu_.factor();
  place_.clear();
  for (std::int64_t i = 0; i < n; ++i) place_[key[static_cast<std::size_t>(i)]] = i;
  work_.resize(key.size());
  return valid_;
}

void KeptLu::match(std::span<const std::int64_t> key) {
  index_.resize(key.size());
  for (std::size_t i = 0; i < key.size(); ++i) {
    const auto found = place_.find(key[i]);
    index_[i] = found == place_.end() ? -1 : found->second;
  }
}

void KeptLu::apply(const double* x, double* y) {
  const std::size_t n = index_.size();
  // Single precision has a narrow range: scale the residual to order one.
  double largest = 0;
  for (std::size_t i = 0; i < n; ++i) largest = std::max(largest, std::abs(x[i]));
  std::copy(x, x + n, y);
  if (!(largest > 0) || !std::isfinite(largest)) return;
  std::fill(work_.begin(), work_.end(), 0.0f);
  for (std::size_t i = 0; i < n; ++i)
    if (index_[i] >= 0)
      work_[static_cast<std::size_t>(index_[i])] = static_cast<float>(x[i] / largest);
  lu_.solve(work_.data());
  for (std::size_t i = 0; i < n; ++i)
    if (index_[i] >= 0)
      y[i] = largest * static_cast<double>(work_[static_cast<std::size_t>(index_[i])]);
}

}  // namespace rollcon
