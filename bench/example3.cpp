// The paper's example 3 on its four frames and with each scheme: cold from arrays to tractions, and
// the re-solve after a small change of creepage, its heap allocations counted.

#include "support/example3.hpp"

#include <algorithm>

#include "bench.hpp"
#include "memory.hpp"
#include "support/graded_disc.hpp"

namespace rollcon::bench {
namespace {

namespace example3 = scenes::example3;

double reference_creepage(int threads) {
  const double a = example3::hertz().a;
  auto pair = example3::pair(scenes::graded_disc(a, a, 18), "characteristic", threads);
  pair->solve();
  return pair->solution().creep[0];
}

void roll(Runner& runner, int nodes, const char* scheme, double reference) {
  const auto frame = example3::frame(nodes);
  Record record{.case_name = "example3", .method = scheme, .model = "half-space on rigid"};
  record.mesh = frame.name;
  record.threads = runner.threads;
  record.quantity = "creepage at Ft = 0.75 mu Fn";
  record.against = "18 graded rings, characteristic";
  const double began = now();
  auto pair = example3::pair(frame.mesh, scheme, runner.threads);
  const auto s = timed_solve(*pair, record, began);
  record.value = s.creep[0];
  record.error = s.creep[0] / reference - 1;
  const double p0 = *std::max_element(s.pressure.begin(), s.pressure.end());

  // Creepage-driven re-solves, each after 1 % of change; the first one may still size workspaces.
  pair->creep(s.creep[0], s.creep[1], 0);
  pair->solve();
  pair->creep(1.01 * s.creep[0], s.creep[1], 0);
  pair->solve();
  pair->creep(s.creep[0], s.creep[1], 0);
  const std::int64_t allocations = heap_allocations();
  const double warm = now();
  pair->solve();
  const double warm_seconds = now() - warm;
  record.extra = {{"p0", p0},
                  {"warm_seconds", warm_seconds},
                  {"warm_iterations", pair->stat("iterations")},
                  {"warm_heap_allocations", static_cast<double>(heap_allocations() - allocations)},
                  {"law_normal", pair->stat("law_normal")},
                  {"law_friction", pair->stat("law_friction")}};
  runner.emit(record);
}

void run(Runner& runner) {
  const double reference = reference_creepage(runner.threads);
  for (int nodes : {673, 703, 1985, 2745}) {
    if (runner.quick && nodes > 703) continue;
    for (const char* scheme : {"godunov", "least_squares", "characteristic"})
      roll(runner, nodes, scheme, reference);
  }
}

}  // namespace

std::vector<Case> example3_cases() {
  return {{"example3", "sphere on a rigid plane, the paper's four frames", run}};
}

}  // namespace rollcon::bench
