#pragma once
/// Holds the stiffness or flexibility of a body on its nodes, as another program condensed it.

#include <cstdint>

#include "linalg/dense.hpp"

namespace rollcon {

enum class MatrixForm : std::int32_t { stiffness = 1, flexibility = 2 };

/// Counts rows 3 * node + component, in the body's axes.
struct CondensedMatrix {
  MatrixForm form = MatrixForm::stiffness;
  RowMatrix<double> value;
};

}  // namespace rollcon
