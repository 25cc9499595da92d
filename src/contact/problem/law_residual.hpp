#pragma once
/// Evaluates the residual of the laws, written once: unilateral contact and friction as projections of the augmented
/// tractions (docs/theory.md, section 6).

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "contact/laws/friction_law.hpp"
#include "contact/problem/problem.hpp"

namespace rollcon {

/// Relative rounding of the terms that gaps and slips are summed from.
inline constexpr double rounding_of_terms = 8 * std::numeric_limits<double>::epsilon();

/// Holds a gap or a slip, and the size of the terms it is summed from.
struct SummedGap {
  double value = 0, terms = 0;
};
struct SummedSlip {
  double s1 = 0, s2 = 0, terms = 0;
};

/// Holds greatest values and sums of squares, over the nodes, of what the laws leave.
struct LawSums {
  double worst_n = 0, worst_t = 0, sum_n = 0, sum_t = 0;
  double pressure = 0, traction = 0, bound = 0;                    ///< greatest values
  double gap_rounding = 0, slip_rounding = 0, bound_rounding = 0;  ///< rounding of the terms, as tractions
  std::int64_t contact = 0, sliding = 0;
};

/// Holds what residuals are relative to.
struct LawScales {
  double pressure = 1, traction = 1;
};

/// Holds relative residuals.
struct LawResidual {
  double normal = 0, tangential = 0, load = 0;          ///< relative maxima
  double normal_rounding = 0, tangential_rounding = 0;  ///< what rounding leaves of them
  double merit = 0;                   ///< error function Psi: half the squared norm of the relative residuals
  double pressure = 0, traction = 0;  ///< largest values
  std::int64_t contact = 0, sliding = 0;

  double worst(Part part) const;
  /// Says whether residuals are within the tolerance, or within what rounding leaves.
  bool within(Part part, double tolerance) const;
};

/// Sums what the laws leave. `at` gives a node's values: lambda(c, k), gap(k) -> SummedGap, slip(k) -> SummedSlip and
/// slip_known(k); gaps are asked for if the part has normal tractions, slips of nodes that touch. `visit` hears of each
/// used node, whether it touches and slides. Where Values::trial is true, sums of squares do for tangential laws.
template <class Values, class Visit>
LawSums sum_laws(const Problem& p, const Prescribed& given, Part part, Values&& at, Visit&& visit) {
  constexpr bool trial = std::remove_cvref_t<Values>::trial;
  LawSums r;
  const FrictionLaw& friction = *p.law;
  for (std::size_t k = 0; k < static_cast<std::size_t>(p.nodes); ++k) {
    if (!p.used[k]) continue;
    const double ln = at.lambda(2, k);
    double augmented = ln, gap_terms = 0;
    if (has_normal(part)) {
      const SummedGap gap = at.gap(k);
      augmented = ln + p.rn[k] * gap.value;
      const double rest = ln - std::min(augmented, 0.0);
      r.worst_n = std::max(r.worst_n, std::abs(rest));
      r.sum_n += rest * rest;
      gap_terms = p.rn[k] * gap.terms;
    }
    r.pressure = std::max(r.pressure, -ln);
    const bool touching = augmented < 0;
    bool sliding = false;
    if (touching) {
      ++r.contact;
      r.gap_rounding = std::max(r.gap_rounding, gap_terms);
    }
    if (has_tangential(part)) {
      const double l1 = at.lambda(0, k), l2 = at.lambda(1, k);
      FrictionTraction t{};
      if (touching && at.slip_known(k)) {
        const double rt = given.slip_scale * p.rt[k], mu = given.coefficient(p.mu, k);
        const SummedSlip s = at.slip(k);
        FrictionPoint point{mu, -augmented, l1, l2, s.s1, s.s2, rt, given.falling};
        p.count_from_touch(k, point);
        t = friction.traction(point);
        sliding = t.sliding;
        if constexpr (!trial) {
          // Only the part across the traction counts where nodes slide; it shrinks with the bound.
          const double share = t.length > t.bound ? t.bound / t.length : 1;
          r.slip_rounding = std::max(r.slip_rounding, share * rt * s.terms);
          r.bound_rounding = std::max(r.bound_rounding, mu * gap_terms);
          r.bound = std::max(r.bound, t.bound);
          r.sliding += sliding;
        }
      }
      const double d1 = l1 - t.t1, d2 = l2 - t.t2;
      r.sum_t += d1 * d1 + d2 * d2;
      if constexpr (!trial) {
        r.traction = std::max(r.traction, std::hypot(l1, l2));
        r.worst_t = std::max(r.worst_t, std::hypot(d1, d2));
      }
    }
    visit(k, touching, sliding);
  }
  return r;
}

/// Returns the scales. Tangential residuals hide under normal ones, so they are judged by the tangential tractions
/// themselves as soon as there are any.
LawScales scales_of(const LawSums& sums);
/// Returns Psi. load: greatest relative error of a load, taken as that of the traction at each of `nodes` nodes.
double merit_of(const LawSums& sums, const LawScales& scales, double load, std::int64_t nodes);
LawResidual residual_of(const LawSums& sums, const LawScales& scales, double load, std::int64_t nodes);

/// Returns the law of node k for a step; pressure: what bounds its friction.
TangentialLaw linearise_friction(const Problem& p, const Prescribed& given, std::size_t k,
                                 const std::vector<double> (&lambda)[3], double s1, double s2, double pressure,
                                 bool bound_follows);

}  // namespace rollcon
