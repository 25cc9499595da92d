#pragma once
/// Reads square symmetric matrices from files of other programs, and writes them.

#include <cstdint>
#include <string>
#include <vector>

#include "linalg/dense.hpp"

namespace rollcon {

struct MatrixFile {
  RowMatrix<double> value;
  /// Node of each row and its component (0 x, 1 y, 2 z), as the file numbers them; empty: it does not name them.
  std::vector<std::int64_t> node;
  std::vector<std::int32_t> component;
};

/// Reads a MatrixMarket file (array or coordinate; real or integer; general or symmetric), or a substructure of Abaqus
/// or CalculiX: *USER ELEMENT with the comment ELEMENT NODES, and *MATRIX, TYPE=STIFFNESS. Throws err_io naming the
/// file and the line, also if it has another number of rows than `rows`.
MatrixFile read_matrix_file(const std::string& path, std::int64_t rows);

/// Writes the lower triangle of a symmetric matrix as a MatrixMarket file. title: told in the file, lines apart by \n.
/// err_io.
void write_matrix_file(const std::string& path, const RowMatrix<double>& matrix, const std::string& title);

}  // namespace rollcon
