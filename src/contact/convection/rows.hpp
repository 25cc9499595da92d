#pragma once
/// Assembles the rows of a convective operator.

#include <cstdint>
#include <vector>

#include "contact/convection/convection.hpp"

namespace rollcon {

/// Directions that lie along the flow by less than this fraction of their length count as exactly across it.
constexpr double flow_rounding = 1e-10;

class RowBuilder {
 public:
  explicit RowBuilder(std::int64_t rows) : rows_(rows) {}
  /// Adds to entry (row, column).
  void add(std::int32_t row, std::int32_t column, double value) { entry_.push_back({row, column, value}); }
  /// Returns the rows sorted, entries of one place summed. The builder is empty afterwards.
  SparseRows finish();

 private:
  struct Entry {
    std::int32_t row, column;
    double value;
  };
  std::int64_t rows_;
  std::vector<Entry> entry_;
};

}  // namespace rollcon
