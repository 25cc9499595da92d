#pragma once
/// Which tangential loads friction can carry under given pressures.
///
/// They are a convex set: sums over the nodes of load row times traction, |traction| <= mu p. In the direction of a
/// motion a = (a1, a2, a3) it reaches as far as h(a) = sum mu p |sum_m a_m row_m|, the power of friction when every
/// node slides. Loads T are in the set unless a motion exists whose power a.T is greater than h(a); on its boundary
/// every node slides and nothing tells how fast, so that has no steady solution either (docs/theory.md, section 2).

#include <array>
#include <vector>

#include "contact/problem/problem.hpp"

namespace rollcon {

/// Of the prescribed longitudinal and lateral force and spin moment; 1: the limit.
struct FrictionShare {
  double together = 0;  ///< over the greatest loads in the same ratio
  double force = 0;     ///< the forces alone
  double moment = 0;    ///< the spin moment alone
  /// The motion that tells `together`: power of the loads over that of nodes which slide with it. Differs from
  /// `together` as far as a node's motion is not that of its share of the frame.
  double sliding = 0;
  std::array<double, 3> direction{};         ///< that motion: longitudinal, lateral, spin times length
  bool by_force = false, by_moment = false;  ///< what is prescribed
  /// `together` is over the greatest load on the branch that begins with stick, under friction that falls with slip.
  bool before_fall = false;
};

/// Under the pressures of lambda. Where the normal load is given, they are scaled to it.
FrictionShare share_of_friction(const Problem& problem, const Prescribed& given,
                                const std::vector<double> (&lambda)[3]);
/// The forces alone, which takes no search.
double share_of_forces(const Problem& problem, const Prescribed& given, const std::vector<double> (&lambda)[3]);

/// Whether tractions carry the prescribed loads although friction under the integrated pressure cannot: nodes of
/// negative weight (corners of quad8) can do that.
bool friction_overdrawn(const Problem& problem, const Prescribed& given, const std::vector<double> (&lambda)[3]);

/// True when the normal part's residual and load are near those of the solution: what friction can carry may be judged
/// by these pressures.
bool pressures_settled(const Problem& problem, const Prescribed& given, const std::vector<double> (&lambda)[3],
                       double residual);
/// Whether the sum of mu p is known although pressures are still to change: the normal load is given, the frame flat,
/// and all nodes in contact have the same coefficient.
bool friction_sum_known(const Problem& problem, const Prescribed& given, const std::vector<double>& normal);

}  // namespace rollcon
