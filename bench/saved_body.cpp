// Compares a prepared body saved and loaded with preparing it: seconds, and bytes in memory and file.

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <functional>

#include "bench.hpp"
#include "support/example1.hpp"

namespace rollcon::bench {
namespace {

namespace example1 = scenes::example1;
namespace fs = std::filesystem;

void must(rollcon_status status, const char* what) {
  if (status >= 0) return;
  std::fprintf(stderr, "%s: %s\n", what, rollcon_status_string(status));
  std::exit(1);
}

/// Returns the best of several runs, because others use the machine, too.
double best_of(int runs, const std::function<void()>& work) {
  double least = 1e30;
  for (int k = 0; k < runs; ++k) {
    const double began = now();
    work();
    least = std::min(least, now() - began);
  }
  return least;
}

double stat(const rollcon_body* body, const char* name) {
  double value = 0;
  must(rollcon_body_get_stat(body, name, &value), name);
  return value;
}

rollcon_context* new_context(int threads) {
  rollcon_context* context = nullptr;
  must(rollcon_context_create(ROLLCON_ABI, &context), "context_create");
  must(rollcon_context_set_threads(context, threads), "set_threads");
  return context;
}

void saved_ring(Runner& runner, const scenes::MeshedBody& ring, const std::string& name) {
  const fs::path path = fs::temp_directory_path() / ("rollcon_saved_" + std::to_string(getpid()) + ".rcb");
  Record record{.case_name = "saved_body", .method = "condensed", .model = "twins"};
  record.threads = runner.threads;
  const int runs = runner.quick ? 1 : 3;
  const double prepare = best_of(runs, [&] {
    rollcon_context* context = new_context(runner.threads);
    rollcon_body* body = scenes::make_body(context, ring);
    must(rollcon_body_prepare(body), "prepare");
    rollcon_body_release(body);
    rollcon_context_release(context);
  });
  auto pair = example1::pair(ring, scenes::TwinBody{}, "characteristic", runner.threads);
  rollcon_body* body = pair->body(1);
  must(rollcon_body_prepare(body), "prepare");
  record.extra.emplace_back("bytes_prepared", stat(body, "bytes"));
  const double first = best_of(runs, [&] { must(rollcon_body_save(body, path.c_str()), "save"); });
  record.extra.emplace_back("file_bytes_prepared", static_cast<double>(fs::file_size(path)));
  timed_solve(*pair, record, now());
  const double save = best_of(runs, [&] { must(rollcon_body_save(body, path.c_str()), "save"); });
  record.extra.emplace_back("bytes_after_a_solve", stat(body, "bytes"));
  record.extra.emplace_back("file_bytes_after_a_solve", static_cast<double>(fs::file_size(path)));
  double assemblies = 0;
  const double load = best_of(runs, [&] {
    rollcon_context* context = new_context(runner.threads);
    rollcon_body* loaded = nullptr;
    must(rollcon_body_load(context, path.c_str(), &loaded), "load");
    assemblies = stat(loaded, "assemblies") + stat(loaded, "factorizations");
    rollcon_body_release(loaded);
    rollcon_context_release(context);
  });
  rollcon_context* context = new_context(runner.threads);
  rollcon_body* one = scenes::make_body(context, ring);
  must(rollcon_body_prepare(one), "prepare");
  const double shared = best_of(runs, [&] {
    rollcon_body* other = scenes::make_body(context, ring);
    must(rollcon_body_prepare(other), "prepare");
    assemblies += 1 - stat(other, "shared");
    rollcon_body_release(other);
  });
  rollcon_body_release(one);
  rollcon_context_release(context);
  fs::remove(path);
  record.mesh = name + ", " + std::to_string(std::lround(stat(body, "unknowns"))) + " unknowns";
  record.quantity = "seconds to load over seconds to prepare";
  record.value = load / prepare;
  record.error = assemblies;
  record.against = "assemblies and factorisations after loading, or beside an equal body: none";
  record.seconds = load;
  record.phase_seconds.emplace_back("prepare", prepare);
  record.phase_seconds.emplace_back("save_prepared", first);
  record.phase_seconds.emplace_back("save_after_a_solve", save);
  record.phase_seconds.emplace_back("prepare_equal", shared);
  for (const auto& [phase, seconds] : {std::pair("prepare", prepare), std::pair("save", save), std::pair("load", load),
                                       std::pair("prepare_equal", shared)})
    record.extra.emplace_back(std::string("seconds_") + phase, seconds);
  runner.emit(record);
}

void saved(Runner& runner) {
  saved_ring(runner, example1::ring_body(example1::paper_ring(), ElementType::quad4), "BEM quad4");
  if (!runner.quick) saved_ring(runner, example1::ring_body(example1::fem_ring(10), VolumeType::hex20), "FEM hex20");
  saved_ring(runner, example1::ring_body(example1::fem_ring(12), VolumeType::hex8), "FEM hex8");
}

}  // namespace

std::vector<Case> saved_body_cases() {
  return {{"saved_body", "a prepared body saved and loaded, or shared, against preparing it", saved}};
}

}  // namespace rollcon::bench
