#include "linalg/gcr.hpp"

#include <algorithm>
#include <cmath>

#include "linalg/dense.hpp"

namespace rollcon {
namespace {

constexpr double dependent = 1e-12;  // fraction of a direction's image that must be new

}  // namespace

void RecyclingGcr::reserve(std::int64_t n, int directions) {
  room_ = directions;
  const auto all = static_cast<std::size_t>(n * directions);
  if (z_.size() >= all && r_.size() >= static_cast<std::size_t>(n)) return;
  count_ = 0;
  const std::int64_t spare = with_room(n);
  z_.resize(static_cast<std::size_t>(spare * directions));
  q_.resize(z_.size());
  r_.resize(static_cast<std::size_t>(spare));
  product_.resize(r_.size());
}

std::size_t RecyclingGcr::bytes() const {
  return sizeof(double) * (z_.capacity() + q_.capacity() + r_.capacity() + product_.capacity());
}

// Takes the best step along a direction: what is left of the residual is orthogonal to its image.
void RecyclingGcr::advance(int direction, double* x) {
  const double* q = q_.data() + direction * n_;
  const double step = dot(q, r_.data(), n_);
  axpy(step, z_.data() + direction * n_, x, n_);
  axpy(-step, q, r_.data(), n_);
}

bool RecyclingGcr::add_direction(LinearOperator& a, LinearOperator& precondition) {
  double *z = z_.data() + count_ * n_, *q = q_.data() + count_ * n_;
  precondition.apply(r_.data(), z);
  a.apply(z, q);
  const double whole = norm2(q, n_);
  for (int pass = 0; pass < 2; ++pass)  // twice, against rounding
    for (int k = 0; k < count_; ++k) {
      const double part = dot(q_.data() + k * n_, q, n_);
      axpy(-part, q_.data() + k * n_, q, n_);
      axpy(-part, z_.data() + k * n_, z, n_);
    }
  const double left = norm2(q, n_);
  if (!(left > dependent * whole) || !std::isfinite(left)) return false;
  for (std::int64_t i = 0; i < n_; ++i) z[i] /= left, q[i] /= left;
  ++count_;
  return true;
}

GmresReport RecyclingGcr::solve(std::int64_t n, LinearOperator& a, LinearOperator& precondition, const double* b,
                                double* x, double tolerance, int max_iterations) {
  GmresReport report;
  if (n != n_) count_ = 0;
  n_ = n;
  std::fill(x, x + n, 0.0);
  std::copy(b, b + n, r_.begin());
  const double norm_b = norm2(b, n), target = tolerance * norm_b;
  if (norm_b == 0) {
    report.converged = true;
    return report;
  }
  for (int k = 0; k < count_; ++k) advance(k, x);
  for (bool again = true; again;) {
    const int before = report.iterations;
    while (norm2(r_.data(), n) > target && report.iterations < max_iterations && count_ < room_) {
      if (!add_direction(a, precondition)) break;
      advance(count_ - 1, x);
      ++report.iterations;
    }
    // The recursive residual can drift from the true one, which is therefore recomputed before it is trusted.
    a.apply(x, product_.data());
    for (std::int64_t i = 0; i < n; ++i) r_[static_cast<std::size_t>(i)] = b[i] - product_[static_cast<std::size_t>(i)];
    report.residual = norm2(r_.data(), n) / norm_b;
    report.converged = report.residual <= 2 * tolerance;
    again = !report.converged && report.iterations > before && std::isfinite(report.residual);
  }
  return report;
}

}  // namespace rollcon
