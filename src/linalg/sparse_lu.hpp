#pragma once
/// LU factorisation of a sparse matrix with a nearly symmetric pattern by UMFPACK. The symbolic analysis is kept as
/// long as the pattern stays the same.

#include <cstddef>
#include <cstdint>
#include <memory>

#include "linalg/sparse_matrix.hpp"

namespace rollcon {

struct SparseLuStatistics {
  std::int64_t nonzeros = 0;  ///< of both factors
  double flops = 0;
  std::int64_t analyses = 0, factorizations = 0;  ///< since construction
  std::size_t bytes = 0, peak_bytes = 0;
};

/// Not to be used by two threads at a time: solves share workspace.
class SparseLu {
 public:
  SparseLu();
  ~SparseLu();
  SparseLu(SparseLu&&) noexcept;
  SparseLu& operator=(SparseLu&&) noexcept;

  /// False in a build without UMFPACK, where factor() throws Error(err_unsupported).
  static bool available();
  /// Returns false when the matrix is singular. Throws Error: err_memory with the need, err_nonfinite.
  bool factor(const SparseMatrix& matrix);
  bool factored() const;
  /// Overwrites a right side, without refinement: callers have the matrix and know what accuracy they need.
  void solve(double* b);
  /// Frees the factors, and with `all` the analysis too.
  void release(bool all);
  const SparseLuStatistics& statistics() const { return statistics_; }

 private:
  struct Factors;
  std::unique_ptr<Factors> factors_;
  SparseLuStatistics statistics_;
};

}  // namespace rollcon
