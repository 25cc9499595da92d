#include "contact/results/statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/estimate/error_estimate.hpp"
#include "contact/estimate/few_nodes.hpp"
#include "contact/prepare/preparation.hpp"
#include "contact/results/condition.hpp"
#include "contact/results/power.hpp"
#include "contact/scene/geometry.hpp"
#include "contact/solution.hpp"

namespace rollcon {
namespace {

double count_status(SolverState& s, NodeStatus wanted) {
  derive_fields(s);
  return static_cast<double>(std::count(s.status.begin(), s.status.end(), static_cast<std::int32_t>(wanted)));
}

template <class Term>
double sum_in_contact(SolverState& s, Term term) {
  double sum = 0;
  for (std::size_t k = 0; k < s.prepared->problem.gap.size(); ++k)
    if (s.iterate.lambda[2][k] < 0) sum += term(k);
  return sum;
}

double law(SolverState& s, std::size_t which) {
  check_laws(s);
  return s.laws[which];
}

double number(std::int64_t v) {
  return static_cast<double>(v);
}

// Nodes whose state would change if their augmented traction moved by 1e-6 of the largest.
double near_change(SolverState& s) {
  derive_fields(s);
  const Problem& p = s.prepared->problem;
  const Iterate& it = s.iterate;
  double pressure = 0, bound = 0;
  for (std::size_t k = 0; k < p.gap.size(); ++k) {
    pressure = std::max(pressure, -it.lambda[2][k]);
    bound = std::max(bound, -s.given.coefficient(p.mu, k) * it.lambda[2][k]);
  }
  double count = 0;
  for (std::size_t k = 0; k < p.gap.size(); ++k) {
    if (!p.used[k]) continue;
    const double augmented = it.lambda[2][k] + p.rn[k] * s.gap[k];
    bool near = std::abs(augmented) < 1e-6 * pressure;
    if (!near && augmented < 0 && !s.frictionless) {
      const double s1 = s.slip[0][k] / s.prepared->speed, s2 = s.slip[1][k] / s.prepared->speed;
      const FrictionTraction t = p.law->traction(
          {s.given.coefficient(p.mu, k), -augmented, it.lambda[0][k], it.lambda[1][k], s1, s2, p.rt[k]});
      near = std::abs(t.length - t.bound) < 1e-6 * bound;
    }
    count += near;
  }
  return count;
}

// Solves with given coefficients, where friction follows the whole solution.
std::int64_t rounds_of_friction(const SolverState& s) {
  return s.frictionless || !s.prepared->problem.law->of_field() ? 0 : s.settled_friction.rounds;
}

// Force times creepage, without the spin.
double t_gamma(SolverState& s) {
  Vec3 force, moment;
  MotionValues motion = s.iterate.motion;
  if (s.extrapolated)
    force = s.extrapolated->force, motion = s.extrapolated->motion;
  else
    sum_tractions(s.prepared->problem, s.iterate.lambda, force, moment);
  return -(force[0] * motion[xi1] + force[1] * motion[xi2]);
}

// The part of the contact's area that came into contact within a step without rolling.
double step_growth(SolverState& s) {
  const auto area = [](const PastStep& past) {
    double sum = 0;
    for (std::size_t k = 0; past.loaded && past.on && k < past.lambda[2].size(); ++k)
      if (past.lambda[2][k] < 0) sum += past.on->frame.cell_area[k];
    return sum;
  };
  const double now = area(s.steps.last);
  return s.prepared->step == StepKind::shift && now > 0 ? std::max(0.0, 1 - area(s.steps.before) / now) : 0;
}

constexpr Statistic table[] = {
    {"iterations",
     [](SolverState& s) {
       return number(s.report.normal_iterations + s.report.tangential_iterations + s.report.full_iterations);
     },
     true},
    {"normal_iterations", [](SolverState& s) { return number(s.report.normal_iterations); }},
    {"tangential_iterations", [](SolverState& s) { return number(s.report.tangential_iterations); }},
    {"full_iterations", [](SolverState& s) { return number(s.report.full_iterations); }},
    {"fallbacks", [](SolverState& s) { return number(s.report.fallbacks); }, true},
    {"friction_rounds", [](SolverState& s) { return number(rounds_of_friction(s)); }},
    {"friction_change", [](SolverState& s) { return rounds_of_friction(s) > 0 ? s.settled_friction.change : 0.0; }},
    {"predictions", [](SolverState& s) { return number(s.report.predictions); }},
    {"linear_iterations", [](SolverState& s) { return number(s.linear_iterations); }},
    {"factorizations", [](SolverState& s) { return number(s.factorizations); }},
    {"residual_normal", [](SolverState& s) { return s.report.residual_normal; }, true},
    {"residual_tangential", [](SolverState& s) { return s.report.residual_tangential; }, true},
    {"condition", [](SolverState& s) { return find_condition(s); }},
    {"law_normal", [](SolverState& s) { return law(s, 0); }},
    {"law_friction", [](SolverState& s) { return law(s, 1); }},
    {"law_slip", [](SolverState& s) { return law(s, 2); }},
    {"law_equilibrium", [](SolverState& s) { return law(s, 3); }},
    {"error_estimate", [](SolverState& s) { return find_error_estimate(s).worst(); }},
    {"error_estimate_normal", [](SolverState& s) { return find_error_estimate(s).normal; }},
    {"error_estimate_tangential", [](SolverState& s) { return find_error_estimate(s).tangential; }},
    {"error_estimate_tractions", [](SolverState& s) { return find_error_estimate(s).tractions; }},
    {"nodes_contact", [](SolverState& s) { return sum_in_contact(s, [](std::size_t) { return 1.0; }); }, true},
    {"nodes_inside", [](SolverState& s) { return number(nodes_inside(s)); }},
    {"nodes_stick", [](SolverState& s) { return count_status(s, NodeStatus::stick); }},
    {"nodes_slip", [](SolverState& s) { return count_status(s, NodeStatus::slip); }},
    {"nodes_rim",
     [](SolverState& s) {
       return sum_in_contact(s, [&](std::size_t k) { return s.prepared->frame.rim[k] ? 1.0 : 0.0; });
     }},
    {"nodes_near_change", near_change},
    {"nodes_overlap",
     [](SolverState& s) {
       return number(initial_overlap(s.prepared->frame, s.prepared->problem.undeformed_gaps()).nodes);
     }},
    {"overlap_depth",
     [](SolverState& s) { return initial_overlap(s.prepared->frame, s.prepared->problem.undeformed_gaps()).depth; }},
    {"contact_area",
     [](SolverState& s) {
       if (s.extrapolated) return s.extrapolated->area;
       return sum_in_contact(s, [&](std::size_t k) { return s.prepared->problem.cell_area[k]; });
     },
     true},
    {"friction_power", [](SolverState& s) { return power_at_nodes(s); }, true},
    {"friction_power_balance", [](SolverState& s) { return power_put_in(s); }, true},
    {"t_gamma", t_gamma},
    {"rolling_speed",
     [](SolverState& s) {
       const Prepared& on = *s.prepared;
       return on.step == StepKind::steady ? on.speed : on.distance * on.speed;
     }},
    {"step_time", [](SolverState& s) { return s.steps.last.time; }},
    {"steps", [](SolverState& s) { return number(s.steps.last.steps); }},
    {"step_distance", [](SolverState& s) { return s.prepared->distance; }},
    {"step_growth", step_growth},
    {"step_row_builds", [](SolverState& s) { return number(s.preparation ? s.preparation->carried.made() : 0); }},
    {"max_pressure",
     [](SolverState& s) {
       return std::max(0.0, -*std::min_element(s.iterate.lambda[2].begin(), s.iterate.lambda[2].end()));
     },
     true},
    {"seconds_compliance", [](SolverState& s) { return s.timings.compliance; }},
    {"seconds_convection", [](SolverState& s) { return s.timings.convection; }},
    {"seconds_newton", [](SolverState& s) { return s.timings.newton; }},
    {"seconds_linear", [](SolverState& s) { return s.timings.linear; }},
    {"seconds_total", [](SolverState& s) { return s.timings.total; }},
    {"seconds_sensitivity", [](SolverState& s) { return s.sensitivities.seconds; }},
    {"sensitivity_right_sides", [](SolverState& s) { return number(s.sensitivities.right_sides); }},
    {"sensitivity_factorizations", [](SolverState& s) { return number(s.sensitivities.factorizations); }},
    {"sensitivity_linear_iterations", [](SolverState& s) { return number(s.sensitivities.linear_iterations); }},
    {"seconds_error_estimate", [](SolverState& s) { return s.error_estimate.seconds; }},
    {"peak_bytes", [](SolverState& s) { return static_cast<double>(s.peak_bytes); }},
    {"threads", [](SolverState& s) { return number(s.threads); }},
    {"kernel_evaluations",
     [](SolverState& s) {
       return s.prepared->compliance ? number(s.prepared->compliance->kernel_evaluations()) : 0.0;
     }},
    {"compliance_assemblies", [](SolverState& s) { return number(s.assemblies); }},
    {"system_unknowns", [](SolverState& s) { return number(s.system_unknowns); }},
    {"system_nonzeros", [](SolverState& s) { return number(s.system_nonzeros); }},
    {"operator_bytes", [](SolverState& s) { return static_cast<double>(s.prepared->problem.op->bytes()); }},
    {"operator_applications",
     [](SolverState& s) { return number(s.work.applications + s.prepared->problem.op->applications()); }},
    {"right_sides", [](SolverState& s) { return number(s.right_sides); }},
    {"body_preparations", [](SolverState& s) { return number(s.work.bodies); }},
    {"frame_builds", [](SolverState& s) { return number(s.work.frames); }},
    {"compliance_builds", [](SolverState& s) { return number(s.work.compliances); }},
    {"stencil_builds", [](SolverState& s) { return number(s.work.stencils); }},
    {"gap_builds", [](SolverState& s) { return number(s.work.gaps); }},
    {"friction_builds", [](SolverState& s) { return number(s.work.frictions); }},
    {"slip_builds", [](SolverState& s) { return number(s.work.slips); }},
    {"scale_builds", [](SolverState& s) { return number(s.work.scales); }},
    {"fields_derived", [](SolverState& s) { return number(s.work.fields); }},
    {"laws_checked", [](SolverState& s) { return number(s.work.laws); }},
    {"displacement_fields", [](SolverState& s) { return number(s.work.displacements); }},
    {"error_estimates", [](SolverState& s) { return number(s.work.estimates); }},
    {"unknowns",
     [](SolverState& s) {
       const double components = s.frictionless ? 1 : 3;
       return components * sum_in_contact(s, [](std::size_t) { return 1.0; }) +
              number(std::count(s.given.by_force.begin(), s.given.by_force.end(), true));
     }},
};

}  // namespace

std::span<const Statistic> statistics() {
  return table;
}

}  // namespace rollcon
