#pragma once
/// Factorises a large matrix whose blocks of places far from each other have low rank: a hierarchical matrix and its LU
/// by hmat-oss. Calls from several threads take turns, because hmat-oss keeps variables of its own.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "linalg/system_factor.hpp"

namespace rollcon {

/// Gives a square matrix by blocks.
class BlockMatrix {
 public:
  virtual ~BlockMatrix() = default;
  /// Overwrites rows.size() x columns.size() entries, column-major. One thread calls it at a time.
  virtual void block(std::span<const std::int32_t> rows, std::span<const std::int32_t> columns, double* to) const = 0;
};

/// Names a row, a column and where both are in space.
struct Pivot {
  std::int32_t row = 0, column = 0;
  std::array<double, 3> place{};
};

/// Says whether this build has hierarchical factors.
bool has_hierarchical_factor();
/// Returns a fit of measured bytes that the factors of this many unknowns on a surface take at their peak.
double hierarchical_bytes(std::int64_t unknowns, double accuracy);

/// Assembles and factorises. Each row and each column has one pivot. accuracy: relative error of the blocks and of what
/// is computed with them. Throws err_memory, err_singular, and err_unsupported in a build without it; a stop asked for
/// (interrupt.hpp) ends it within a second or so.
std::unique_ptr<SystemFactor> factor_hierarchically(const BlockMatrix& matrix, std::span<const Pivot> pivots,
                                                    double accuracy);

/// Writes factors that factor_hierarchically() made.
void write_hierarchical(const SystemFactor& factor, const std::function<void(const void*, std::size_t)>& write);
/// Takes what write_hierarchical() wrote for the same pivots; condition: that of the factors. `read` throws where there
/// are not so many bytes. Throws err_io where it is no such thing, and what factor_hierarchically() throws.
std::unique_ptr<SystemFactor> read_hierarchical(std::span<const Pivot> pivots, double condition,
                                                const std::function<void(void*, std::size_t)>& read);

}  // namespace rollcon
