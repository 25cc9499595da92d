#pragma once
/// Solves Hertzian contacts of one shape on two frames of strips and extrapolates them.

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>

#include "contact/solver.hpp"
#include "tables/table_grid.hpp"

namespace rollcon {

class RollingSampler {
 public:
  /// Samples equal bodies of shear modulus 1, semi-axes sqrt(ratio) and 1 / sqrt(ratio). fine: with the finer frame.
  RollingSampler(double ratio, double poisson, std::int64_t along, std::int64_t across, bool fine = true);
  /// Samples unlike bodies whose flexibilities have the mean 1.
  RollingSampler(double ratio, const UnlikePair& pair, double friction, std::int64_t along, std::int64_t across);
  /// Holds forces and moment over mu Fn.
  struct Forces {
    std::array<double, 3> extrapolated, coarse;  ///< coarse: without the finer frame
  };
  /// Solves for creepages over mu Fn / (G a b).
  Forces solve(const std::array<double, 3>& creepage);
  /// Forgets warm starts.
  void reset();

 private:
  void make(double ratio, const UnlikePair& pair, double friction, std::int64_t along, std::int64_t across, bool fine);
  std::array<double, 3> solve_on(Solver& solver, const std::array<double, 3>& creepage);

  double bound_ = 0;  ///< mu Fn
  std::shared_ptr<Context> context_;
  std::unique_ptr<std::atomic<bool>> cancel_;  ///< never set
  std::unique_ptr<Solver> fine_, coarse_;      ///< fine_ may be null
};

}  // namespace rollcon
