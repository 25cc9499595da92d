#pragma once
/// Defines the library's one sparse matrix, in compressed columns.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rollcon {

/// Rows ascend in each column. Factorisations of symmetric matrices take the lower triangle, diagonal included.
struct SparseMatrix {
  std::int64_t rows = 0, columns = 0;
  std::vector<std::int64_t> start;  ///< columns + 1 offsets
  std::vector<std::int64_t> row;
  std::vector<double> value;

  /// Empties the matrix, to be filled column by column.
  void begin(std::int64_t row_count);
  void push(std::int64_t r, double v) {
    row.push_back(r);
    value.push_back(v);
  }
  void end_column();
  std::size_t bytes() const {
    return sizeof(std::int64_t) * (start.capacity() + row.capacity()) + sizeof(double) * value.capacity();
  }
};

SparseMatrix transposed(const SparseMatrix& matrix);
/// Returns the whole of a symmetric matrix.
SparseMatrix both_triangles(const SparseMatrix& lower);

/// Makes a matrix column by column, from entries in any order, summed where they meet.
class SparseBuilder {
 public:
  explicit SparseBuilder(std::int64_t rows);
  void add(std::int64_t row, double value);
  void end_column();
  SparseMatrix take() { return static_cast<SparseMatrix&&>(result_); }

 private:
  SparseMatrix result_;
  std::vector<double> sum_;
  std::vector<std::uint8_t> touched_;
  std::vector<std::int64_t> row_;  ///< rows of this column
};

}  // namespace rollcon
