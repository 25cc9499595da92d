#pragma once
/// Finds which tangential loads friction can carry under given pressures.
///
/// The loads are a convex set: sums over nodes of load row times traction, |traction| <= mu p. In the direction of a
/// motion a = (a1, a2, a3) it reaches as far as h(a) = sum mu p |sum_m a_m row_m|, the power of friction when every
/// node slides. Loads T are in the set unless a motion exists whose power a.T is greater than h(a); on its boundary
/// every node slides and nothing tells how fast, so that has no steady solution either (docs/theory.md, section 2).

#include <array>
#include <vector>

#include "contact/problem/problem.hpp"

namespace rollcon {

/// Tells how much of friction the prescribed forces and spin moment use; 1: the limit.
struct FrictionShare {
  double together = 0;  ///< utilisation by all loads, over the greatest ones in the same ratio
  double force = 0;     ///< utilisation by the forces alone
  double moment = 0;    ///< utilisation by the spin moment alone
  /// Power of the loads over that of nodes that slide with the motion that tells `together`. It differs from `together`
  /// as far as a node's motion is not that of its part of the frame.
  double sliding = 0;
  std::array<double, 3> direction{};         ///< that motion: longitudinal, lateral, spin times length
  bool by_force = false, by_moment = false;  ///< forces or moment are prescribed
  /// `together` is over the greatest load on the branch that begins with stick, under friction that falls with slip.
  bool before_fall = false;
};

/// Finds the utilisation under the pressures of lambda, scaled to the normal load where that is given.
FrictionShare share_of_friction(const Problem& problem, const Prescribed& given,
                                const std::vector<double> (&lambda)[3]);
/// Finds the utilisation by the forces alone, which takes no search.
double share_of_forces(const Problem& problem, const Prescribed& given, const std::vector<double> (&lambda)[3]);

/// Says whether tractions carry the prescribed loads although friction under the integrated pressure cannot: nodes of
/// negative weight (corners of quad8) can do that.
bool friction_overdrawn(const Problem& problem, const Prescribed& given, const std::vector<double> (&lambda)[3]);

/// Says whether the normal part's residual and load are near those of the solution, so that what friction can carry may
/// be judged by these pressures.
bool pressures_settled(const Problem& problem, const Prescribed& given, const std::vector<double> (&lambda)[3],
                       double residual);
/// Says whether the sum of mu p is known although pressures are still to change: the normal load is given, the frame
/// flat, and all nodes in contact have the same coefficient.
bool friction_sum_known(const Problem& problem, const Prescribed& given, const std::vector<double>& normal);

}  // namespace rollcon
