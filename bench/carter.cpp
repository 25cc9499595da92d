// Carter's strip: force and traction over nodes across the contact, scheme and grading.

#include "bench.hpp"
#include "support/carter_strip.hpp"

namespace rollcon::bench {
namespace {

void roll(Runner& runner, const std::vector<double>& x, int across, const std::string& name) {
  for (const char* scheme : scenes::schemes) {
    Record record{.case_name = "carter", .method = scheme, .model = "half-spaces"};
    record.mesh = name + " " + std::to_string(across);
    record.threads = runner.threads;
    const scenes::Strip strip{scenes::carter.hertz, 20};
    const auto mesh = frames::rectangle(ElementType::quad4, x, scenes::strip_lines(20));
    const double began = now();
    scenes::RollingPair pair(scenes::roller, scenes::roller, runner.threads);
    pair.frame(mesh).option("convection", scheme);
    scenes::load_strip(pair, strip, mesh);
    const auto s = timed_solve(pair, record, began);
    const auto error = scenes::compare(scenes::middle_section(s));
    record.quantity = "F/(mu P) at given creepage";
    record.against = "Carter's closed form";
    record.value = scenes::carter.force_ratio() * (1 + error.force);
    record.error = error.force;
    record.extra = {
        {"error_traction_l2", error.traction}, {"error_load", error.load}, {"across", across}};
    runner.emit(record);
  }
}

void run(Runner& runner) {
  for (int across : {12, 25, 50, 100, 150}) {
    if (runner.quick && across > 50) continue;
    roll(runner, scenes::strip_nodes(across), across, "uniform");
  }
  for (int across : {10, 20, 40, 60}) {
    if (runner.quick && across > 20) continue;
    roll(runner, scenes::graded_nodes(across), across, "graded");
  }
}

}  // namespace

std::vector<Case> carter_cases() {
  return {{"carter", "long strip of identical cylinders, three schemes", run}};
}

}  // namespace rollcon::bench
