#pragma once
/// Defines the discrete contact problem in the form that Newton's iteration sees: affine relations between tractions,
/// gap and slip, laws per node, and loads. Slip is per unit rolling speed throughout.
///
///   kn = gap - approach n - (tilt x r) n - (A lambda)_n
///   s  = rigid slip + D (A lambda)_t,   rigid slip = (xi1 - phi y, xi2 + phi x) + given field
///
/// On a curved frame tractions, slip and gap belong to the local triads of the nodes, motions and loads to the axes: n
/// is then the cosine between both normals (1 on a flat frame), the creepages are projected on the local tangent plane,
/// and the load rows are the same columns transposed times the nodes' weights.
///
/// In a time step slip is the shift of a particle over that step, motions count by the distance rolled (shifts: by 1),
/// D leaves displacements as they are, and the given field takes away those of the step before (docs/time.md).

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "contact/convection/convection.hpp"
#include "contact/laws/friction_law.hpp"
#include "contact/operators/operators.hpp"
#include "contact/problem/prescribed.hpp"

namespace rollcon {

/// Holds the local triad of a node in the axes: [i][j] = local direction i times axis j (t1, t2, n).
using Turn = std::array<std::array<double, 3>, 3>;

struct Problem {
  std::int64_t nodes = 0;
  std::shared_ptr<const Operators> op;
  Convection convection;
  std::vector<double> rn, rt;  ///< scales of the augmented tractions, per node
  std::vector<Turn> turn;      ///< empty: the frame is flat
  /// Gap at the approach `datum`, displacements given elsewhere included. Approaches of a problem and its iterates
  /// count from the datum: where it is the least of those that touch, the overlap under the smallest load keeps its
  /// digits.
  std::vector<double> gap;
  double datum = 0;
  const FrictionLaw* law = &coulomb();
  std::shared_ptr<const FrictionLaw> own_law;  ///< `law`, where it has parameters
  /// Friction coefficient; 0 at nodes without an upstream neighbour (the inflow rim), whose slip does not depend on any
  /// traction: material enters the frame unstressed.
  std::vector<double> mu;
  /// Slip over speed that no motion and no traction changes: given field, displacements given elsewhere. Empty: none.
  std::vector<double> slip1, slip2;
  /// Shift that a node's particle makes within a time step before it touches, under a traction that equals its pressure
  /// (docs/time.md). Empty: all particles touched before.
  std::vector<double> before_touch;
  std::vector<double> weight;              ///< integral of N_i: force from tractions
  std::vector<double> moment_x, moment_y;  ///< integrals of N_i x and N_i y: spin moment
  std::vector<double> moment_z;            ///< integral of N_i z
  std::vector<double> tilting[2];          ///< gap lost per unit of a tilt
  std::vector<std::uint8_t> used;          ///< nodes that may carry traction
  double length = 1;                       ///< length of the frame; scales spin
  double motion_scale = 1;                 ///< slip per unit of a creepage
  double stiffness = 1;                    ///< E* of the pair, for the first guess of an approach
  std::vector<double> cell_area;

