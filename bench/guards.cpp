// Measures what guards, checks and statistics cost: each by itself, many times over, and counted as often as it happens
// in a warm re-solve of 169 pairs and in preparing a boundary-element body. Instructions counted by callgrind say the
// same (docs/speed.md).

#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <numeric>

#include "bench.hpp"
#include "contact/estimate/few_nodes.hpp"
#include "linalg/blas_threads.hpp"
#include "linalg/lapack.hpp"
#include "mesh/surface_check.hpp"
#include "support/checksum.hpp"
#include "support/clock.hpp"
#include "support/context.hpp"
#include "support/example1.hpp"
#include "support/memory_limit.hpp"
#include "support/steady_rolling.hpp"

namespace rollcon::bench {
namespace {

using closed_forms::Elastic;

/// Returns the seconds of one call: the least mean of several rounds.
template <class F>
double seconds_of(F&& call, int calls = 2000) {
  double least = INFINITY;
  for (int round = 0; round < 15; ++round) {
    const double began = now();
    for (int k = 0; k < calls; ++k) call();
    least = std::min(least, (now() - began) / calls);
  }
  return least;
}

/// Returns the seconds of all threads: long pieces must not count the time that others had the processor.
double cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

template <class F>
double cpu_seconds_of(F&& call) {
  double least = INFINITY;
  for (int round = 0; round < 5; ++round) {
    const double began = cpu_seconds();
    call();
    least = std::min(least, cpu_seconds() - began);
  }
  return least;
}

struct Guard {
  std::string name;
  double times, each;  ///< number in one re-solve or preparation; seconds of each
};

void emit(Runner& runner, Record& record, const std::vector<Guard>& guards, double whole) {
  double sum = 0;
  for (const Guard& g : guards) {
    sum += g.times * g.each;
    record.extra.emplace_back(g.name + "_us", 1e6 * g.times * g.each);
  }
  record.against = "1 %";
  record.value = sum / whole;
  record.seconds = whole;
  record.extra.emplace_back("guards_us", 1e6 * sum);
  record.extra.emplace_back("percent", 100 * sum / whole);
  runner.emit(record);
}

double solves(const scenes::RollingPair& pair) {
  return pair.stat("right_sides");
}

void resolve(Runner& runner, const std::string& model, const Elastic& body2, double change, double tolerance) {
  namespace rolling = scenes::steady_rolling;
  scenes::RollingPair pair(rolling::steel, body2, runner.threads);
  rolling::prepare(pair, rolling::grid(13), "b");
  pair.load(0.7 * rolling::hertz.load).option("tolerance", tolerance);
  pair.option("warm_start", std::int64_t{1});
  pair.solve();
  Record record{.case_name = "guards", .method = "", .model = model};
  record.mesh = "13 x 13";
  record.threads = runner.threads;
  char what[80];
  std::snprintf(what, sizeof what, "share of a re-solve after %g %%, tolerance %.0e", 100 * change, tolerance);
  record.quantity = what;

  // The change goes back and forth; the quicker way is the stricter measure.
  double whole = INFINITY, records = 0, systems = 0;
  const auto factor = [&](int k) { return k % 2 == 0 ? 1 + change : 1; };
  for (int k = 0; k < (runner.quick ? 20 : 400); ++k) {
    const double began = now();
    rollcon_contact_set_creep(pair.handle(), factor(k) * rolling::creepage, 0, factor(k) * rolling::spin);
    record.status = rollcon_contact_solve(pair.handle());
    const double seconds = now() - began;
    if (k < 4 || !(seconds < whole)) continue;
    whole = seconds;
    record.iterations = static_cast<std::int64_t>(pair.stat("iterations"));
    records = pair.stat("iterations") + 2;  // one before the first step of each part, too
    systems = solves(pair);
  }
  record.pairs = static_cast<std::int64_t>(pair.stat("nodes_contact"));
  const auto unknowns = static_cast<std::size_t>(pair.stat("system_unknowns"));
  const auto nodes = static_cast<std::size_t>(pair.solution().nodes());

  Context quiet;  // no sink, like that of the pair
  std::vector<double> history, copy[3], tractions[3], x(unknowns, 0.5);
  history.reserve(4096);
  for (std::size_t c = 0; c < 3; ++c) copy[c].resize(nodes), tractions[c].assign(nodes, 1.0);
  std::vector<std::uint8_t> rim(nodes, 0);
  volatile double sink = 0;
  volatile bool seen = false;
  std::vector<Guard> guards;
  // The calls take handle, busy flag, floating-point environment, exceptions to statuses, and in both calls the checks
  // of the creepages.
  guards.push_back({"calls", 1, seconds_of([&] { rollcon_contact_set_progress(pair.handle(), nullptr, nullptr); })});
  guards.push_back({"setter", 1, seconds_of([&] {
                      rollcon_contact_set_creep(pair.handle(), rolling::creepage, 0, rolling::spin);
                    })});
  guards.push_back({"blas_threads", 1, seconds_of([] { const BlasThreads blas(1); })});
  guards.push_back({"clocks", 2 + records + 2 * systems, seconds_of([&] { sink = now_seconds(); })});
  guards.push_back({"log", 3 + records, seconds_of([&] { quiet.log(LogLevel::debug, "%lld", 1LL); })});
  guards.push_back({"history", records, seconds_of([&] {
                      if (history.size() > 4000) history.clear();
                      for (int k = 0; k < 9; ++k) history.push_back(k);
                    })});
  guards.push_back({"best_iterate", static_cast<double>(record.iterations), seconds_of([&] {
                      for (int c = 0; c < 3; ++c) copy[c] = tractions[c];
                      sink = copy[0][nodes / 2];
                    })});
  // The pressures that the tangential part stands on are compared with those that the normal part ended with.
  guards.push_back({"last_guard", 1, seconds_of([&] {
                      copy[2] = tractions[2];
                      seen = std::memcmp(copy[2].data(), tractions[2].data(), nodes * sizeof(double)) == 0;
                    })});
  guards.push_back({"finite", systems, seconds_of([&] {
                      seen = std::all_of(x.begin(), x.end(), [](double v) { return std::isfinite(v); });
                    })});
  guards.push_back({"rim", 1, seconds_of([&] {
                      std::int64_t count = 0;
                      for (std::size_t k = 0; k < nodes; ++k)
                        count +=
                            static_cast<std::int64_t>(rim[k] != 0) & static_cast<std::int64_t>(tractions[2][k] < 0);
                      sink = static_cast<double>(count);
                    })});
  const SurfaceMesh frame = rolling::grid(13);
  std::vector<double> normal = pair.solution().pressure;
  for (double& t : normal) t = -t;
  std::vector<std::uint8_t> edge;
  guards.push_back({"inside", 1, seconds_of([&] { sink = static_cast<double>(nodes_inside(frame, normal, edge)); })});
  emit(runner, record, guards, whole);
}

void prepare(Runner& runner, int parts) {
  namespace example1 = scenes::example1;
  const scenes::MeshedBody ring = example1::ring_body(example1::bem_ring(parts), ElementType::quad4);
  Record record{.case_name = "guards", .method = "", .model = "BEM ring"};
  record.threads = runner.threads;
  record.quantity = "share of preparing a body";
  record.nodes = ring.mesh.nodes();
  record.elements = ring.mesh.elements();
  record.mesh = "quad4, " + std::to_string(record.nodes) + " nodes";
  double whole = INFINITY, unknowns = 0;
  for (int k = 0; k < (runner.quick ? 1 : 3); ++k) {
    rollcon_context* context = nullptr;
    rollcon_context_create(ROLLCON_ABI, &context);
    rollcon_context_set_threads(context, runner.threads);
    rollcon_body* body = scenes::make_body(context, ring);
    const double began = cpu_seconds();
    record.status = rollcon_body_prepare(body);
    whole = std::min(whole, cpu_seconds() - began);
    rollcon_body_get_stat(body, "unknowns", &unknowns);
    rollcon_body_release(body);
    rollcon_context_release(context);
  }
  record.unknowns = static_cast<std::int64_t>(unknowns);

  volatile double sink = 0;
  const auto n = static_cast<int>(unknowns);
  const auto size = static_cast<std::size_t>(n);
  std::vector<Guard> guards;
  guards.push_back({"mesh", 1, cpu_seconds_of([&] { check_surface(ring.mesh, SurfaceKind::closed); })});
  // Equal bodies are found by their content.
  guards.push_back({"digest", 1, cpu_seconds_of([&] {
                      Checksum sum;
                      sum.add(ring.mesh.node.data(), ring.mesh.node.size() * sizeof(Vec3));
                      sum.add(ring.mesh.connectivity.data(), ring.mesh.connectivity.size() * sizeof(std::int32_t));
                      sink = static_cast<double>(sum.value());
                    })});
  guards.push_back({"memory_limit", 1, cpu_seconds_of([] { require_memory({2e7, 2e7}, "none", "a matrix needs"); })});
  // The condition takes a norm of a seventh of the matrix, and a solution with its factors. Factors of the unit matrix
  // take as long as any.
  std::vector<double> factors(size * size, 0.0), b(size, 1.0);
  std::vector<int> pivot(size);
  for (std::size_t k = 0; k < size; ++k) factors[k * (size + 1)] = 1;
  std::iota(pivot.begin(), pivot.end(), 1);
  const BlasThreads blas(runner.threads);
  guards.push_back({"norm", 1, cpu_seconds_of([&] {
                      double sum[4] = {}, square[4] = {};
                      for (std::size_t j = 0; j < size; j += 7) {
                        const double* column = factors.data() + j * size;
                        for (std::size_t i = 0; i + 4 <= size; i += 4)
                          for (std::size_t k = 0; k < 4; ++k) sum[k] += std::abs(column[i + k]);
                        for (std::size_t i = 0; i + 4 <= size; i += 4)
                          for (std::size_t k = 0; k < 4; ++k) square[k] += column[i + k] * column[i + k];
                      }
                      sink = sum[0] + sum[1] + sum[2] + sum[3] + square[0] + square[1] + square[2] + square[3];
                    })});
  guards.push_back({"condition", 1, cpu_seconds_of([&] {
                      const int one = 1;
                      int info = 0;
                      dgetrs_("N", &n, &one, factors.data(), &n, pivot.data(), b.data(), &n, &info);
                    })});
  emit(runner, record, guards, whole);
}

void run_guards(Runner& runner) {
  namespace rolling = scenes::steady_rolling;
  const Elastic soft{.shear = 41000, .poisson = 0.45};
  for (const double change : {0.001, 0.01, 0.1})
    for (const double tolerance : {1e-6, 1e-10}) {
      resolve(runner, "identical half-spaces", rolling::steel, change, tolerance);
      resolve(runner, "dissimilar half-spaces", soft, change, tolerance);
    }
  prepare(runner, runner.quick ? 6 : 12);
}

}  // namespace

std::vector<Case> guard_cases() {
  return {{"guards", "shares of guards, checks and statistics in what they guard", run_guards}};
}

}  // namespace rollcon::bench
