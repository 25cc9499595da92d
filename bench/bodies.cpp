// Measures boundary-element bodies: the paper's two rings and its wheel on a rail, the loaded ring against its Fourier
// solution, and how the phases of a body's preparation grow.

#include <algorithm>
#include <cmath>

#include "bench.hpp"
#include "support/example1.hpp"
#include "support/example4.hpp"
#include "support/mid_plane.hpp"

namespace rollcon::bench {
namespace {

namespace example1 = scenes::example1;
namespace example4 = scenes::example4;

void add_body(Record& record, const scenes::RollingPair& pair) {
  for (const char* phase : {"assembly", "factor", "condense"})
    record.phase_seconds.emplace_back(phase, pair.body_stat(1, (std::string("seconds_") + phase).c_str()));
  for (const char* name : {"unknowns", "condition", "kernel_evaluations", "peak_bytes"})
    record.extra.emplace_back(std::string("body_") + name, pair.body_stat(1, name));
  record.peak_bytes += static_cast<std::int64_t>(pair.body_stat(1, "peak_bytes"));
}

double warm_seconds(scenes::RollingPair& pair, const scenes::Solution& s) {
  // The first re-solve with creepages given may still size workspaces. A prediction would be the solution where the
  // creepage is back where it came from.
  pair.option("warm_start", std::int64_t{1});
  for (const double factor : {1.0, 1.01, 1.0}) {
    pair.creep(factor * s.creep[0], factor * s.creep[1], factor * s.creep[2]);
    pair.solve();
  }
  const double began = now();
  pair.creep(1.01 * s.creep[0], s.creep[1], s.creep[2]);
  pair.solve();
  return now() - began;
}

double mid_plane_pressure(const scenes::Solution& s) {
  return scenes::mid_plane(s, example1::paper_ring().zone, example1::width).p0;
}

void rings(Runner& runner) {
  struct Mesh {
    ElementType type;
    int parts;
  };
  std::vector<Mesh> meshes{{ElementType::quad4, 6}, {ElementType::quad4, 12}, {ElementType::quad4, 18},
                           {ElementType::tri3, 12}, {ElementType::quad8, 4},  {ElementType::quad8, 6},
                           {ElementType::quad8, 8}, {ElementType::quad9, 6},  {ElementType::tri6, 6}};
  if (runner.quick) meshes.resize(2);
  for (const Mesh& mesh : meshes)
    for (const char* scheme : {"characteristic", "least_squares", "godunov"}) {
      Record record{.case_name = "rings", .method = scheme, .model = "BEM on BEM"};
      const double began = now();
      auto pair = example1::pair(example1::bem_ring(mesh.parts), mesh.type, scheme, runner.threads);
      const auto s = timed_solve(*pair, record, began);
      record.mesh = surfaces::name_of(mesh.type) + ", " +
                    std::to_string(std::lround(pair->body_stat(1, "unknowns") / 3)) + " nodes, zone " +
                    std::to_string(mesh.parts) + " x " + std::to_string(mesh.parts);
      record.threads = runner.threads;
      record.quantity = "creepage at Ft = 0.6271 mu Fn";
      record.against = "finite elements, 36 x 12 hex20 in the zone";
      record.value = s.creep[0];
      record.error = s.creep[0] / example1::fine_creepage - 1;
      add_body(record, *pair);
      record.extra.emplace_back("p0_mid_plane", mid_plane_pressure(s));
      record.extra.emplace_back("p0_over_fine", mid_plane_pressure(s) / example1::fine_p0);
      record.extra.emplace_back("warm_seconds", warm_seconds(*pair, s));
      record.extra.emplace_back("warm_iterations", pair->stat("iterations"));
      runner.emit(record);
      if (runner.quick) break;
    }
}

void wheel(Runner& runner) {
  Record record{.case_name = "wheel", .method = "characteristic", .model = "BEM on rigid surface"};
  const double began = now();
  auto pair = example4::pair(ElementType::quad4, "characteristic", runner.threads);
  pair->friction(example4::mu).creep(-9e-4, 0, 0);
  const auto s = timed_solve(*pair, record, began);
  record.mesh = "1954 quad4 nodes, zone 14 x 15";
  record.threads = runner.threads;
  record.quantity = "force at 0.015 mm";
  record.against = "the paper's 457 N, profile unknown";
  record.value = -s.force[2];
  record.error = -s.force[2] / 457 - 1;
  add_body(record, *pair);
  record.extra.emplace_back("p0", pair->stat("max_pressure"));
  record.extra.emplace_back("warm_seconds", warm_seconds(*pair, s));
  runner.emit(record);
}

void growth(Runner& runner) {
  std::vector<int> parts{8, 10, 12, 14, 20, 24, 28};
  if (runner.threads > 1) parts.resize(5);  // up to 4000 nodes, for which more threads are asked
  if (runner.quick) parts.resize(2);
  for (const int n : parts) {
    Record record{.case_name = "growth", .method = "characteristic", .model = "BEM on BEM"};
    const double began = now();
    auto pair = example1::pair(example1::bem_ring(n), ElementType::quad4, "characteristic", runner.threads);
    const auto s = timed_solve(*pair, record, began);
    record.mesh = "quad4, " + std::to_string(std::lround(pair->body_stat(1, "unknowns") / 3)) + " nodes";
    record.threads = runner.threads;
    record.quantity = "mid-plane p0";
    record.against = "Hertz, plane problem";
    record.value = mid_plane_pressure(s);
    record.error = record.value / example1::hertz_p0 - 1;
    add_body(record, *pair);
    runner.emit(record);
  }
}

}  // namespace

std::vector<Case> body_cases() {
  return {{"rings", "two equal rings, the paper's example 1: meshes and schemes", rings},
          {"wheel", "wheel on a rigid rail head, the paper's example 4", wheel},
          {"growth", "boundary-element bodies from 500 to 8000 nodes: seconds of each phase", growth}};
}

}  // namespace rollcon::bench
