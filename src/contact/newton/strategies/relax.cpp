/// Relaxes node by node: slow, but it does not cycle between states as Newton's steps may.

#include <algorithm>
#include <cmath>
#include <numeric>

#include "contact/laws/friction_law.hpp"
#include "contact/newton/strategies/strategies.hpp"
#include "contact/operators/dense_operators.hpp"

namespace rollcon {
namespace {

constexpr int most_sweeps = 60;
constexpr double enough = 1e-3;   // change in a sweep, over the largest traction
constexpr double hopeless = 1e3;  // multiple of the tractions at the start
constexpr double smallest = 1e-300;

// Solves every node's laws in turn with the tractions of the others held, from where material flows in to where it
// leaves: slip depends on tractions near and upstream of it most. Motions stay.
void sweep_along_flow(const Solve& s, const DenseOperators& op) {
  const Problem& p = *s.problem;
  Iterate& it = *s.iterate;
  std::vector<std::size_t> order(it.lambda[2].size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t k) { return !p.used[k]; });
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return p.convection.slip_x[a] > p.convection.slip_x[b]; });
  double first = 0;
  for (int sweep = 0; sweep < most_sweeps && !s.monitor->cancelled(); ++sweep) {
    double change_n = 0, change_t = 0, largest_n = smallest, largest_t = smallest;
    for (const std::size_t k : order) {
      double& normal = it.lambda[2][k];
      if (s.goal == Part::full) {
        const double a = op.own(2, 2, k);
        const double rest = p.rigid_gap(k, it.motion) - op.product(2, k, it.lambda) + a * normal;
        const double wanted = a > 0 ? std::min(0.0, rest / a) : normal;
        const double next = std::isfinite(wanted) ? wanted : normal;
        change_n = std::max(change_n, std::abs(next - normal));
        normal = next;
        largest_n = std::max(largest_n, -normal);
      }
      const auto i = static_cast<std::int64_t>(k);
      const std::array<double, 2> old{it.lambda[0][k], it.lambda[1][k]};
      const NodeResponse b{{{op.own(0, 0, k), op.own(0, 1, k)}, {op.own(1, 0, k), op.own(1, 1, k)}}};
      const double mu = s.given.coefficient(p.mu, k);
      std::array<double, 2> next{};
      if (mu * normal < 0) {
        const std::array<double, 2> slip{p.rigid_slip1(i, it.motion) + op.product(0, k, it.lambda),
                                         p.rigid_slip2(i, it.motion) + op.product(1, k, it.lambda)};
        next = p.law->solve(b, {mu, -normal, old[0], old[1], slip[0], slip[1], 0, s.given.falling});
      }
      for (int c = 0; c < 2; ++c) {
        const auto at = static_cast<std::size_t>(c);
        change_t = std::max(change_t, std::abs(next[at] - old[at]));
        largest_t = std::max(largest_t, std::abs(next[at]));
        it.lambda[c][k] = next[at];
      }
    }
    if (sweep == 0) first = largest_n + largest_t;
    if (!(largest_n + largest_t <= hopeless * first)) break;
    if (change_n <= enough * largest_n && change_t <= enough * largest_t) break;
  }
  it.invalidate();
}

}  // namespace

Outcome relax(NewtonIteration& newton) {
  Solve& s = newton.solve();
  const DenseOperators* rows = s.problem->op->dense();
  if (!rows) return Outcome::not_converged;
  newton.return_to_best();
  sweep_along_flow(s, *rows);
  return newton.run(s.goal, s.given, {.free_steps = 1});
}

}  // namespace rollcon
