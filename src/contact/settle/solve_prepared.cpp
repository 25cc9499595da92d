/// From a scene with its operators to tractions and what the solve took.

#include "contact/prepare/lattice_scene.hpp"
#include "contact/settle/settle_friction.hpp"
#include "contact/solution.hpp"

namespace rollcon {
namespace {

void run_standard(SolverState& s, const Options& options, Monitor& monitor) {
  LinearSolver& linear = s.newton.linear();
  s.newton.use(s.procedure);
  s.newton.predict = options.warm_start == 2;
  linear.unknowns = 0;  // where nothing needs a system
  s.linear_iterations = -linear.iterations;
  s.right_sides = -linear.right_sides;
  s.factorizations = -linear.factorizations;
  s.timings.linear = -linear.seconds;
  start_on_lattice(s, monitor);
  const auto solve = [&](double tolerance) {
    s.report = s.newton.solve(s.prepared->problem, s.given, s.iterate, s.frictionless, tolerance,
                              options.max_iterations, monitor);
    s.images_known = false;
  };
  if (s.frictionless || !s.prepared->problem.law->of_field())
    solve(options.tolerance);
  else
    settle_friction(s, options.tolerance, solve);
  s.system_unknowns = linear.unknowns;
  s.system_nonzeros = linear.unknowns * linear.unknowns;
  s.linear_iterations += linear.iterations;
  s.right_sides += linear.right_sides;
  s.factorizations += linear.factorizations;
  s.timings.linear += linear.seconds;
}

}  // namespace

void solve_prepared(SolverState& s, const Options& options, Monitor& monitor) {
  if (s.procedure.standard()) {
    run_standard(s, options, monitor);
  } else {
    if (!s.published) s.published = s.make_published();
    s.published->run(s, options, monitor);
  }
  // What nodes_at_rim() looks at.
  const Problem& p = s.prepared->problem;
  if (s.prepared->ends_at_edge && !s.prepared->placed && p.op->normal)
    for (std::size_t k = 0; k < p.used.size(); ++k)
      if (!p.used[k]) s.iterate.update_gap(p, static_cast<std::int64_t>(k));
}

}  // namespace rollcon
