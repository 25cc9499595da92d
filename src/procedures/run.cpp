#include "procedures/run.hpp"

#include "contact/solution.hpp"
#include "procedures/condensed.hpp"
#include "procedures/monolithic.hpp"

namespace rollcon {
namespace {

std::unique_ptr<StepSystem> make_step_system(SolverState& s) {
  if (s.procedure.monolithic) {
    const bool direct =
        s.procedure.linear == LinearMethod::lu || s.procedure.linear == LinearMethod::automatic;
    const MonolithicOptions options{direct ? StepSolver::lu : StepSolver::gmres,
                                    s.procedure.preconditioner};
    return std::make_unique<MonolithicSystem>(s.problem, s.frame, *s.compliance, options);
  }
  return std::make_unique<CondensedSystem>(s.problem, s.frame, *s.compliance, s.newton.linear);
}

}  // namespace

void run_published(SolverState& s, const Options& options, Monitor& monitor) {
  LinearSolver& linear = s.newton.linear;
  linear.method = s.procedure.linear;
  linear.preconditioner = s.procedure.preconditioner;
  linear.forget_exact();
  s.newton.forget_prediction();
  const SolverState::StepKey key{s.procedure.monolithic, s.frictionless, s.problem.by_force,
                                 s.procedure.linear, s.procedure.preconditioner};
  if (!s.step_system || key != s.step_key) s.step_system = make_step_system(s);
  s.step_key = key;
  const StepCounters before = s.step_system->counters();
  s.report = s.gnmls.solve(s.problem, s.iterate, *s.step_system, s.procedure, s.frictionless,
                           options.tolerance, options.max_iterations, monitor);
  const StepCounters after = s.step_system->counters();
  s.linear_iterations = after.iterations - before.iterations;
  s.factorizations = after.factorizations - before.factorizations;
  s.right_sides =
      s.report.normal_iterations + s.report.tangential_iterations + s.report.full_iterations;
  s.timings.linear = after.seconds - before.seconds;
  s.system_unknowns = after.unknowns;
  s.system_nonzeros = after.nonzeros;
  s.images_known = !s.frictionless;
}

}  // namespace rollcon
