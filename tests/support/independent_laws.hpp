#pragma once
/// Recomputes the laws of contact from what a caller gave and what the public functions return: tractions, motions,
/// states, and displacements at points by rollcon_contact_get_displacements_at, which evaluates them from the tractions
/// and not from the matrices of the solver. Gap and slip fields of the library are not used (but see Given::gap); slip
/// comes from the displacements by the schemes of independent_schemes.hpp, signs of docs/theory.md, section 1.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "rollcon.h"
#include "support/independent_friction.hpp"
#include "support/independent_schemes.hpp"

namespace rollcon::laws {

/// Describes a step in time: material comes from `distance` upstream; if that is 0, the bodies are shifted, and what is
/// prescribed as creepages is the shift.
struct TimeStep {
  double distance = 0, dt = 1;
  std::vector<double> before;  ///< what displacements_before() returned; empty: the bodies were at rest
  std::vector<double> gap;     ///< field GAP after the step before, on the same nodes; empty: not known
};

/// Holds all that defines a contact except its bodies. Directions are in the order of ROLLCON_LONGITUDINAL, ...
struct Given {
  SurfaceMesh frame;
  Vec3 origin{0, 0, 0}, rolling{1, 0, 0}, normal{0, 0, 1};  ///< origin and directions of the axes
  std::vector<double> gap;                                  ///< gap of the undeformed bodies at each node
  std::optional<std::array<double, 3>> quadratic;           ///< a, b, c of the gap instead
  double speed = 1;
  std::array<bool, 4> by_force{};
  std::array<double, 4> value{};
  std::vector<double> friction{0.3};  ///< one coefficient, or one for each node
  Friction law;                       ///< law of which these are the greatest coefficients
  std::vector<double> creep_field;    ///< empty, or pairs for each node
  Scheme scheme = Scheme::characteristic;
  std::optional<TimeStep> in_time;
  double layer = 0;      ///< shear of a layer between the bodies, as displacement over traction, which slip has
  double step = 0.6;     ///< step of the characteristic scheme, over the spacing
  bool regular = false;  ///< a full grid of equal quad4 cells, 3 x 3 nodes or more
  double rounding = 64;  ///< rounding in eps, allowed of the terms that gaps and slips are differences of
  /// Local (t1, t2, n) of each node of a curved frame in the axes, as rows (surface_triads). With neither gap nor
  /// quadratic the bodies have meshes, and the undeformed gap is concluded from the field GAP (no check of its own
  /// then).
  std::vector<std::array<Vec3, 3>> triad;
};

/// Holds the greatest errors, all relative. They are over the largest pressure p0, the largest mu p q0, the largest
/// normal displacement of the bodies u0 (not less than the largest overlap), and the largest slip velocity in contact
/// s0: rigid, elastic, or what tractions of the size found would cause, whichever is greatest. All come from the same
/// solution, so they have a meaning at any creepage, friction and stiffness.
struct Laws {
  double tension = 0;      ///< -p / p0
  double penetration = 0;  ///< -gap / u0
  double separation = 0;   ///< lesser of p / p0 and |gap| / u0: pressure times gap
  double bound = 0;        ///< (|q| - mu p) / q0; at slipping nodes its magnitude
  /// Friction errors are the lesser of what slip (over s0) and what traction (over q0) would have to change.
  double stick = 0;        ///< at sticking nodes: slip, or the difference from the traction of such a slip
  double direction = 0;    ///< at slipping nodes: slip across or along the traction, or the difference from the
                           ///< traction of such a slip
  double equilibrium = 0;  ///< sums of weight times traction against resultant and given forces
  double motion = 0;       ///< approach and creepages against those prescribed
  bool finite = true;      ///< no NaN and no infinity in any result
  /// Differences of the fields GAP and SLIP from those recomputed, over u0 and s0, for information.
  double gap_field = 0, slip_field = 0;
  double turn = 0;  ///< greatest angle of a normal in contact with the axes' (radian)
  std::int64_t contact = 0, sticking = 0, checked = 0;  ///< numbers of nodes; `checked` had gap and slip looked at

  double worst() const;
  const char* worst_name() const;
};

/// Returns u1 - u2 under the tractions of the last solve at the points of the surface from which the particles at the
/// nodes will have come after so long a way: three for each node.
std::vector<double> displacements_before(const rollcon_contact* contact, const Given& given, double distance);

/// Checks the last solve, whose status is not negative. Frames of more nodes than most_nodes are sampled: so many nodes
/// in contact and around. Throws std::runtime_error if a call fails. Rounding is allowed for by Given::rounding.
Laws check(const rollcon_contact* contact, const Given& given, std::size_t most_nodes = 600);

}  // namespace rollcon::laws
