#include "contact/newton/frictionless_share.hpp"

#include "contact/newton/friction_limit.hpp"
#include "support/interrupt.hpp"

namespace rollcon {

std::optional<FrictionShare> FrictionlessShare::find(const Problem& problem, const Prescribed& given,
                                                     const Procedure& procedure, double tolerance,
                                                     std::int64_t max_iterations, Monitor& monitor) {
  Prescribed pressed = given;
  for (const int m : {xi1, xi2, spin}) {
    pressed.by_force[static_cast<std::size_t>(m)] = false;
    pressed.value[static_cast<std::size_t>(m)] = 0;
  }
  newton_.predict = false;
  newton_.use(procedure);
  newton_.operators_changed();
  iterate_.resize(problem.nodes);
  iterate_.clear();
  const NewtonReport report = newton_.solve(problem, pressed, iterate_, true, tolerance, max_iterations, monitor);
  if (report.outcome == Outcome::cancelled) throw Cancelled();
  if (report.outcome != Outcome::converged) return std::nullopt;
  return share_of_friction(problem, given, iterate_.lambda);
}

}  // namespace rollcon
