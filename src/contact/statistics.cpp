#include "contact/statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/estimate/error_estimate.hpp"
#include "contact/estimate/few_nodes.hpp"
#include "contact/results/condition.hpp"
#include "contact/results/mean_pressure.hpp"
#include "contact/results/power.hpp"
#include "contact/scene/geometry.hpp"
#include "contact/solver.hpp"
#include "linalg/blas_threads.hpp"
#include "mesh/stream_lines.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

double count_status(Solver& v, NodeStatus wanted) {
  Derived& d = v.derived();
  derive_fields(v.solution(), d);
  return static_cast<double>(std::count(d.status.begin(), d.status.end(), static_cast<std::int32_t>(wanted)));
}

template <class Term>
double sum_in_contact(const Solution& s, Term term) {
  double sum = 0;
  for (std::size_t k = 0; k < s.prepared->problem.gap.size(); ++k)
    if (s.iterate.lambda[2][k] < 0) sum += term(k);
  return sum;
}

double law(Solver& v, std::size_t which) {
  check_laws(v.solution(), v.derived());
  return v.derived().laws[which];
}

double number(std::int64_t v) {
  return static_cast<double>(v);
}

// Counts nodes whose state would change if their augmented traction moved by 1e-6 of the largest.
double near_change(Solver& v) {
  const Solution& s = v.solution();
  Derived& d = v.derived();
  derive_fields(s, d);
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
    const double augmented = it.lambda[2][k] + p.rn[k] * d.gap[k];
    bool near = std::abs(augmented) < 1e-6 * pressure;
    if (!near && augmented < 0 && !s.frictionless) {
      const double s1 = d.slip[0][k] / s.prepared->speed, s2 = d.slip[1][k] / s.prepared->speed;
      const FrictionTraction t = p.law->traction(
          {s.given.coefficient(p.mu, k), -augmented, it.lambda[0][k], it.lambda[1][k], s1, s2, p.rt[k]});
      near = std::abs(t.length - t.bound) < 1e-6 * bound;
    }
    count += near;
  }
  return count;
}

// Counts solves with given coefficients, where friction follows the whole solution.
std::int64_t rounds_of_friction(const Solution& s) {
  return s.frictionless || !s.prepared->problem.law->of_field() ? 0 : s.settled.rounds;
}

// Returns force times creepage, without the spin.
double t_gamma(Solver& v) {
  const Vec3 force = v.loads().force;
  const MotionValues motion = v.motions();
  return -(force[0] * motion[xi1] + force[1] * motion[xi2]);
}

// Returns the area whose particles have rolled into the contact within a step: along each row of nodes that touch, a
// distance's fraction of the row.
double area_rolled_in(const Solution& s) {
  const Prepared& on = *s.prepared;
  const StreamLines lines(on.frame);
  double sum = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::span<const std::int32_t> row = lines.nodes(i);
    const auto touches = [&](std::size_t k) { return k < row.size() && s.iterate.lambda[2][at(row[k])] < 0; };
    for (std::size_t k = 0, first = 0; k < row.size(); ++k) {
      if (!touches(k)) continue;
      if (k == 0 || !touches(k - 1)) first = k;
      if (touches(k + 1)) continue;
      const auto intervals = static_cast<double>(k - first);
      const double length = (lines.x(row[first]) - lines.x(row[k])) * (intervals + 1);  // times the intervals
      const double part = std::min(1.0, k > first ? on.distance * intervals / length : 1);
      for (std::size_t m = first; m <= k; ++m) sum += part * on.problem.cell_area[at(row[m])];
    }
  }
  return sum;
}

// Returns the fraction of the contact's area that came into contact within a step.
double step_growth(Solver& v) {
  const auto area = [](const PastStep& past) {
    double sum = 0;
    for (std::size_t k = 0; past.loaded && past.on && k < past.lambda[2].size(); ++k)
      if (past.lambda[2][k] < 0) sum += past.on->frame.cell_area[k];
    return sum;
  };
  const double now = area(v.steps().last), before = area(v.steps().before);
  if (v.solution().prepared->step == StepKind::steady || !(now > 0)) return 0;
  if (v.solution().prepared->step == StepKind::rolling && before > 0) return area_rolled_in(v.solution()) / now;
  return std::max(0.0, 1 - before / now);
}

