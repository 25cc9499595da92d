#pragma once
/// Approximates a block of a matrix by some of its columns, chosen by a sample of its rows.

#include <cstdint>
#include <span>
#include <vector>

#include "linalg/hierarchical_factor.hpp"

namespace rollcon {

/// Holds a block as it is, or as the product of some of its columns and weights of these; column-major.
struct Skeleton {
  std::int64_t rows = 0, columns = 0;
  std::int64_t rank = 0;        ///< 0: `own` is the whole block
  std::vector<double> own;      ///< rows x rank, or rows x columns
  std::vector<double> weights;  ///< rank x columns

  /// Writes a part of the block, column-major.
  void write(std::int64_t row, std::int64_t row_count, std::int64_t column, std::int64_t column_count,
             double* to) const;
};

/// Takes the whole block where it has at most `whole` entries or where its rank is not low.
Skeleton skeleton_of(const BlockMatrix& matrix, std::span<const std::int32_t> rows,
                     std::span<const std::int32_t> columns, double accuracy, std::int64_t whole);

}  // namespace rollcon
