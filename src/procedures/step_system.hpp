#pragma once
/// The linear system of one step of the generalised Newton method, (63) and (86), in either form:
/// the bodies' unknowns eliminated (condensed) or written out (monolithic).

#include <array>
#include <cstdint>
#include <vector>

#include "contact/laws/friction_law.hpp"
#include "contact/problem/problem.hpp"
#include "contact/scene/linear_method.hpp"

namespace rollcon {

enum class PairState : std::uint8_t { unused, open, stick, slip };

/// An iterate z of the method: tractions and what they do, at all nodes of the frame.
struct Point {
  std::vector<double> lambda[3];   ///< tractions t1, t2, n
  std::vector<double> slip[2];     ///< D (A lambda)_t: slip over speed less the rigid slip
  std::vector<double> depth;       ///< (A lambda)_n: gap lost to elastic displacements is minus it
  std::vector<double> shift[2];    ///< (A lambda)_t; kept for reduced unknowns only, else empty
  std::array<double, 4> motion{};  ///< as in Problem: xi1, xi2, approach, spin
  std::vector<double> inner;       ///< unknowns of the bodies; monolithic form only
};

/// z + alpha (next - z), (87).
void blend(Point& z, const Point& next, double alpha);

/// What the step linearises, by node of the frame.
///
/// open:  lambda = 0
/// stick and slip, normal:  rigid gap - depth = 0 (Problem::rigid_gap)
/// stick and slip, tangential:  own lambda + slip (rt s) = constant, `law` (coulomb.hpp), with
///   s = rigid slip + D (A lambda)_t and rt of Problem
/// Reduced unknowns (section 11.8), `estimated`: a stick pair has instead
///   (A lambda)_t + reach * (slip columns of the unknown creepages) = target,
/// which (90)-(92) give from the last iterate, and laws of slip pairs have no slip in them
/// (own = (1, 0, mu e1; 0, 1, mu e2)): slip pairs then have one unknown traction, not three.
struct Step {
  bool tangential = true;  ///< false: no friction anywhere, normal rows and tractions alone
  std::vector<PairState> state;
  std::vector<TangentialLaw> law;
  bool estimated = false;
  std::vector<double> target[2];
  std::vector<double> reach;  ///< length over slip per unit speed; positive at stick pairs
};

struct StepCounters {
  std::int64_t unknowns = 0;        ///< of the last system
  std::int64_t nonzeros = 0;        ///< of its matrix (dense: unknowns squared)
  std::int64_t factorizations = 0;  ///< of systems, since construction
  std::int64_t iterations = 0;      ///< Krylov, since construction
  double seconds_matrix = 0;        ///< putting matrices together
  double seconds = 0;               ///< in linear algebra, matrices included
  std::size_t bytes = 0;            ///< held now
};

enum class StepSolver { lu, gmres };

class StepSystem {
 public:
  virtual ~StepSystem() = default;
  /// The next iterate for a full step: directly, or by GMRES to
  /// ||J (next - z) + H(z)|| <= eta ||H(z)||, (71), with rows scaled to the units of tractions.
  /// False: singular to working precision.
  virtual bool solve(const Step& step, const Point& z, double eta, Point& next) = 0;
  /// Computes slip, depth, shift (and inner) of the tractions of z.
  virtual void update(Point& z) = 0;
  /// Norm, in units of traction, of what the equations that no law is part of (the bodies', the
  /// displacements', the slip's) leave at z: an iterative solution satisfies them only so far.
  virtual double imbalance(const Point& /*z*/) { return 0; }
  virtual StepCounters counters() const = 0;
};

}  // namespace rollcon