  double rigid_slip1(std::int64_t i, const MotionValues& m) const {
    return motion_slip(0, i, m) + (slip1.empty() ? 0 : slip1[static_cast<std::size_t>(i)]);
  }
  double rigid_slip2(std::int64_t i, const MotionValues& m) const {
    return motion_slip(1, i, m) + (slip2.empty() ? 0 : slip2[static_cast<std::size_t>(i)]);
  }
  /// Returns the part of component c that motions cause.
  double motion_slip(std::size_t c, std::int64_t i, const MotionValues& m) const {
    const auto k = static_cast<std::size_t>(i);
    const double along = motion_scale * (m[xi1] - m[spin] * convection.slip_y[k]);
    const double across = motion_scale * (m[xi2] + m[spin] * convection.slip_x[k]);
    if (turn.empty()) return c == 0 ? along : across;
    return turn[k][c][0] * along + turn[k][c][1] * across;
  }
  /// Makes the slip of node k that since its particle touched; the scale falls with what its tractions now change.
  void count_from_touch(std::size_t k, FrictionPoint& point) const {
    if (before_touch.empty() || !(before_touch[k] > 0) || !(point.pressure > 0)) return;
    const double per_traction = before_touch[k] / point.pressure;
    point.s1 += per_traction * point.t1;
    point.s2 += per_traction * point.t2;
    point.rt /= 1 + per_traction * point.rt;
  }
  /// Returns the gap lost per unit of approach.
  double closing(std::size_t k) const { return turn.empty() ? 1 : turn[k][2][2]; }
  /// Returns the gap lost per unit of any motion.
  double closing(int motion, std::size_t k) const {
    return motion >= tilt1 ? tilting[motion - tilt1][k] : motion == approach ? closing(k) : 0;
  }
  double rigid_gap(std::size_t k, const MotionValues& m) const { return tilted_gap(k, m) - closing(k) * m[approach]; }
  /// Returns the gap at the approach `datum`.
  double tilted_gap(std::size_t k, const MotionValues& m) const {
    if (m[tilt1] == 0 && m[tilt2] == 0) return gap[k];
    return gap[k] - tilting[0][k] * m[tilt1] - tilting[1][k] * m[tilt2];
  }
  /// Returns the gaps at no approach.
  std::vector<double> undeformed_gaps() const;
  /// Returns the slip of node k per unit of a motion (zero for those that change the gap).
  std::array<double, 2> slip_column(int motion, std::size_t k) const;
  /// Returns the load on body 1 (see LoadSum) per unit of the node's tractions.
  std::array<double, 3> load_row(int motion, std::size_t k) const;
};

/// Takes what depends on the frame alone: weights, moments, areas, local triads.
void take_frame(Problem& problem, const Frame& frame);

/// Takes weights and moments of a frame with strips, which take_frame() took before.
void take_strips(Problem& problem, const Frame& frame);

/// Holds an iterate: tractions by component, the operator rows applied to them, and the motions.
struct Iterate {
  std::vector<double> lambda[3];  ///< t1, t2, n
  // The mutable members follow from the tractions and are found when they are needed.
  mutable std::vector<double> image[3];          ///< D (A lambda)_t1, D (A lambda)_t2, (A lambda)_n
  mutable std::vector<std::uint8_t> slip_valid;  ///< image[0], image[1] up to date at this node
  mutable std::vector<std::uint8_t> gap_valid;   ///< image[2] up to date at this node
  MotionValues motion{};

  void resize(std::int64_t n);  ///< zero tractions and motions
  void clear();                 ///< sets tractions and motions to zero
  void invalidate();            ///< makes images unknown at all nodes
  /// Sets tractions to zero; motions stay.
  void clear_tractions();
  /// Compute the wanted image rows of one node from the tractions.
  void update_slip(const Problem& problem, std::int64_t i) const;
  void update_gap(const Problem& problem, std::int64_t i) const;

 private:
  void update(const Problem& problem, Components wanted, std::int64_t i) const;
};

/// Returns the rows of the part's laws.
inline Components components_of(Part part) {
  return {has_tangential(part) ? 0 : 2, has_normal(part) ? 2 : 1};
}

/// Holds a load on body 1 that tractions add up to (the compressive load for the approach), and the sum of its terms'
/// magnitudes.
struct LoadSum {
  double value = 0, magnitude = 0;
};
LoadSum load_on_body1(const Problem& problem, int motion, const std::vector<double> (&lambda)[3]);
/// Returns the largest relative error of the part's prescribed loads; sum_of: a motion's LoadSum.
template <class SumOf>
double load_error(const Prescribed& given, Part part, SumOf sum_of) {
  double worst = 0;
  for (int m = 0; m < int{motion_count}; ++m) {
    const double wanted = given.value[static_cast<std::size_t>(m)];
    if (!given.by_force[static_cast<std::size_t>(m)] || !has_motion(part, m)) continue;
    const LoadSum sum = sum_of(m);
    const double scale = std::max(sum.magnitude, std::abs(wanted));
    if (scale > 0) worst = std::max(worst, std::abs(sum.value - wanted) / scale);
  }
  return worst;
}
double load_error(const Problem& problem, const Prescribed& given, Part part, const std::vector<double> (&lambda)[3]);
/// Returns the part of a tangential load (or spin moment) that normal tractions carry: none on flat frames.
double load_of_pressures(const Problem& problem, int motion, const std::vector<double>& normal);

/// Sums force on body 1 and its moment about the origin, in the axes, from tractions at the nodes.
void sum_tractions(const Problem& problem, const std::vector<double> (&lambda)[3], Vec3& force, Vec3& moment);

/// Sets rn = 1/diagonal of the normal compliance; rt = 1/(2-norm of the node's slip rows) (docs/theory.md, section 2).
/// A node whose rows vanish gets the mean of the others.
void set_scales(Problem& problem);
/// Sets the scales of half-spaces on cells of the frame's size, without a look at any operator, so that both forms of
/// the published system walk the same path.
void estimate_scales(Problem& problem);

}  // namespace rollcon
