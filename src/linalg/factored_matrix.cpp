#include "linalg/factored_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "linalg/dense.hpp"
#include "linalg/lapack.hpp"
#include "linalg/panel_lu.hpp"
#include "support/interrupt.hpp"

namespace rollcon {
namespace {

constexpr int slab = 256;  // right sides between two checks for a stop

// Adds up in four sums, because in a single one each addition would wait for the one before.
template <class Term>
double sum(const double* x, std::int64_t n, Term term) {
  double part[4] = {};
  std::int64_t i = 0;
  for (; i + 4 <= n; i += 4)
    for (int k = 0; k < 4; ++k) part[k] += term(x[i + k]);
  for (; i < n; ++i) part[0] += term(x[i]);
  return (part[0] + part[1]) + (part[2] + part[3]);
}

// Returns the Frobenius norm, of a large matrix from every seventh column, because reading all of it once more would
// take half a hundredth of its preparation. Columns are scaled, because squares of entries may overflow.
double frobenius_norm(const double* a, std::int64_t n) {
  const std::int64_t step = n > 512 ? 7 : 1;
  double norm = 0;
  for (std::int64_t j = 0; j < n; j += step) {
    const double* column = a + j * n;
    const double mean = sum(column, n, [](double v) { return std::abs(v); });
    if (!std::isfinite(mean)) return mean;
    const double scale = 1 / mean;
    if (!std::isfinite(scale)) continue;  // a column of zeros
    const auto square = [scale](double v) { return (v * scale) * (v * scale); };
    norm = std::hypot(norm, mean * std::sqrt(sum(column, n, square)));
  }
  const std::int64_t columns = (n + step - 1) / step;
  return std::sqrt(static_cast<double>(n) / static_cast<double>(columns)) * norm;
}

}  // namespace

double* FactoredMatrix::prepare(std::int64_t n) {
  release();
  a_ = std::make_unique_for_overwrite<double[]>(static_cast<std::size_t>(n * n));
  pivot_.resize(static_cast<std::size_t>(n));
  n_ = n;
  return a_.get();
}

bool FactoredMatrix::factor() {
  const auto n = static_cast<int>(n_);
  const double norm = frobenius_norm(a_.get(), n_);
  if (!std::isfinite(norm)) return false;
  if (factor_by_panels(n, a_.get(), pivot_.data()) != 0) return false;
  factored_ = estimate_condition(norm);
  return factored_;
}

// Estimates ||A|| ||A^-1|| in Frobenius norms. For x of random signs the mean of |A^-1 x|^2 is ||A^-1||^2 (Hutchinson
// 1989). One such x is enough to see that a matrix is sound; if it may not be, a step of inverse iteration from A^-1 x
// finds the direction that hardly resists. gecon's five solutions, each scaled against overflow, take up to a seventh
// of getrf's time. The solution shows what is not finite in the factors, except for an infinite pivot. The right side
// is scaled by the norm, so that solutions overflow only where the condition does.
bool FactoredMatrix::estimate_condition(double norm) {
  constexpr double sound = 1e8;
  condition_ = std::numeric_limits<double>::infinity();
  const auto finite = [](double v) { return std::isfinite(v); };
  for (std::int64_t k = 0; k < n_; ++k)
    if (!finite(a_[static_cast<std::size_t>(k * (n_ + 1))])) return false;
  std::vector<double> x(static_cast<std::size_t>(n_));
  std::uint64_t state = 1;
  for (double& value : x) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    value = state >> 63 != 0 ? norm : -norm;
  }
  solve("N", x.data(), 1);
  if (!std::all_of(x.begin(), x.end(), finite)) return false;
  const double growth = norm2(x.data(), n_);
  if (growth > sound) {
    for (double& value : x) value *= norm / growth;
    solve("T", x.data(), 1);
    if (!std::all_of(x.begin(), x.end(), finite)) return false;
    condition_ = std::max(growth, norm2(x.data(), n_));
  } else {
    condition_ = growth;
  }
  return true;
}

void FactoredMatrix::solve(double* b, std::int64_t count) const {
  solve("N", b, count);
}

void FactoredMatrix::eliminate(double* b, std::int64_t count) const {
  const auto n = static_cast<int>(n_), m = static_cast<int>(count);
  if (n == 0 || m == 0) return;
  constexpr int first = 1, step = 1;
  constexpr double one = 1;
  for (int k = 0; k < m; k += slab) {
    check_interrupt();
    const int columns = std::min(slab, m - k);
    double* part = b + static_cast<std::int64_t>(k) * n_;
    dlaswp_(&columns, part, &n, &first, &n, pivot_.data(), &step);
    dtrsm_("L", "L", "N", "U", &n, &columns, &one, a_.get(), &n, part, &n);
  }
}

void FactoredMatrix::substitute(double* b, std::int64_t count, std::int64_t first) const {
  const auto n = static_cast<int>(n_), m = static_cast<int>(count), rest = static_cast<int>(n_ - first);
  if (rest <= 0 || m == 0) return;
  constexpr double one = 1;
  for (int k = 0; k < m; k += slab) {
    check_interrupt();
    const int columns = std::min(slab, m - k);
    dtrsm_("L", "U", "N", "N", &rest, &columns, &one, a_.get() + first * (n_ + 1), &n,
           b + static_cast<std::int64_t>(k) * n_ + first, &n);
  }
}

void FactoredMatrix::solve(const char* transposed, double* b, std::int64_t count) const {
  const auto n = static_cast<int>(n_), m = static_cast<int>(count);
  int info = 0;
  if (n > 0 && m > 0) dgetrs_(transposed, &n, &m, a_.get(), &n, pivot_.data(), b, &n, &info);
}

bool FactoredMatrix::restore(std::span<const std::int32_t> pivot, double condition) {
  const bool good = pivot.size() == pivot_.size() &&
                    std::all_of(pivot.begin(), pivot.end(), [&](std::int32_t row) { return row >= 1 && row <= n_; });
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
