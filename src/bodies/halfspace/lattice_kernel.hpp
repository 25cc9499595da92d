#pragma once
/// Computes half-space integrals of bilinear hats on a lattice of rectangular cells: exact to rounding, the same for
/// every source, a function of the offset alone. Coordinates are along the lattice's axes.

#include <cstdint>
#include <vector>

#include "bodies/halfspace/kernels.hpp"
#include "bodies/halfspace/lattice_near.hpp"

namespace rollcon::halfspace {

/// Gives the five integrals of kernels.hpp of a source at the origin for observers at (shift_x + i dx, shift_y + j dy).
/// Errors stay near 1e-15 of the largest integral, 1e-14 for slender cells.
class LatticeIntegrals {
 public:
  /// Prepares the integrals that `terms` wants, in time and memory in proportion to `reach` at most, however slender
  /// the cells are. accuracy: error of rules over the largest integral.
  LatticeIntegrals(const LatticeHat& hat, double shift_x, double shift_y, int terms, OffsetReach reach,
                   double accuracy = 3e-16);

  /// Fills integral[k][m], m < count, for observers (first + m, j), and leaves integrals alone that are not among those
  /// of `terms`. Safe for several threads.
  void row(std::int64_t j, std::int64_t first, std::int64_t count, double* const (&integral)[integral_count],
           int terms = all_terms) const;

  /// Sets integral[k][0] for an observer at x, which shifts nothing, on line j.
  void at_place(double x, std::int64_t j, double* const (&integral)[integral_count], int terms = all_terms) const;

 private:
  struct Rule {
    std::vector<double> x, w;
  };
  void make_near();
  void far(double y, const double* x, std::int64_t count, std::int64_t at, double* const (&integral)[integral_count],
           int terms) const;

  LatticeHat hat_;
  double shift_x_, shift_y_;
  int terms_;
  OffsetReach reach_;
  double accuracy_;
  OffsetRange near_x_, near_y_;  ///< ranges of both indices with closed forms
  std::vector<double> near_[integral_count];
  double largest_ = 1;                 ///< value of integral 0 at the source
  std::vector<Rule> rule_x_, rule_y_;  ///< rules by their n points, 1 to max_hat_points
};

}  // namespace rollcon::halfspace
