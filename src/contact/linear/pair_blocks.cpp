#include "contact/linear/pair_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rollcon {
namespace {

// Gauss-Jordan with row exchange; the identity where the block is singular.
void invert_block(double (&a)[3][3], int n, double* out) {
  double inverse[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  bool regular = true;
  for (int k = 0; k < n && regular; ++k) {
    int pivot = k;
    for (int i = k + 1; i < n; ++i)
      if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
    regular = std::abs(a[pivot][k]) > 1e-8;  // rows are in units of traction per traction
    if (!regular) break;
    std::swap(a[k], a[pivot]);
    std::swap(inverse[k], inverse[pivot]);
    const double scale = 1 / a[k][k];
    for (int j = 0; j < n; ++j) a[k][j] *= scale, inverse[k][j] *= scale;
    for (int i = 0; i < n; ++i) {
      if (i == k) continue;
      const double factor = a[i][k];
      for (int j = 0; j < n; ++j) a[i][j] -= factor * a[k][j], inverse[i][j] -= factor * inverse[k][j];
    }
  }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) out[n * i + j] = regular ? inverse[i][j] : (i == j ? 1.0 : 0.0);
}

}  // namespace

void PairBlocks::take(const ReducedSystem& system, bool invert) {
  nodes_ = system.active();
  size_ = system.size();
  components_ = system.components();
  inverse_.clear();
  if (!invert) return;
  const auto entries = static_cast<std::size_t>(components_ * components_);
  inverse_.resize(static_cast<std::size_t>(nodes_) * entries);
  double block[3][3];
  for (std::int64_t a = 0; a < nodes_; ++a) {
    system.pair_block(a, block);
    invert_block(block, components_, inverse_.data() + static_cast<std::size_t>(a) * entries);
  }
}

void PairBlocks::apply(const double* x, double* y) {
  std::copy(x, x + size_, y);
  if (inverse_.empty()) return;
  const std::int64_t c = components_;
  for (std::int64_t a = 0; a < nodes_; ++a) {
    const double* block = inverse_.data() + a * c * c;
    for (std::int64_t i = 0; i < c; ++i) {
      double sum = 0;
      for (std::int64_t j = 0; j < c; ++j) sum += block[c * i + j] * x[j * nodes_ + a];
      y[i * nodes_ + a] = sum;
    }
  }
}

}  // namespace rollcon
