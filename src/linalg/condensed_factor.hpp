#pragma once
/// Solves with what is left of a factorisation for its condensed unknowns alone: the end of a Cholesky factor, which
/// can be stored without the method that made it.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "linalg/sparse_factor.hpp"

namespace rollcon {

/// Overwrites `count` right sides b of view.unknowns entries, one after the other.
void solve_condensed(const CondensedView& view, double* b, std::int64_t count);

/// Makes a factor that can do no more than solve_condensed(). `size` is that of the whole matrix; unknowns, place and
/// matrix have the meaning that CondensedView gives them; statistics are reported of the factorisation, except for its
/// seconds and bytes.
std::unique_ptr<SparseFactor> make_condensed_factor(std::int64_t size, std::int64_t unknowns,
                                                    std::vector<std::int64_t> place, std::unique_ptr<double[]> matrix,
                                                    const SparseStatistics& statistics);

}  // namespace rollcon