const Builds& builds_of(Solver& v) {
  static const Builds none;
  return v.preparation() ? v.preparation()->builds : none;
}

double put_in(Solver& v) {
  const Solution& s = v.solution();
  return s.prepared->step == StepKind::steady ? power_put_in(s) : power_in_step(s, v.derived(), v.preparation());
}

constexpr Statistic table[] = {
    {{"iterations", "Newton steps, in all"},
     [](Solver& v) {
       return number(v.solution().report.normal_iterations + v.solution().report.tangential_iterations +
                     v.solution().report.full_iterations);
     },
     true},
    {{"normal_iterations", "Newton steps for the pressures alone"},
     [](Solver& v) { return number(v.solution().report.normal_iterations); }},
    {{"tangential_iterations", "Newton steps for tangential tractions under given pressures"},
     [](Solver& v) { return number(v.solution().report.tangential_iterations); }},
    {{"full_iterations", "Newton steps for all tractions together"},
     [](Solver& v) { return number(v.solution().report.full_iterations); }},
    {{"fallbacks", "detours of the iteration"}, [](Solver& v) { return number(v.solution().report.fallbacks); }, true},
    {{"friction_rounds", "solves with given friction, where it follows the whole solution; else 0"},
     [](Solver& v) { return number(rounds_of_friction(v.solution())); }},
    {{"friction_change", "last change of friction's bounds between these solves"},
     [](Solver& v) { return rounds_of_friction(v.solution()) > 0 ? v.solution().settled.change : 0.0; }},
    {{"predictions", "predicted starts", true}, [](Solver& v) { return number(v.solution().report.predictions); }},
    {{"linear_iterations", "Krylov iterations"}, [](Solver& v) { return number(v.effort().linear_iterations); }},
    {{"factorizations", "LU factorisations"}, [](Solver& v) { return number(v.effort().factorizations); }},
    {{"residual_normal", "normal residual at which the iteration stopped"},
     [](Solver& v) { return v.solution().report.residual_normal; },
     true},
    {{"residual_tangential", "tangential residual at which it stopped"},
     [](Solver& v) { return v.solution().report.residual_tangential; },
     true},
    {{"condition", "estimated condition of the last linear system, at the price of an LU; 0: it is not formed"},
     [](Solver& v) { return find_condition(v.solution(), v.engine().newton); }},
    {{"law_normal", "residual of the law of contact, recomputed"}, [](Solver& v) { return law(v, 0); }},
    {{"law_friction", "residual of the limit of friction, recomputed"}, [](Solver& v) { return law(v, 1); }},
    {{"law_slip", "residual of the law of slip, recomputed"}, [](Solver& v) { return law(v, 2); }},
    {{"law_equilibrium", "residual of the prescribed loads, recomputed"}, [](Solver& v) { return law(v, 3); }},
    {{"error_estimate", "the greater one of the estimated relative errors of normal and tangential force"},
     [](Solver& v) { return find_error_estimate(v.solution(), v.derived()).worst(); }},
    {{"error_estimate_normal", "estimated relative error of the normal force"},
     [](Solver& v) { return find_error_estimate(v.solution(), v.derived()).normal; }},
    {{"error_estimate_tangential", "estimated relative error of the tangential force"},
     [](Solver& v) { return find_error_estimate(v.solution(), v.derived()).tangential; }},
    {{"error_estimate_tractions", "estimated relative error of tractions, L2 norm"},
     [](Solver& v) { return find_error_estimate(v.solution(), v.derived()).tractions; }},
    {{"nodes_contact", "nodes in contact"},
     [](Solver& v) { return sum_in_contact(v.solution(), [](std::size_t) { return 1.0; }); },
     true},
    {{"nodes_inside", "nodes in contact without an open neighbour"},
     [](Solver& v) { return number(nodes_inside(v.solution())); }},
    {{"nodes_stick", "nodes that stick"}, [](Solver& v) { return count_status(v, NodeStatus::stick); }},
    {{"nodes_slip", "nodes that slip"}, [](Solver& v) { return count_status(v, NodeStatus::slip); }},
    {{"nodes_rim", "nodes in contact at the frame's rim"},
     [](Solver& v) {
       return sum_in_contact(v.solution(),
                             [&](std::size_t k) { return v.solution().prepared->frame.rim[k] ? 1.0 : 0.0; });
     }},
    {{"nodes_near_change", "nodes whose state a millionth of the largest traction would change"}, near_change},
    {{"nodes_overlap", "nodes where the undeformed bodies overlap at approach 0"},
     [](Solver& v) {
       return number(
           initial_overlap(v.solution().prepared->frame, v.solution().prepared->problem.undeformed_gaps()).nodes);
     }},
    {{"overlap_depth", "the largest depth of that overlap"},
     [](Solver& v) {
       return initial_overlap(v.solution().prepared->frame, v.solution().prepared->problem.undeformed_gaps()).depth;
     }},
    {{"contact_area", "area in contact"},
     [](Solver& v) {
       if (const auto& area = v.derived().area) return *area;
       if (v.derived().extrapolated) return v.derived().extrapolated->area;
       return sum_in_contact(v.solution(), [&](std::size_t k) { return v.solution().prepared->problem.cell_area[k]; });
     },
     true},
    {{"stick_area", "area that sticks"},
     [](Solver& v) {
       derive_fields(v.solution(), v.derived());
       return sum_in_contact(v.solution(), [&](std::size_t k) {
         const bool sticks = v.derived().status[k] == static_cast<std::int32_t>(NodeStatus::stick);
         return sticks ? v.solution().prepared->problem.cell_area[k] : 0;
       });
     }},
    {{"friction_power", "power of friction, by the slip at nodes"},
     [](Solver& v) { return power_at_nodes(v.solution(), v.derived()); },
     true},
    {{"friction_power_balance", "power of friction, by the balance of work"},
     [](Solver& v) { return put_in(v); },
     true},
    {{"rolling_resistance", "force of rolling resistance of viscoelastic bodies: power lost in them over the speed"},
     [](Solver& v) { return rolling_resistance(v.solution()); },
     true},
    {{"body_power", "power lost in viscoelastic bodies"},
     [](Solver& v) { return v.solution().prepared->speed * rolling_resistance(v.solution()); },
     true},
    {{"t_gamma", "wear number: force times creepage, without the spin"}, t_gamma},
    {{"rolling_speed", "speed V, given or from the velocity of the contact"},
     [](Solver& v) {
       const Prepared& on = *v.solution().prepared;
       return on.step == StepKind::steady ? on.speed : on.distance * on.speed;
     }},
    {{"step_time", "time since the steps began"}, [](Solver& v) { return v.steps().last.time; }},
    {{"steps", "steps in time"}, [](Solver& v) { return number(v.steps().last.steps); }},
    {{"step_distance", "distance rolled in the last step"}, [](Solver& v) { return v.solution().prepared->distance; }},
    {{"step_growth", "fraction of the contact's area that came into contact within the last step"}, step_growth},
    {{"step_row_builds", "rows made to carry displacements along", true},
     [](Solver& v) { return number(v.preparation() ? v.preparation()->carried.made() : 0); }},
    {{"max_pressure",
      "largest pressure: at a node, on strips the top of the curve between nodes, or the mean over the option "
      "pressure_length"},
     [](Solver& v) {
       if (const double over = v.scene.options.pressure_length; over > 0)
         return largest_mean_pressure(v.solution(), over);
       if (const auto& top = v.derived().largest_pressure) return *top;
       return std::max(
           0.0, -*std::min_element(v.solution().iterate.lambda[2].begin(), v.solution().iterate.lambda[2].end()));
     },
     true},
    {{"seconds_compliance", "wall time for bodies and their compliance"},
     [](Solver& v) { return v.effort().timings.compliance; }},
    {{"seconds_convection", "wall time for the convective scheme"},
     [](Solver& v) { return v.effort().timings.convection; }},
    {{"seconds_newton", "wall time for Newton's method"}, [](Solver& v) { return v.effort().timings.newton; }},
    {{"seconds_linear", "wall time for linear systems, a part of seconds_newton"},
     [](Solver& v) { return v.effort().timings.linear; }},
    {{"seconds_total", "wall time, in all"}, [](Solver& v) { return v.effort().timings.total; }},
    {{"seconds_sensitivity", "wall time for derivatives since the solve, in none of the others"},
     [](Solver& v) { return v.derived().sensitivities.seconds; }},
    {{"sensitivity_right_sides", "right sides solved for derivatives", true},
     [](Solver& v) { return number(v.derived().sensitivities.right_sides); }},
    {{"sensitivity_factorizations", "factorisations for derivatives", true},
     [](Solver& v) { return number(v.derived().sensitivities.factorizations); }},
    {{"sensitivity_linear_iterations", "Krylov iterations for derivatives", true},
     [](Solver& v) { return number(v.derived().sensitivities.linear_iterations); }},
    {{"seconds_error_estimate", "wall time for error estimates since the solve, in none of the others"},
     [](Solver& v) { return v.derived().error_estimate.seconds; }},
    {{"peak_bytes", "bytes of the contact's own arrays"},
     [](Solver& v) { return static_cast<double>(v.effort().peak_bytes); }},
    {{"threads", "threads of the BLAS"}, [](Solver& v) { return number(v.effort().threads); }},
    {{"kernel_evaluations", "evaluations of kernels for this compliance", true},
     [](Solver& v) {
       return v.solution().prepared->compliance ? number(v.solution().prepared->compliance->kernel_evaluations()) : 0.0;
     }},
    {{"compliance_assemblies", "operators assembled", true}, [](Solver& v) { return number(builds_of(v).operators); }},
    {{"system_unknowns", "unknowns of the monolithic system; else 0", true},
     [](Solver& v) { return number(v.effort().unknowns); }},
    {{"system_nonzeros", "nonzeros of the monolithic system; else 0", true},
     [](Solver& v) { return number(v.effort().nonzeros); }},
    {{"operator_bytes", "bytes of the operators"},
     [](Solver& v) { return static_cast<double>(v.solution().prepared->problem.op->bytes()); }},
    {{"operator_applications", "applications of the compliance without rows", true},
     [](Solver& v) {
       return number(v.derived().computed.applications + v.solution().prepared->problem.op->applications());
     }},
    {{"right_sides", "linear systems solved", true}, [](Solver& v) { return number(v.effort().right_sides); }},
    {{"body_preparations", "bodies prepared by solves of this contact", true},
     [](Solver& v) { return number(builds_of(v).bodies); }},
    {{"frame_builds", "times the frame was made", true}, [](Solver& v) { return number(builds_of(v).frames); }},
    {{"compliance_builds", "times compliances were made", true},
     [](Solver& v) { return number(builds_of(v).compliances); }},
    {{"stencil_builds", "times the convective scheme was made", true},
     [](Solver& v) { return number(builds_of(v).stencils); }},
    {{"gap_builds", "times gaps were made", true}, [](Solver& v) { return number(builds_of(v).gaps); }},
    {{"friction_builds", "times friction was made", true}, [](Solver& v) { return number(builds_of(v).frictions); }},
    {{"slip_builds", "times the rigid slip was made", true}, [](Solver& v) { return number(builds_of(v).slips); }},
    {{"scale_builds", "times scales were made", true}, [](Solver& v) { return number(builds_of(v).scales); }},
    {{"fields_derived", "times fields were computed", true},
     [](Solver& v) { return number(v.derived().computed.fields); }},
    {{"laws_checked", "times the laws were recomputed", true},
     [](Solver& v) { return number(v.derived().computed.laws); }},
    {{"displacement_fields", "times displacements were computed", true},
     [](Solver& v) { return number(v.derived().computed.displacements); }},
    {{"error_estimates", "times errors were estimated", true},
     [](Solver& v) { return number(v.derived().computed.estimates); }},
    {{"unknowns", "unknowns at the solution: components at nodes in contact, and motions"},
     [](Solver& v) {
       const double components = v.solution().frictionless ? 1 : 3;
       return components * sum_in_contact(v.solution(), [](std::size_t) { return 1.0; }) +
              number(std::count(v.solution().given.by_force.begin(), v.solution().given.by_force.end(), true));
     }},
};

}  // namespace

std::span<const Statistic> statistics() {
  return table;
}

double find_statistic(Solver& solver, const char* name) {
  const Statistic& s = statistic_row(statistics(), name);
  solver.require_solution();
  const BlasThreads blas(solver.blas_threads());
  return s.value(solver);
}

}  // namespace rollcon
