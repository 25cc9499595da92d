#pragma once
/// Assembly of the rows of a convective operator.

#include <cstdint>
#include <vector>

#include "contact/convection/convection.hpp"

namespace rollcon {

/// A direction across the flow to this part of its length counts as exactly across it.
constexpr double flow_rounding = 1e-10;

class RowBuilder {
 public:
  explicit RowBuilder(std::int64_t rows) : rows_(rows) {}
  /// Adds to entry (row, column).
  void add(std::int32_t row, std::int32_t column, double value) { entry_.push_back({row, column, value}); }
  /// Sorted, entries of one place summed. The builder is empty afterwards.
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
