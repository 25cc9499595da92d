#include "contact/settle/solve_prepared.hpp"

#include "contact/prepare/lattice_scene.hpp"
#include "contact/settle/settle_friction.hpp"

namespace rollcon {
namespace {

void run_standard(Newton& newton, Solution& s, Effort& effort, const Options& options, Monitor& monitor) {
  LinearSolver& linear = newton.linear();
  newton.use(s.procedure);
  newton.predict = options.warm_start == 2;
  linear.unknowns = 0;  // it stays 0 where nothing needs a system
  effort.linear_iterations = -linear.iterations;
  effort.right_sides = -linear.right_sides;
  effort.factorizations = -linear.factorizations;
  effort.timings.linear = -linear.seconds;
  start_on_lattice(s, monitor);
  const auto solve = [&](double tolerance) {
    s.report = newton.solve(s.prepared->problem, s.given, s.iterate, s.frictionless, tolerance, options.max_iterations,
                            monitor);
    s.images_known = false;
  };
  if (s.frictionless || !s.prepared->problem.law->of_field())
    solve(options.tolerance);
  else
    settle_friction(s, options.tolerance, solve);
  effort.unknowns = linear.unknowns;
  effort.nonzeros = linear.unknowns * linear.unknowns;
  effort.linear_iterations += linear.iterations;
  effort.right_sides += linear.right_sides;
  effort.factorizations += linear.factorizations;
  effort.timings.linear += linear.seconds;
}

}  // namespace

void solve_prepared(Engine& engine, Solution& s, Effort& effort, const Options& options, Monitor& monitor) {
  if (s.procedure.standard()) {
    run_standard(engine.newton, s, effort, options, monitor);
  } else {
    if (!engine.published) engine.published = engine.make_published();
    engine.published->run(s, engine.newton, effort, options, monitor);
  }
  // nodes_at_rim() needs these gaps.
  const Problem& p = s.prepared->problem;
  if (s.prepared->ends_at_edge && !s.prepared->placed && p.op->normal)
    for (std::size_t k = 0; k < p.used.size(); ++k)
      if (!p.used[k]) s.iterate.update_gap(p, static_cast<std::int64_t>(k));
}

}  // namespace rollcon
