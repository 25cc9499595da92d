#include "contact/scene/procedure.hpp"

#include <algorithm>
#include <string>

#include "build_info.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

template <class Value>
struct Named {
  const char* name;
  Value value;
};

template <class Value, std::size_t count>
Value find(const Named<Value> (&names)[count], const std::string& name) {
  for (const Named<Value>& known : names)
    if (name == known.name) return known.value;
  return names[0].value;
}

constexpr Named<Jacobian> jacobians[] = {{"exact", Jacobian::exact},
                                         {"b_derivative", Jacobian::b_derivative},
                                         {"simplified", Jacobian::simplified},
                                         {"reduced", Jacobian::reduced}};
// The estimate by (90) is that by (92) without extrapolation, and needs no parameter.
constexpr Named<SlipEstimate> estimates[] = {{"jacobi", SlipEstimate::jacobi},
                                             {"pseudo_temporal", SlipEstimate::pseudo_temporal},
                                             {"extrapolation", SlipEstimate::extrapolation}};
constexpr Named<LinearMethod> methods[] = {{"auto", LinearMethod::automatic},
                                           {"lu", LinearMethod::lu},
                                           {"gmres", LinearMethod::gmres},
                                           {"gmres_adaptive", LinearMethod::gmres_adaptive}};
constexpr Named<Preconditioner> preconditioners[] = {{"auto", Preconditioner::automatic},
                                                     {"none", Preconditioner::none},
                                                     {"diagonal", Preconditioner::diagonal},
                                                     {"bodies", Preconditioner::bodies},
                                                     {"kept_lu", Preconditioner::kept_lu}};
constexpr Named<LineSearch> searches[] = {
    {"auto", LineSearch::automatic}, {"armijo", LineSearch::armijo}, {"off", LineSearch::off}};

bool iterative(LinearMethod method) {
  return method == LinearMethod::gmres || method == LinearMethod::gmres_adaptive;
}

}  // namespace

Procedure choose_procedure(const Options& o) {
  const ProcedureChoices& c = o.procedure;
  Procedure p;
  p.monolithic = c.system == "monolithic";
  p.jacobian = find(jacobians, c.jacobian);
  p.estimate = find(estimates, c.slip_estimate);
  p.linear = find(methods, o.linear_solver);
  if (o.linear_tolerance > 0) (p.linear == LinearMethod::gmres_adaptive ? p.eta_max : p.eta) = o.linear_tolerance;
  p.preconditioner = find(preconditioners, o.preconditioner);
  p.line_search = find(searches, c.line_search);

  if (ROLLCON_BUILD_PROCEDURES == 0 && !p.standard())
    fail(Status::err_unsupported,
         "system is '%s' and jacobian is '%s', but this build of rollcon has no published solution "
         "procedures (component PROCEDURES: ROLLCON_WITH_PROCEDURES is OFF); allowed: condensed "
         "and exact",
         c.system.c_str(), c.jacobian.c_str());
  if (c.slip_estimate != "auto" && p.jacobian != Jacobian::reduced)
    fail(Status::err_option,
         "slip_estimate is '%s' but jacobian is '%s': only jacobian = reduced estimates the slip of "
         "sticking pairs, the others solve for it",
         c.slip_estimate.c_str(), c.jacobian.c_str());
  if (p.jacobian == Jacobian::reduced && o.convection == "characteristic")
    fail(Status::err_option,
         "jacobian is 'reduced' but convection is 'characteristic': the estimates (90)-(92) need a "
         "matrix between nodes; set convection to godunov or least_squares");
  if (p.preconditioner == Preconditioner::bodies && !p.monolithic)
    fail(Status::err_option, "preconditioner is 'bodies' but system is 'condensed', which has no unknowns of bodies");
  if (p.preconditioner == Preconditioner::kept_lu && p.monolithic)
    fail(Status::err_option,
         "preconditioner is 'kept_lu' but system is 'monolithic': factors of the whole cost more "
         "than the iterations that they save; choose bodies, which factorises the bodies once");
  if (o.preconditioner != "auto" && !iterative(p.linear))
    fail(Status::err_option, "preconditioner is '%s' but linear_solver is '%s': only gmres and gmres_adaptive have one",
         o.preconditioner.c_str(), o.linear_solver.c_str());
  if (p.standard() && (p.preconditioner == Preconditioner::none || p.preconditioner == Preconditioner::diagonal))
    fail(Status::err_option,
         "preconditioner is '%s' but jacobian is 'exact' and system 'condensed', which keep factors: choose jacobian = "
         "b_derivative, simplified or reduced, or system = monolithic",
         o.preconditioner.c_str());
  if (o.linear_tolerance > 0 && !iterative(p.linear))
    fail(Status::err_option, "linear_tolerance is %g but linear_solver is '%s': only gmres and gmres_adaptive have one",
         o.linear_tolerance, o.linear_solver.c_str());
  if (p.line_search != LineSearch::automatic && p.standard())
    fail(Status::err_option,
         "line_search is '%s' but jacobian is 'exact' and system 'condensed', which have a search of their own: choose "
         "jacobian = b_derivative, simplified or reduced, or system = monolithic",
         c.line_search.c_str());
  return p;
}

double adaptive_tolerance(double eta_max, double merit, double last_merit, double eta) {
  constexpr double c = 0.3;          // constant of (72)
  constexpr double threshold = 0.1;  // below it the safeguard rests
  if (!(eta > 0)) return eta_max;
  double next = last_merit > 0 ? c * merit / last_merit : eta_max;
  const double safeguard = c * eta * eta;
  if (safeguard > threshold) next = std::max(next, safeguard);
  return std::min(eta_max, next);
}

}  // namespace rollcon
