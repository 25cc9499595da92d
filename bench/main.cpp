// Runs rollcon-bench: error against run time and memory.
//   rollcon-bench list
//   rollcon-bench run CASE... | all [--json FILE] [--quick] [--threads N] [--scenes N]
//   rollcon-bench stability [...]   the same as run stability

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include "bench.hpp"

namespace {

using rollcon::bench::Case;

std::vector<Case> all_cases() {
  using namespace rollcon::bench;
  std::vector<Case> cases;
  for (auto family : {hertz_cases,          carter_cases,
                      kalker_cases,         kalker_mesh_cases,
                      steady_rolling_cases, lame_cases,
                      hertz_block_cases,    example1_cases,
                      example2_cases,       example3_cases,
                      example4_cases,       procedure_cases,
                      kernel_cases,         linear_solver_cases,
                      friction_law_cases,   body_cases,
                      ring_load_cases,      fem_cases,
                      effectivity_cases,    resolve_cases,
                      guard_cases,          automatic_frame_cases,
                      thrift_cases,         time_loop_cases,
                      time_step_cases,      wheel_rail_cases,
                      creep_table_cases,    equivalent_ellipse_cases,
                      many_cases,           saved_body_cases,
                      lattice_cases,        stress_cases,
                      slice_cases,          stability_cases})
    for (Case& c : family()) cases.push_back(std::move(c));
#ifdef ROLLCON_BENCH_WHEELSET
  for (Case& c : wheelset_cases()) cases.push_back(std::move(c));
#endif
#ifdef ROLLCON_BENCH_KERNELS
  for (Case& c : bem_kernel_cases()) cases.push_back(std::move(c));
#endif
  return cases;
}

int usage() {
  std::fprintf(stderr,
               "usage: rollcon-bench list\n       rollcon-bench run CASE... | all [--json FILE] [--quick] [--threads "
               "N] [--scenes N]\n       rollcon-bench stability [...]\n");
  return 2;
}

int run(const std::vector<Case>& cases, int argc, char** argv) {
  rollcon::bench::Runner runner;
  std::vector<std::string> wanted;
  const auto want = [&](const std::string& name) {
    if (name == "stability")  // all of its parts
      wanted.insert(wanted.end(), {"stability_named", "stability_random", "stability_forces", "stability_bodies"});
    else
      wanted.push_back(name);
  };
  if (std::string(argv[1]) == "stability") want(argv[1]);
  for (int i = 2; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--quick") {
      runner.quick = true;
    } else if (argument == "--json" && i + 1 < argc) {
      if (!runner.open_json(argv[++i])) {
        std::fprintf(stderr, "cannot write %s\n", argv[i]);
        return 1;
      }
    } else if (argument == "--threads" && i + 1 < argc) {
      runner.threads = std::atoi(argv[++i]);
    } else if (argument == "--scenes" && i + 1 < argc) {
      runner.scenes = std::atoi(argv[++i]);
    } else if (argument.starts_with("--")) {
      return usage();
    } else {
      want(argument);
    }
  }
  if (wanted.empty()) return usage();
  const bool everything = std::find(wanted.begin(), wanted.end(), "all") != wanted.end();
  for (const std::string& name : wanted)
    if (name != "all" && std::none_of(cases.begin(), cases.end(), [&](const Case& c) { return c.name == name; })) {
      std::fprintf(stderr, "no case %s; see rollcon-bench list\n", name.c_str());
      return 2;
    }
  int failed = 0;
  for (const Case& c : cases) {
    if (!everything && std::find(wanted.begin(), wanted.end(), c.name) == wanted.end()) continue;
    try {
      c.run(runner);
    } catch (const std::exception& e) {
      std::fprintf(stderr, "%s: %s\n", c.name.c_str(), e.what());
      ++failed;
    }
  }
  return failed ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<Case> cases = all_cases();
  const std::string command = argc > 1 ? argv[1] : "";
  if (command == "list") {
    for (const Case& c : cases) std::printf("%-14s %s\n", c.name.c_str(), c.summary.c_str());
    return 0;
  }
  return command == "run" || command == "stability" ? run(cases, argc, argv) : usage();
}
