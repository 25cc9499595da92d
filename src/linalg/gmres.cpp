#include "linalg/gmres.hpp"

#include <algorithm>
#include <cmath>

#include "linalg/dense.hpp"

namespace rollcon {

void Gmres::reserve(std::int64_t n, int krylov) {
  const auto size = static_cast<std::size_t>(n);
  const auto k = static_cast<std::size_t>(krylov);
  if (basis_.size() < size * (k + 1)) basis_.resize(size * (k + 1));
  if (z_.size() < size) z_.resize(size), r_.resize(size);
  // The basis has room for so many vectors of this size, whatever an earlier system had.
  krylov_ = krylov;
  if (cosine_.size() < k) {
    hessenberg_.resize((k + 1) * k);
    cosine_.resize(k);
    sine_.resize(k);
    rhs_.resize(k + 1);
  }
}

std::size_t Gmres::bytes() const {
  return sizeof(double) *
         (basis_.capacity() + hessenberg_.capacity() + z_.capacity() + r_.capacity() + cosine_.capacity() * 3);
}

GmresReport Gmres::solve(std::int64_t n, LinearOperator& a, LinearOperator& precondition, const double* b, double* x,
                         double tolerance, int max_iterations) {
  GmresReport report;
  std::fill(x, x + n, 0.0);
  std::copy(b, b + n, r_.begin());
  const double norm_b = norm2(b, n);
  if (norm_b == 0) {
    report.converged = true;
    return report;
  }
  const double target = tolerance * norm_b;
  while (report.iterations < max_iterations) {
    const GmresReport part = cycle(n, a, precondition, x, target, max_iterations - report.iterations);
    report.iterations += part.iterations;
    // The recursive residual can drift from the true one, which is therefore recomputed before it is trusted.
    a.apply(x, z_.data());
    for (std::int64_t i = 0; i < n; ++i) r_[static_cast<std::size_t>(i)] = b[i] - z_[static_cast<std::size_t>(i)];
    const double norm_r = norm2(r_.data(), n);
    report.residual = norm_r / norm_b;
    report.converged = norm_r <= 2 * target;
    if (report.converged || part.iterations == 0 || !std::isfinite(norm_r)) break;
  }
  return report;
}

GmresReport Gmres::cycle(std::int64_t n, LinearOperator& a, LinearOperator& precondition, double* x, double target,
                         int max_iterations) {
  GmresReport report;
  const auto size = static_cast<std::size_t>(n);
  const int k_max = std::min(krylov_, max_iterations);
  const auto h = [&](int i, int j) -> double& {
    return hessenberg_[static_cast<std::size_t>(i) +
                       static_cast<std::size_t>(j) * (static_cast<std::size_t>(krylov_) + 1)];
  };
  const auto v = [&](int j) { return basis_.data() + static_cast<std::size_t>(j) * size; };
  const double beta = norm2(r_.data(), n);
  if (beta <= target || beta == 0) {
    report.converged = true;
    return report;
  }
  for (std::size_t i = 0; i < size; ++i) v(0)[i] = r_[i] / beta;
  std::fill(rhs_.begin(), rhs_.end(), 0.0);
  rhs_[0] = beta;
  int k = 0;
  for (; k < k_max; ++k) {
    precondition.apply(v(k), z_.data());
    a.apply(z_.data(), v(k + 1));
    const double before = norm2(v(k + 1), n);
    for (int i = 0; i <= k; ++i) {
      h(i, k) = dot(v(i), v(k + 1), n);
      axpy(-h(i, k), v(i), v(k + 1), n);
    }
    h(k + 1, k) = norm2(v(k + 1), n);
    const bool breakdown = !(h(k + 1, k) > 1e-15 * before);
    if (!breakdown)
      for (std::size_t i = 0; i < size; ++i) v(k + 1)[i] /= h(k + 1, k);
    for (int i = 0; i < k; ++i) {  // earlier Givens rotations
      const auto s = static_cast<std::size_t>(i);
      const double upper = cosine_[s] * h(i, k) + sine_[s] * h(i + 1, k);
      h(i + 1, k) = -sine_[s] * h(i, k) + cosine_[s] * h(i + 1, k);
      h(i, k) = upper;
    }
    const double radius = std::hypot(h(k, k), h(k + 1, k));
    if (!(radius > 0)) break;
    const auto s = static_cast<std::size_t>(k);
    cosine_[s] = h(k, k) / radius;
    sine_[s] = h(k + 1, k) / radius;
    h(k, k) = radius;
    rhs_[s + 1] = -sine_[s] * rhs_[s];
    rhs_[s] *= cosine_[s];
    if (std::abs(rhs_[s + 1]) <= target || breakdown) {
      ++k;
      break;
    }
  }
  report.iterations = k;
  for (int i = k - 1; i >= 0; --i) {  // back substitution, in place
    double sum = rhs_[static_cast<std::size_t>(i)];
    for (int j = i + 1; j < k; ++j) sum -= h(i, j) * rhs_[static_cast<std::size_t>(j)];
    rhs_[static_cast<std::size_t>(i)] = sum / h(i, i);
  }
  std::fill(r_.begin(), r_.end(), 0.0);
  for (int j = 0; j < k; ++j) axpy(rhs_[static_cast<std::size_t>(j)], v(j), r_.data(), n);
  precondition.apply(r_.data(), z_.data());
  axpy(1, z_.data(), x, n);
  return report;
}

}  // namespace rollcon
