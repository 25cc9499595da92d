#pragma once
/// Total sliding given: rigid slip so great that elastic slip turns its direction a little, but stops no node.
/// Tractions are then explicit, -mu p s/|s|, up to that turn, which a fixed point takes in: no stick test, no linear
/// system (docs/theory.md, section 8).

#include <cstdint>
#include <vector>

#include "contact/problem/problem.hpp"

namespace rollcon {

class TotalSliding {
 public:
  /// Whether every node in contact slides under these pressures, whatever the tractions that friction allows: elastic
  /// slip is at most the sum of |D A| mu p. False also where the fixed point would converge slowly. Needs given
  /// creepages and dense rows.
  bool applies(const Problem& problem, const Prescribed& given, const Iterate& iterate);
  /// After applies(): tangential tractions to a relative change of `tolerance`. Leaves them and their slip in the
  /// iterate. Number of steps; 0: not converged.
  std::int64_t solve(const Problem& problem, const Prescribed& given, Iterate& iterate, double tolerance);
  /// To be called when the operators were assembled anew.
  void operators_changed() { row_sum_.clear(); }

 private:
  bool bound_holds(const Problem& problem, const Prescribed& given, const Iterate& iterate, std::int64_t i,
                   double bound);

  std::vector<std::int32_t> loaded_;  ///< nodes with friction and pressure
  std::vector<double> row_sum_;       ///< of |D A| over all nodes, by node; negative: not known
  std::vector<double> next_[2];
};

}  // namespace rollcon
