#include "contact/problem/law_residual.hpp"

#include <algorithm>

namespace rollcon {

double LawResidual::worst(Part part) const {
  double worst = load;
  if (has_normal(part)) worst = std::max(worst, normal);
  if (has_tangential(part)) worst = std::max(worst, tangential);
  return worst;
}

bool LawResidual::within(Part part, double tolerance) const {
  constexpr double useless = 1e-6;  // so much rounding leaves nothing to call a solution
  const auto small = [&](double residual, double rounding) {
    return residual <= std::max(tolerance, std::min(rounding, useless));
  };
  return load <= tolerance && (!has_normal(part) || small(normal, normal_rounding)) &&
         (!has_tangential(part) || small(tangential, tangential_rounding));
}

LawScales scales_of(const LawSums& s) {
  LawScales scales;
  scales.pressure = s.pressure > 0 ? s.pressure : s.worst_n;
  scales.traction = s.worst_t;
  // Tractions far below their bound are what rounding leaves of none.
  constexpr double nothing = 1e-9;
  if (s.traction > 0) scales.traction = s.bound > 0 ? std::clamp(s.traction, nothing * s.bound, s.bound) : s.traction;
  if (!(scales.pressure > 0)) scales.pressure = 1;
  if (!(scales.traction > 0)) scales.traction = 1;
  return scales;
}

double merit_of(const LawSums& s, const LawScales& scales, double load, std::int64_t nodes) {
  return 0.5 * (s.sum_n / (scales.pressure * scales.pressure) + s.sum_t / (scales.traction * scales.traction) +
                load * load * static_cast<double>(nodes));
}

LawResidual residual_of(const LawSums& s, const LawScales& scales, double load, std::int64_t nodes) {
  LawResidual r;
  r.normal = s.worst_n / scales.pressure;
  r.tangential = s.worst_t / scales.traction;
  r.load = load;
  // Rounding of gaps and slips alone makes this much of the tractions: no iteration gets below that.
  r.normal_rounding = rounding_of_terms * s.gap_rounding / scales.pressure;
  r.tangential_rounding = rounding_of_terms * (s.slip_rounding + s.bound_rounding) / scales.traction;
  r.merit = merit_of(s, scales, load, nodes);
  r.pressure = s.pressure;
  r.traction = s.traction;
  r.contact = s.contact;
  r.sliding = s.sliding;
  return r;
}

TangentialLaw linearise_friction(const Problem& p, const Prescribed& given, std::size_t k,
                                 const std::vector<double> (&lambda)[3], double s1, double s2, double pressure,
                                 bool bound_follows) {
  const double rt = given.slip_scale * p.rt[k];
  FrictionPoint point{given.coefficient(p.mu, k), pressure, lambda[0][k], lambda[1][k], s1, s2, rt, given.falling};
  p.count_from_touch(k, point);
  TangentialLaw law = p.law->linearise(point, bound_follows);
  if (point.rt == rt) return law;
  // The slip depends on the node's own traction over its pressure, too.
  const double per_traction = p.before_touch[k] / pressure * point.rt;
  for (std::size_t i = 0; i < 2; ++i) {
    const double along = law.slip[i][0] * point.t1 + law.slip[i][1] * point.t2;
    for (std::size_t c = 0; c < 2; ++c) {
      law.own[i][c] += law.slip[i][c] * per_traction;
      law.slip[i][c] *= point.rt / rt;
    }
    if (!bound_follows) continue;
    law.own[i][2] += along * per_traction / pressure;
    law.constant[i] -= along * per_traction;
  }
  return law;
}

}  // namespace rollcon
