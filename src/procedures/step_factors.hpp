#pragma once
/// Factors of a step's whole matrix: UMFPACK's, or LAPACK's where most of it is dense.

#include "linalg/factored_matrix.hpp"
#include "linalg/sparse_lu.hpp"
#include "procedures/contact_equations.hpp"

namespace rollcon {

class StepFactors {
 public:
  /// False: singular. Throws Error(err_unsupported) when the matrix is sparse, large, and the build has no UMFPACK.
  bool factor(const ContactEquations& equations);
  /// Overwrites a right side.
  void solve(double* b);
  std::size_t bytes() const { return entries_.bytes() + sparse_.statistics().bytes + dense_.bytes(); }

 private:
  SparseMatrix entries_;
  SparseLu sparse_;
  FactoredMatrix dense_;
  bool is_dense_ = false;
};

}  // namespace rollcon
