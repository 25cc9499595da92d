#pragma once
/// Factorises large sparse symmetric systems once, with some unknowns condensed: these come last, and the end of the
/// factor is that of the condensed matrix. CHOLMOD computes LL' of positive definite matrices, or MUMPS where it is not
/// built.

#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <span>
#include <vector>

#include "linalg/sparse_matrix.hpp"

namespace rollcon {

/// Is thrown when a pivot is not positive, and when the factorisation passes but the condition is that of a singular
/// matrix; it then names the unknown of the smallest pivot.
class ZeroPivot : public std::exception {
 public:
  explicit ZeroPivot(std::int64_t unknown) : unknown_(unknown) {}
  std::int64_t unknown() const { return unknown_; }
  const char* what() const noexcept override { return "zero pivot"; }

 private:
  std::int64_t unknown_;
};

struct SparseStatistics {
  std::int64_t nonzeros = 0;        ///< nonzero entries of the factors
  double flops = 0, condition = 0;  ///< condition of the matrix scaled to a unit diagonal
  double seconds_order = 0, seconds_factor = 0;
  std::size_t bytes = 0, peak_bytes = 0;
};

/// Refers to the dense matrix that solve_condensed works with, column-major; only the lower triangle of L counts.
struct CondensedView {
  std::int64_t unknowns = 0;
  const double* matrix = nullptr;
  std::span<const std::int64_t> place;  ///< row of L of each unknown, in the order given
};

/// Solves with the factors. Two threads must not use one object at a time, because solves use one workspace.
class SparseFactor {
 public:
  virtual ~SparseFactor() = default;
  virtual std::int64_t size() const = 0;
  /// Overwrites `count` full right sides, one after the other.
  virtual void solve(double* b, std::int64_t count) = 0;
  /// Solves for right sides that vanish except at the condensed unknowns; the solution there overwrites them. b holds
  /// the condensed unknowns in the order given, times count, one right side after the other.
  virtual void solve_condensed(double* b, std::int64_t count) = 0;
  /// Frees all that solve_condensed does not need; solve may not be called any more.
  virtual void keep_condensed() = 0;
  /// Returns what keep_condensed() kept, owned by the factor; call it only after that.
  virtual CondensedView condensed() const = 0;
  virtual SparseStatistics statistics() const = 0;
};

/// Factorises a matrix given by its lower triangle. The condensed unknowns are distinct; there may be none. Throws
/// ZeroPivot, or Error: err_memory with the need, err_nonfinite, err_unsupported in a build without the method. BLAS
/// threads are the caller's matter; no others are started.
/// order: order_unknowns() of a matrix of the same pattern and the same condensed unknowns; empty: it is found anew.
std::unique_ptr<SparseFactor> factor_definite(const SparseMatrix& matrix, std::span<const std::int64_t> condensed,
                                              std::span<const std::int64_t> order = {});

}  // namespace rollcon
