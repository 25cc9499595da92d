#pragma once
/// Describes a step of the generalised Newton method, (63) and (86): what it starts from, what it linearises and what
/// it costs.

#include <array>
#include <cstdint>
#include <vector>

#include "contact/laws/friction_law.hpp"
#include "contact/problem/prescribed.hpp"

namespace rollcon {

enum class PairState : std::uint8_t { unused, open, stick, slip };

/// Is an iterate z of the method: tractions and what they do, at all nodes of the frame.
struct Point {
  std::vector<double> lambda[3];  ///< tractions t1, t2, n
  std::vector<double> slip[2];    ///< D (A lambda)_t: slip over speed less the rigid slip
  std::vector<double> depth;      ///< (A lambda)_n: minus the gap lost to elastic displacements
  std::vector<double> shift[2];   ///< (A lambda)_t; filled for reduced unknowns only, else empty
  MotionValues motion{};          ///< xi1, xi2, approach, spin in the order of Problem
  std::vector<double> inner;      ///< unknowns of the bodies, where they are written out
};

/// Sets z to z + alpha (next - z), (87).
void blend(Point& z, const Point& next, double alpha);

/// Holds what the step linearises, by node of the frame.
///
/// open:  lambda = 0
/// stick and slip, normal:  rigid gap - depth = 0 (Problem::rigid_gap)
/// stick and slip, tangential:  own lambda + slip (rt s) = 0, `law` (friction_law.hpp), with
///   s = rigid slip + D (A lambda)_t and rt of Problem
/// Reduced unknowns (section 11.8): a stick pair has instead
///   (A lambda)_t + reach * (slip columns of the unknown creepages) = target,
/// which (90)-(92) give from the last iterate.
struct Step {
  Prescribed given;
  std::vector<PairState> state;
  std::vector<TangentialLaw> law;
  std::vector<double> target[2];
  std::vector<double> reach;  ///< length over slip per unit speed; positive at stick pairs
};

struct StepCounters {
  std::int64_t unknowns = 0;        ///< unknowns of the last system
  std::int64_t nonzeros = 0;        ///< nonzeros of its matrix (dense: unknowns squared)
  std::int64_t factorizations = 0;  ///< factorisations of systems and bodies, since construction
  std::int64_t iterations = 0;      ///< Krylov iterations, since construction
  double seconds = 0;               ///< in linear algebra, matrices included
  std::size_t bytes = 0;            ///< bytes held now
};

}  // namespace rollcon
