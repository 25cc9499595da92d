// Measures the half-space kernel: point evaluations per second while a compliance is assembled.

#include "bench.hpp"
#include "support/example3.hpp"
#include "support/frames.hpp"

namespace rollcon::bench {
namespace {

void run(Runner& runner) {
  namespace example3 = scenes::example3;
  for (int nodes : {673, 703, 1985, 2745}) {
    if (runner.quick && nodes > 703) continue;
    const auto frame = example3::frame(nodes);
    Record record{.case_name = "kernel", .method = "assembly", .model = "half-space on rigid"};
    record.mesh = frame.name;
    record.threads = runner.threads;
    const double began = now();
    auto pair = example3::pair(frame.mesh, "least_squares", runner.threads);
    timed_solve(*pair, record, began);
    const double evaluations = pair->stat("kernel_evaluations");
    const double seconds = pair->stat("seconds_compliance");
    record.quantity = "point evaluations per second (error: over 5e7 per thread, less 1)";
    record.value = evaluations / seconds;
    record.error = record.value / (5e7 * runner.threads) - 1;
    record.against = "5e7 per second and core";
    record.extra = {{"kernel_evaluations", evaluations}, {"seconds_compliance", seconds}};
    runner.emit(record);
  }
}

}  // namespace

std::vector<Case> kernel_cases() {
  return {{"kernel", "half-space point evaluations per second", run}};
}

}  // namespace rollcon::bench
