#pragma once
/// Factorises a large dense matrix once and solves for many right sides (LAPACK getrf, getrs). It is column-major; the
/// storage is not cleared.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "linalg/system_factor.hpp"

namespace rollcon {

class FactoredMatrix final : public SystemFactor {
 public:
  /// Returns storage for an n by n matrix, entry (i, j) at [i + j * n], to be filled before factor().
  double* prepare(std::int64_t n);
  /// Returns false when a pivot is zero or something is not finite.
  bool factor();
  void solve(double* b, std::int64_t count) const override;
  void eliminate(double* b, std::int64_t count) const override;
  /// Takes a part of the full time: the square of the fraction of the unknowns that are from `first` on.
  void substitute(double* b, std::int64_t count, std::int64_t first) const override;
  void release();

  /// The factors are column-major, the pivots are the rows that the steps took (from 1).
  std::span<const double> factors() const { return {a_.get(), bytes() / sizeof(double)}; }
  std::span<const std::int32_t> pivots() const { return pivot_; }
  /// Takes factors back that were stored: they are where prepare() says, instead of a matrix. Returns false when the
  /// pivots are invalid.
  bool restore(std::span<const std::int32_t> pivot, double condition);

  std::int64_t size() const override { return n_; }
  bool factored() const { return factored_; }
  /// Returns ||A|| ||A^-1|| in Frobenius norms, estimated by the last factor(); it is at least the condition in the
  /// 2-norm, but for the error of the estimate, and close to it where it is large.
  double condition() const override { return condition_; }
  std::size_t bytes() const override { return a_ ? static_cast<std::size_t>(n_ * n_) * sizeof(double) : 0; }

 private:
  void solve(const char* transposed, double* b, std::int64_t count) const;
  bool estimate_condition(double norm);

  std::int64_t n_ = 0;
  bool factored_ = false;
  double condition_ = 0;
  std::unique_ptr<double[]> a_;
  std::vector<int> pivot_;
};

}  // namespace rollcon
