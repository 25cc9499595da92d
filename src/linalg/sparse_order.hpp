#pragma once
/// Finds a fill-reducing order of the unknowns with the condensed ones last: METIS's nested dissection of the whole
/// graph, from which the condensed ones are then moved to the end. On meshes of hexahedra, dissecting only the rest
/// saves at most 5 % of the operations, and minimum degree takes three to four times as many.

#include <cstdint>
#include <span>
#include <vector>

#include "linalg/sparse_factor.hpp"
#include "linalg/sparse_groups.hpp"

namespace rollcon {

struct GraphOrder {
  std::vector<std::int64_t> group;  ///< the group at each place
  std::size_t peak_bytes = 0;
};

/// Orders by METIS through CHOLMOD, or through MUMPS in builds without CHOLMOD; by another order where it refuses.
/// Throws std::bad_alloc. METIS finds memory or raises a signal that it catches; then it gives no order, and CHOLMOD
/// does not notice.
GraphOrder dissect(const SparseGroups& groups);

/// Says whether each of 0 .. order.size() - 1 comes once.
bool is_permutation(std::span<const std::int64_t> order);

struct SparseOrder {
  std::vector<std::int64_t> unknown;  ///< the unknown at each place, condensed ones at the end
  std::size_t peak_bytes = 0;
};

SparseOrder order_unknowns(const SparseMatrix& matrix, std::span<const std::int64_t> condensed);

/// Returns the matrix in that order, with rows not sorted.
SparseMatrix permuted(const SparseMatrix& matrix, std::span<const std::int64_t> unknown);

}  // namespace rollcon
