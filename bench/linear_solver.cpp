// Compares dense LU with GMRES over the size of the problem: where the time curves cross.

#include <algorithm>

#include "bench.hpp"
#include "support/example3.hpp"
#include "support/graded_disc.hpp"
#include "support/steady_rolling.hpp"

namespace rollcon::bench {
namespace {

void solve(Runner& runner, scenes::RollingPair& pair, const std::string& mesh, const char* method,
           const std::string& model) {
  Record record{.case_name = "linear_solver", .method = method, .model = model};
  record.mesh = mesh;
  record.threads = runner.threads;
  record.quantity = "seconds outside the compliance";
  record.against = "none";
  pair.option("linear_solver", method);
  const double began = now();
  timed_solve(pair, record, began);
  record.value = record.seconds - pair.stat("seconds_compliance");
  record.extra = {
      {"seconds_per_iteration", record.value / static_cast<double>(std::max<std::int64_t>(1, record.iterations))},
      {"factorizations", pair.stat("factorizations")}};
  runner.emit(record);
}

void run(Runner& runner) {
  namespace steady_rolling = scenes::steady_rolling;
  for (int n : {12, 16, 24, 32, 48, 64}) {
    if (runner.quick && n > 24) continue;
    for (const char* method : {"lu", "gmres"}) {
      scenes::RollingPair pair(steady_rolling::steel, steady_rolling::steel, runner.threads);
      steady_rolling::prepare(pair, steady_rolling::grid(n), "b");
      solve(runner, pair, "grid " + std::to_string(n), method, "identical half-spaces");
    }
  }
  for (int nodes : {673, 703, 1985, 2745}) {
    if (runner.quick && nodes > 703) continue;
    const auto frame = scenes::example3::frame(nodes);
    for (const char* method : {"lu", "gmres"}) {
      auto pair = scenes::example3::pair(frame.mesh, "least_squares", runner.threads);
      solve(runner, *pair, frame.name, method, "half-space on rigid");
    }
  }
}

}  // namespace

std::vector<Case> linear_solver_cases() {
  return {{"linear_solver", "dense LU against GMRES over sizes", run}};
}

}  // namespace rollcon::bench
