/// Condition of the last linear systems, found when asked for.

#include "contact/condition.hpp"

#include <algorithm>
#include <cmath>

#include "contact/free_system.hpp"
#include "contact/state.hpp"
#include "linalg/factored_matrix.hpp"

namespace rollcon {

double estimate_condition(ReducedSystem& system) {
  FreeSystem free;
  free.take(system);
  if (free.size() == 0) return 0;
  FactoredMatrix matrix;
  free.dense(FreeSystem::Rows::all, matrix.prepare(free.size()));
  return matrix.factor() ? matrix.condition() : INFINITY;
}

double find_condition(SolverState& s) {
  const ContactOperators& op = s.problem.op;
  const auto& pressures = s.iterate.lambda[2];
  const bool loaded =
      std::any_of(pressures.begin(), pressures.end(), [](double l) { return l < 0; });
  const Part goal = Newton::goal(s.problem, s.frictionless);
  const bool formed = op.normal && (goal == Part::normal || op.tangential);
  if (op.field || !formed || !loaded) return 0;
  const auto of = [&](Part part) {
    return estimate_condition(s.newton.linearise(s.problem, s.iterate, part));
  };
  double worst = 0;
  try {
    if (goal != Part::full) worst = of(Part::normal);
    if (goal != Part::normal) worst = std::max(worst, of(goal));
  } catch (...) {
    s.newton.operators_changed();  // what was gathered may be half done
    throw;
  }
  return worst;
}

}  // namespace rollcon
