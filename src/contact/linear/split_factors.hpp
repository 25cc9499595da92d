#pragma once
/// Preconditions Newton's systems by single-precision factors of an earlier system, the tangential rows and the normal
/// ones by themselves, mapped onto the present one node by node.

#include <cstdint>
#include <vector>

#include "contact/linear/free_system.hpp"
#include "linalg/lu.hpp"

namespace rollcon {

class SplitFactors final : public LinearOperator {
 public:
  /// Factorises what the system's part has; normal rows not again while the same nodes are in contact. Returns false if
  /// it is singular to single precision.
  bool factor(FreeSystem& system, std::int64_t node_count);
  /// Says whether the factors belong to the system's part, with as many unknown motions.
  bool usable(const FreeSystem& system) const;
  /// Says what the next vectors are made of. Nodes that were not active in the factors keep their residual.
  void match(FreeSystem& system);
  /// Counts the nodes that match() found not active before or in another state of friction.
  std::int64_t changed() const { return changed_; }
  /// Solves for the tangential unknowns first; their effect on the normal rows counts in these.
  void apply(const double* x, double* y) override;
  void forget() { tangential_.valid = normal_.valid = false; }
  std::size_t bytes() const;

 private:
  struct Block {
    Lu<float> lu;
    bool valid = false;
    std::int64_t nodes = 0, borders = 0;
    std::vector<std::int32_t> node;   ///< nodes active when the factors were made
    std::vector<std::int32_t> place;  ///< position of each node among those, or -1
    std::vector<float> work;
    bool factor(FreeSystem& system, FreeSystem::Rows rows, std::int64_t node_count);
    bool usable(const FreeSystem& system, FreeSystem::Rows rows) const;
    bool same_nodes(const FreeSystem& system) const;
  };
  void solve_tangential(const double* x, double* y);
  void solve_normal(const double* x, double* y);

  Block tangential_, normal_;
  std::vector<double> across_[2];                        ///< directions across slip in the factorised tangential rows
  std::vector<std::int32_t> second_;                     ///< row of the second component there, -1: slides
  std::vector<std::int32_t> to_tangential_, to_normal_;  ///< position of each active node, or -1
  std::vector<std::int32_t> own_second_;                 ///< row of the second component in the present system
  std::vector<double> right_, found_, rest_;
  FreeSystem* system_ = nullptr;
  std::int64_t changed_ = 0;
};

}  // namespace rollcon
