#pragma once
/// A large dense matrix, factorised once and solved for many right sides (LAPACK getrf, getrs). Column-major; the
/// storage is not cleared.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace rollcon {

class FactoredMatrix {
 public:
  /// Storage for an n by n matrix, entry (i, j) at [i + j * n], to be filled before factor().
  double* prepare(std::int64_t n);
  /// False when a pivot is zero or something is not finite.
  bool factor();
  /// Overwrites `count` right sides of length size(), one after the other.
  void solve(double* b, std::int64_t count) const;
  /// The same in two steps, the second for the unknowns from `first` on alone: it takes the square of their part of
  /// size() of the time, and leaves what stands before them as it is.
  void eliminate(double* b, std::int64_t count) const;
  void substitute(double* b, std::int64_t count, std::int64_t first) const;
  void release();

  /// Factors as they are kept, column-major, and the row that each step took (from 1).
  std::span<const double> factors() const { return {a_.get(), bytes() / sizeof(double)}; }
  std::span<const std::int32_t> pivots() const { return pivot_; }
  /// Takes them back: the factors are where prepare() says, instead of a matrix. False when the pivots are none.
  bool restore(std::span<const std::int32_t> pivot, double condition);

  std::int64_t size() const { return n_; }
  bool factored() const { return factored_; }
  /// ||A|| ||A^-1|| in Frobenius norms, estimated by the last factor(); at least the condition in
  /// the 2-norm, but for the estimate. Close where it is large.
  double condition() const { return condition_; }
  std::size_t bytes() const { return a_ ? static_cast<std::size_t>(n_ * n_) * sizeof(double) : 0; }

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
