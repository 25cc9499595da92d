/// Finds the condition of the last linear systems when asked for.

#include "contact/results/condition.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "contact/linear/free_system.hpp"
#include "contact/newton/newton.hpp"
#include "contact/solution.hpp"
#include "linalg/lapack.hpp"

namespace rollcon {

double estimate_condition(ReducedSystem& system) {
  FreeSystem free;
  free.take(system);
  if (free.size() == 0) return 0;
  const std::int64_t n = free.size();
  std::vector<double> a(static_cast<std::size_t>(n * n)), work(static_cast<std::size_t>(4 * n));
  std::vector<int> pivot(static_cast<std::size_t>(n));
  free.dense(FreeSystem::Rows::all, a.data());
  // Row-major here is the transpose there, and its 1-norm the greatest sum of a row.
  double norm = 0;
  for (std::int64_t i = 0; i < n; ++i) {
    double sum = 0;
    for (std::int64_t j = 0; j < n; ++j) sum += std::abs(a[static_cast<std::size_t>(i * n + j)]);
    norm = std::max(norm, sum);
  }
  const int size = static_cast<int>(n);
  int info = 0;
  dgetrf_(&size, &size, a.data(), &size, pivot.data(), &info);
  if (info != 0) return INFINITY;
  double reciprocal = 0;
  dgecon_("1", &size, a.data(), &size, &norm, &reciprocal, work.data(), pivot.data(), &info);
  return info == 0 && reciprocal > 0 ? 1 / reciprocal : INFINITY;
}

double find_condition(const Solution& s, Newton& newton) {
  const Operators& op = *s.prepared->problem.op;
  const auto& pressures = s.iterate.lambda[2];
  const bool loaded = std::any_of(pressures.begin(), pressures.end(), [](double l) { return l < 0; });
  const Part goal = Newton::goal(s.prepared->problem, s.given, s.frictionless);
  const bool formed = op.normal && (goal == Part::normal || op.tangential);
  if (op.all_at_once() || !formed || !loaded) return 0;
  const auto of = [&](Part part) {
    return estimate_condition(newton.linearise(s.prepared->problem, s.given, s.iterate, part));
  };
  double worst = 0;
  try {
    if (goal != Part::full) worst = of(Part::normal);
    if (goal != Part::normal) worst = std::max(worst, of(goal));
  } catch (...) {
    newton.operators_changed();  // gathered factors may be half done
    throw;
  }
  return worst;
}

}  // namespace rollcon
