/// Stands in for factorisations over ranks in a build without MUMPS or MPI.

#include "linalg/shared_factor.hpp"
#include "support/error.hpp"

namespace rollcon {

std::unique_ptr<SparseFactor> factor_over_ranks(const SparseMatrix& /*matrix*/,
                                                std::span<const std::int64_t> /*condensed*/, const Ranks& /*ranks*/) {
  fail(Status::err_unsupported,
       "body option factor_ranks is 1, but this build of rollcon is without MUMPS or without MPI (ROLLCON_WITH_MUMPS, "
       "ROLLCON_WITH_MPI); allowed: 0");
}

}  // namespace rollcon
