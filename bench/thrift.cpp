// Measures what each row of the plan saves: the same scene with the shortcut and without, in turn, several times;
// processor time and the library's own count of bytes, the least of each. docs/thrift.md shows the results.

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <memory>

#include "bench.hpp"
#include "support/example1.hpp"
#include "support/example3.hpp"
#include "support/steady_rolling.hpp"

namespace rollcon::bench {
namespace {

using scenes::RollingPair;
using PairPointer = std::unique_ptr<RollingPair>;

/// Returns the processor seconds of the process: other programs on the machine do not count.
double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Shortcut {
  std::string name, scene;
  std::function<PairPointer(bool with)> make;
  /// Runs what is timed; the pair is new.
  std::function<void(RollingPair&, bool with)> run;
  /// Does what comes before and is not timed.
  std::function<void(RollingPair&, bool with)> before = [](RollingPair&, bool) {};
  int times = 6;
};

struct Cost {
  double seconds = INFINITY, bytes = 0, kernels = 0, systems = 0, factorizations = 0;
  std::vector<std::array<double, 3>> traction;
};

void measure(const Shortcut& shortcut, bool with, Cost& cost) {
  const PairPointer pair = shortcut.make(with);
  shortcut.before(*pair, with);
  const double began = processor_seconds();
  shortcut.run(*pair, with);
  cost.seconds = std::min(cost.seconds, processor_seconds() - began);
  cost.bytes = pair->stat("peak_bytes");
  cost.kernels = pair->stat("kernel_evaluations");
  cost.systems = pair->stat("right_sides");
  cost.factorizations = pair->stat("factorizations");
  cost.traction = pair->solution().traction;
}

double difference(const Cost& a, const Cost& b) {
  double off = 0, scale = 0;
  for (std::size_t k = 0; k < a.traction.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c) {
      off = std::max(off, std::abs(a.traction[k][c] - b.traction[k][c]));
      scale = std::max(scale, std::abs(b.traction[k][c]));
    }
  return off / scale;
}

void compare(Runner& runner, const Shortcut& shortcut) {
  Cost cost[2];
  for (int i = 0; i < (runner.quick ? 1 : shortcut.times); ++i)
    for (const bool with : {i % 2 == 1, i % 2 == 0}) measure(shortcut, with, cost[with]);
  Record record{.case_name = "thrift", .method = shortcut.name, .model = shortcut.scene};
  record.nodes = static_cast<std::int64_t>(cost[1].traction.size());
  record.quantity = "time with over without";
  record.against = "the same scene without the shortcut";
  record.value = cost[1].seconds / cost[0].seconds;
  record.error = difference(cost[1], cost[0]);
  record.seconds = cost[1].seconds;
  record.extra = {{"seconds_without", cost[0].seconds},
                  {"seconds_with", cost[1].seconds},
                  {"bytes_with_over_without", cost[1].bytes / cost[0].bytes},
                  {"kernels_with_over_without", cost[0].kernels > 0 ? cost[1].kernels / cost[0].kernels : 0},
                  {"systems_without", cost[0].systems},
                  {"systems_with", cost[1].systems}};
  runner.emit(record);
}

void solve(RollingPair& pair, bool) {
  pair.solve();
}

PairPointer sphere(int nodes, int threads) {
  namespace example3 = scenes::example3;
  auto pair = example3::pair(example3::frame(nodes).mesh, "characteristic", threads);
  pair->option("tolerance", 1e-12).option("operators", "dense");
  return pair;
}

/// Makes case (b), or bodies of which one has another Poisson's ratio by `other`.
PairPointer case_b(int n, double other, int threads) {
  namespace rolling = scenes::steady_rolling;
  auto second = rolling::steel;
  second.poisson += other;
  auto pair = std::make_unique<RollingPair>(rolling::steel, second, threads);
  rolling::prepare(*pair, rolling::grid(n), "b");
  pair->option("tolerance", 1e-12).option("operators", "dense");
  return pair;
}

std::vector<Shortcut> shortcuts(const Runner& runner) {
  const bool quick = runner.quick;
  const int t = runner.threads;
  const int n = quick ? 11 : 24;
  const int nodes = 673;
  std::vector<Shortcut> all;
  all.push_back({"rigid body", "example 3 on a plane 1e18 times as stiff",
                 [=](bool with) {
                   namespace example3 = scenes::example3;
                   if (with) return sphere(nodes, t);
                   auto stiff = example3::sphere;
                   stiff.shear *= 1e18;
                   auto pair = std::make_unique<RollingPair>(example3::sphere, stiff, t);
                   const double curvature = 1 / (2 * example3::radius);
                   pair->frame(example3::frame(nodes).mesh).gap_quadratic(curvature, curvature);
                   pair->friction(example3::mu).load(example3::load).speed(example3::speed);
                   pair->tangential_force(ROLLCON_LONGITUDINAL, example3::force_ratio * example3::mu * example3::load);
                   pair->option("convection", "characteristic").option("tolerance", 1e-12);
                   pair->option("operators", "dense");
                   return pair;
                 },
                 solve});
  all.push_back({"no friction", "example 3, mu = 0 against 1e-13",
                 [=](bool with) {
                   auto pair = sphere(nodes, t);
                   pair->creep(0, 0, 0).friction(with ? 0 : 1e-13);
                   return pair;
                 },
                 solve});
  all.push_back({"equal constants", "case (b), nu of body 2 off by 2e-11",
                 [=](bool with) { return case_b(n, with ? 0 : 2e-11, t); }, solve});
  all.push_back({"same body twice", "example 1, boundary elements",
                 [=](bool with) {
                   namespace example1 = scenes::example1;
                   const auto shape = example1::bem_ring(quick ? 6 : 8);
                   const auto ring = example1::ring_body(shape, ElementType::quad4);
                   scenes::MeshedBody other = ring;
                   other.material->shear *= 1 + 1e-14;
                   auto pair = example1::pair(ring, with ? scenes::AnyBody(scenes::TwinBody{}) : scenes::AnyBody(other),
                                              "characteristic", t);
                   return pair;
                 },
                 solve, [](RollingPair&, bool) {}, 2});
  for (const bool example1 : {false, true})
    all.push_back({"unchanged scene", example1 ? "example 1, another creepage" : "example 3, another load",
                   [=](bool) {
                     if (!example1) return sphere(nodes, t);
                     namespace e1 = scenes::example1;
                     auto pair = e1::pair(e1::bem_ring(quick ? 6 : 8), ElementType::quad4, "characteristic", t);
                     pair->option("tolerance", 1e-12);
                     return pair;
                   },
                   [=](RollingPair& pair, bool) {
                     if (example1)
                       pair.creep(-2e-3, 0, 0).solve();
                     else
                       pair.load(0.98 * scenes::example3::load).solve();
                   },
                   [](RollingPair& pair, bool with) {
                     if (with) pair.solve();
                   },
                   example1 ? 2 : 5});
  all.push_back({"regular frame", "case (b), rows from a table",
                 [=](bool with) {
                   auto pair = case_b(n, 0, t);
                   pair->option("operators", with ? "table" : "dense").option("tolerance", 1e-8);
                   return pair;
                 },
                 solve, [](RollingPair&, bool) {}, 3});
  if (rollcon_has_feature("fftw"))
    all.push_back({"regular frame", "case (b), FFT",
                   [=](bool with) {
                     auto pair = case_b(quick ? 24 : 48, 0, t);
                     pair->option("operators", with ? "fft" : "dense").option("tolerance", 1e-8);
                     return pair;
                   },
                   solve, [](RollingPair&, bool) {}, 2});
  all.push_back({"results not asked for", "example 3: all fields, laws, displacements, estimates",
                 [=](bool) { return sphere(nodes, t); },
                 [](RollingPair& pair, bool with) {
                   pair.solve();
                   if (with) return;
                   pair.solution();
                   pair.stat("law_slip");
                   pair.stat("error_estimate");
                   std::vector<double> u(3 * 4096);
                   for (const std::int32_t which : {ROLLCON_FIELD_DISPLACEMENT1, ROLLCON_FIELD_DISPLACEMENT2})
                     rollcon_contact_get_field(pair.handle(), which, ROLLCON_LOCAL, static_cast<std::int64_t>(u.size()),
                                               u.data(), nullptr);
                 },
                 [](RollingPair&, bool) {}, 3});
  return all;
}

void run(Runner& runner) {
  for (const Shortcut& shortcut : shortcuts(runner)) compare(runner, shortcut);
}

}  // namespace

std::vector<Case> thrift_cases() {
  return {{"thrift", "what each shortcut of the plan saves in time and memory", run}};
}

}  // namespace rollcon::bench
