#pragma once
/// Finds derivatives of the results of a solve, from Newton's system linearised at the solution with the state of every
/// node held (docs/theory.md, section 6). Each is computed when first asked for and kept until the next solve.

#include <vector>

#include "contact/derived.hpp"
#include "contact/newton/newton.hpp"
#include "contact/scene/enumerators.hpp"

namespace rollcon {

/// Linearises a solution and keeps the storage for that.
class RateFinder {
 public:
  /// Finds how a solution that converged or has no contact changes with a parameter; uses the factors of the `newton`
  /// that found it. err_state: a tangential load is prescribed where there is no friction; err_singular: the linearised
  /// system has no solution.
  const Rates& by(Parameter parameter, const Solution& solution, Newton& newton, Derived& derived);
  /// Finds how the solution changes where the nodes' givens change at these rates; the result is not kept.
  Rates by(const NodeGivens& rate, const Solution& solution, Newton& newton, Derived& derived);

 private:
  struct Change;
  void fill_right_side(const Solution& s, const ReducedSystem& system, const Change& change);
  void solve_part(const Solution& s, Newton& newton, Derived& derived, Part part, const Change& change, Rates& rates);
  void solve(const Solution& s, Newton& newton, Derived& derived, const Change& change, Rates& rates);
  void find(const Solution& s, Newton& newton, Derived& derived, const Change& change, Rates& rates);

  std::vector<double> lambda_[3];  ///< rates of the tractions
  std::vector<double> gap_, slip_[2], bound_[2], b_, x_;
};

}  // namespace rollcon
