#pragma once
/// Factorises a definite matrix on all ranks of an MPI program together, by MUMPS.

#include <cstdint>
#include <memory>
#include <span>

#include "linalg/sparse_factor.hpp"
#include "support/ranks.hpp"

namespace rollcon {

/// Does what factor_definite() does, where all ranks bring the same matrix. Each holds a part of the factors, and all
/// of the condensed matrix, the same to the bit; what a rank throws by itself is to be told to the others by
/// Ranks::together(). All ranks make each call of solve(), of keep_condensed() and of the destructor together until
/// keep_condensed() has returned, and no rank waits for others after that. Throws err_unsupported in a build without
/// MUMPS or MPI.
std::unique_ptr<SparseFactor> factor_over_ranks(const SparseMatrix& matrix, std::span<const std::int64_t> condensed,
                                                const Ranks& ranks);

}  // namespace rollcon
