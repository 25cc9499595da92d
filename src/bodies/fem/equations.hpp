#pragma once
/// Finite elements written out: the whole stiffness matrix and loads on its unknowns.

#include <cstddef>

#include "bodies/model/expanded_compliance.hpp"
#include "linalg/sparse_factor.hpp"

namespace rollcon::fem {

/// Both triangles; rows stay ascending.
SparseColumns whole_matrix(const SparseSymmetric& lower);

inline std::size_t bytes_of(const SparseSymmetric& matrix) {
  return matrix.value.capacity() * sizeof(double) +
         (matrix.row.capacity() + matrix.start.capacity()) * sizeof(std::int64_t);
}

}  // namespace rollcon::fem
