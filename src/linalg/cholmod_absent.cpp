/// Stands in for CHOLMOD in a build without it.

#include "linalg/sparse_factor.hpp"
#include "support/error.hpp"

namespace rollcon {

std::unique_ptr<SparseFactor> factor_by_cholmod(const SparseMatrix& /*matrix*/,
                                                std::span<const std::int64_t> /*condensed*/) {
  fail(Status::err_unsupported, "this build of rollcon has no CHOLMOD (ROLLCON_WITH_CHOLMOD is OFF)");
}

}  // namespace rollcon
