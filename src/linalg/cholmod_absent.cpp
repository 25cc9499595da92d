/// Stands in for CHOLMOD and MUMPS in a build without them.

#include "linalg/sparse_factor.hpp"
#include "support/error.hpp"

namespace rollcon {

std::unique_ptr<SparseFactor> factor_definite(const SparseMatrix& /*matrix*/,
                                              std::span<const std::int64_t> /*condensed*/,
                                              std::span<const std::int64_t> /*order*/) {
  fail(Status::err_unsupported,
       "this build of rollcon has neither CHOLMOD nor MUMPS (ROLLCON_WITH_CHOLMOD, ROLLCON_WITH_MUMPS)");
}

}  // namespace rollcon
