// Tests products of narrow matrices in place of ones of low rank.

#include "linalg/row_basis.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rollcon {
namespace {

TEST(row_basis, finds_the_rank_and_the_matrix) {
  constexpr std::int64_t rows = 30, columns = 50, rank = 4;
  RowMatrix<double> matrix;
  matrix.resize(rows, columns);
  for (std::int64_t i = 0; i < rows; ++i)
    for (std::int64_t j = 0; j < columns; ++j)
      for (std::int64_t k = 0; k < rank; ++k)
        matrix.row(i)[j] += std::pow(0.1, k) * std::sin(1.0 + i * (k + 1)) * std::cos(0.3 * j * (k + 1));
  const RowBasis found = row_basis(matrix, 1e-12);
  ASSERT_EQ(found.row.rows(), rank);
  double off = 0, skew = 0;
  for (std::int64_t i = 0; i < rows; ++i)
    for (std::int64_t j = 0; j < columns; ++j) {
      double sum = 0;
      for (std::int64_t k = 0; k < rank; ++k) sum += found.weight.row(i)[k] * found.row.row(k)[j];
      off = std::max(off, std::abs(sum - matrix.row(i)[j]));
    }
  for (std::int64_t k = 0; k < rank; ++k)
    for (std::int64_t m = 0; m < rank; ++m)
      skew = std::max(skew, std::abs(dot(found.row.row(k), found.row.row(m), columns) - (k == m ? 1 : 0)));
  EXPECT_LT(off, 1e-12);
  EXPECT_LT(skew, 1e-12);
}

TEST(row_basis, leaves_out_what_is_shorter_than_the_rest) {
  RowMatrix<double> matrix;
  matrix.resize(3, 3);
  for (std::int64_t i = 0; i < 3; ++i) matrix.row(i)[i] = std::pow(0.01, i);
  const RowBasis found = row_basis(matrix, 1e-3);
  ASSERT_EQ(found.row.rows(), 2);
  EXPECT_EQ(found.weight.row(1)[1], 0.01);
}

}  // namespace
}  // namespace rollcon
