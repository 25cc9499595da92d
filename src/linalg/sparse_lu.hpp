#pragma once
/// Factorises a sparse matrix with a nearly symmetric pattern into LU by UMFPACK. The symbolic analysis is kept as long
/// as the pattern stays the same.

#include <cstddef>
#include <cstdint>
#include <memory>

#include "linalg/sparse_matrix.hpp"

namespace rollcon {

struct SparseLuStatistics {
  std::int64_t nonzeros = 0;  ///< nonzero entries of both factors
  double flops = 0;
  std::int64_t analyses = 0, factorizations = 0;  ///< numbers since construction
  std::size_t bytes = 0, peak_bytes = 0;
};

/// Solves with the factors. Two threads must not use one object at a time, because solves use one workspace.
class SparseLu {
 public:
  SparseLu();
  ~SparseLu();
  SparseLu(SparseLu&&) noexcept;
  SparseLu& operator=(SparseLu&&) noexcept;

  /// Returns false in a build without UMFPACK, where factor() throws Error(err_unsupported).
  static bool available();
  /// Returns false when the matrix is singular. Throws Error: err_memory with the need, err_nonfinite.
  bool factor(const SparseMatrix& matrix);
  bool factored() const;
  /// Overwrites a right side, without refinement, because callers have the matrix and know what accuracy they need.
  void solve(double* b);
  /// Frees the factors, and with `all` also the analysis.
  void release(bool all);
  const SparseLuStatistics& statistics() const { return statistics_; }

 private:
  struct Factors;
  std::unique_ptr<Factors> factors_;
  SparseLuStatistics statistics_;
};

}  // namespace rollcon
