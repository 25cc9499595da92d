#pragma once
/// Factorises a step's whole matrix by UMFPACK, or by LAPACK where most of it is dense.

#include "linalg/factored_matrix.hpp"
#include "linalg/sparse_lu.hpp"
#include "procedures/contact_equations.hpp"

namespace rollcon {

class StepFactors {
 public:
  /// Returns false if the matrix is singular. Throws Error(err_unsupported) when it is sparse and large, and the build
  /// has no UMFPACK.
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
