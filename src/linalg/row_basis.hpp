#pragma once
/// Writes matrices of low rank as products of two narrow ones.

#include "linalg/dense.hpp"

namespace rollcon {

struct RowBasis {
  RowMatrix<double> row;     ///< orthonormal rows
  RowMatrix<double> weight;  ///< weight times row is the matrix
};

/// Finds the fewest rows, the longest first, that leave no row of the matrix more than `rest` long.
RowBasis row_basis(RowMatrix<double> matrix, double rest);

}  // namespace rollcon
