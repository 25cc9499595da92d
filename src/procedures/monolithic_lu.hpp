#pragma once
/// Factors of a monolithic system: trivial pivots first (monolithic_core.hpp), then UMFPACK, or
/// LAPACK where most of what remains is dense.

#include "linalg/factored_matrix.hpp"
#include "linalg/sparse_lu.hpp"
#include "procedures/monolithic_core.hpp"

namespace rollcon {

class MonolithicLu {
 public:
  /// False: singular. The factors stay those of this step.
  bool factor(const MonolithicMatrix& matrix);
  /// Of the whole system; x may be b.
  void solve(const double* b, double* x);
  const MonolithicCore& core() const { return core_; }
  bool valid() const { return valid_; }
  void release();

  double seconds_matrix = 0;
  std::size_t bytes() const {
    return core_.bytes() + entries_.bytes() + sparse_.statistics().bytes + dense_.bytes();
  }

 private:
  MonolithicCore core_;
  SparseMatrix entries_;
  SparseLu sparse_;
  FactoredMatrix dense_;
  bool valid_ = false, is_dense_ = false;
  std::vector<double> right_, whole_;
};

}  // namespace rollcon
