#pragma once
/// Preconditioner of a system on active nodes by the inverse of each node's own block; or none.

#include <vector>

#include "contact/linear/reduced_system.hpp"

namespace rollcon {

class PairBlocks final : public LinearOperator {
 public:
  /// invert: false leaves vectors as they are.
  void take(const ReducedSystem& system, bool invert);
  void apply(const double* x, double* y) override;
  std::size_t bytes() const { return inverse_.capacity() * sizeof(double); }

 private:
  std::vector<double> inverse_;  ///< components squared per node; empty: identity
  std::int64_t nodes_ = 0, size_ = 0;
  int components_ = 0;
};

}  // namespace rollcon
