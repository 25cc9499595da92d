#pragma once
/// Half-space integrals of bilinear hats on a lattice of rectangular cells: exact to rounding, the same for every
/// source, a function of the offset alone. Coordinates are along the lattice's axes.

#include <cstdint>
#include <vector>

#include "bodies/halfspace/kernels.hpp"
#include "bodies/halfspace/lattice_near.hpp"

namespace rollcon::halfspace {

/// The five integrals of kernels.hpp of a source at the origin for observers at
/// (shift_x + i dx, shift_y + j dy). Errors stay near 1e-15 of the largest integral, 1e-14 for slender cells.
class LatticeIntegrals {
 public:
  /// terms: which integrals are wanted. Takes time and memory in proportion to `reach` at most, however slender the
  /// cells.
  LatticeIntegrals(const LatticeHat& hat, double shift_x, double shift_y, int terms, OffsetReach reach);

  /// integral[k][m], m < count: observer (first + m, j). Unwanted integrals are left alone. May be called by several
  /// threads at once.
  void row(std::int64_t j, std::int64_t first, std::int64_t count, double* const (&integral)[integral_count]) const;

 private:
  struct Rule {
    std::vector<double> x, w;
  };
  void make_near();
  void far(double y, const double* x, std::int64_t count, std::int64_t at,
           double* const (&integral)[integral_count]) const;

  LatticeHat hat_;
  double shift_x_, shift_y_;
  int terms_;
  OffsetReach reach_;
  OffsetRange near_x_, near_y_;  ///< closed forms where both indices lie in these
  std::vector<double> near_[integral_count];
  double largest_ = 1;                 ///< integral 0 at the source
  std::vector<Rule> rule_x_, rule_y_;  ///< [n], n = 1 to max_hat_points
};

}  // namespace rollcon::halfspace
