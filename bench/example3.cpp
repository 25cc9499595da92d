// Measures the paper's example 3 on its four frames and with each scheme: cold from arrays to tractions, and the
// re-solve after a small change of creepage, its heap allocations counted.

#include "support/example3.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "memory.hpp"
#include "meshes.hpp"
#include "study.hpp"

namespace rollcon::bench {
namespace {

namespace example3 = scenes::example3;

/// Describes the paper's frames and others like them: discs of quadrilaterals around a core, discs of triangles in
/// equal rings, and triangles in rings graded to the contact's edge.
struct Frame {
  std::string element, name;
  int across;  ///< nodes from edge to edge of the contact, nearly
  SurfaceMesh mesh;
};

/// Makes `rings` equal rings; with 16 it is nearly the paper's disc.
SurfaceMesh equal_rings(ElementType type, int rings, double reach) {
  std::vector<double> radius;
  std::vector<int> count;
  for (int k = 1; k <= rings; ++k) {
    radius.push_back(reach * k / rings);
    count.push_back(std::min(6 * k, 4 * rings));
  }
  return frames::ring_disc(type, radius, count);
}

std::pair<std::string, SurfaceMesh> named(example3::NamedFrame frame) {
  return {std::move(frame.name), std::move(frame.mesh)};
}

std::vector<Frame> all_frames(bool quick) {
  std::vector<Frame> all;
  const double a = example3::hertz().a, reach = 1.3 * a;
  const auto add = [&](ElementType type, bool the_papers, int paper, int across, SurfaceMesh mesh) {
    Frame frame{surfaces::name_of(type), "", across, std::move(mesh)};
    if (the_papers) std::tie(frame.name, frame.mesh) = named(example3::frame(paper));
    all.push_back(std::move(frame));
  };
  for (const int core : {6, 8, 10, 12, 16, 20, 24}) {
    const auto disc = [&](ElementType type) { return frames::o_grid(type, core, (3 * core + 4) / 8, reach, reach); };
    const int across = core * 4 / 3;
    if (core >= 8 && core != 10) add(ElementType::quad4, core == 16, 673, across, disc(ElementType::quad4));
    if (core <= 16) add(ElementType::quad8, core == 16, 1985, 2 * across, disc(ElementType::quad8));
  }
  for (const int rings : {6, 8, 10, 12, 16, 20, 24}) {
    const int across = static_cast<int>(2 * rings / 1.3);
    if (rings >= 8 && rings != 10)
      add(ElementType::tri3, rings == 16, 703, across, equal_rings(ElementType::tri3, rings, reach));
    if (rings <= 16)
      add(ElementType::tri6, rings == 16, 2745, 2 * across, equal_rings(ElementType::tri6, rings, reach));
  }
  for (const FrameKind& kind : frame_kinds)
    for (const int across : {12, 16, 24, 32, 40})
      if (kind.rings)
        all.push_back({kind.name, "rings " + std::to_string(across / 2), across, frame_over(kind, across, a, a, 0)});
  for (Frame& frame : all)
    if (frame.name.empty()) frame.name = std::to_string(frame.mesh.nodes()) + " " + frame.element;
  if (quick) std::erase_if(all, [](const Frame& frame) { return frame.mesh.nodes() > 720; });
  return all;
}

void roll(Runner& runner, Study& study, const Frame& frame, const char* scheme) {
  Record record{.case_name = "example3", .method = scheme, .model = "half-space on rigid"};
  record.mesh = frame.name;
  record.element = frame.element;
  record.threads = runner.threads;
  record.quantity = "creepage at Ft = 0.75 mu Fn, turned like the force";
  const Solved solved = cold_solve(runner, record, [&] { return example3::pair(frame.mesh, scheme, runner.threads); });
  const scenes::Solution& s = solved.solution;
  scenes::RollingPair& pair = *solved.pair;
  const double p0 = *std::max_element(s.pressure.begin(), s.pressure.end());

  // The re-solves are driven by creepage, each after 1 % of change; the first one may still size workspaces. A
  // prediction would be the solution where the creepage is back where it came from.
  pair.option("warm_start", std::int64_t{1});
  pair.creep(s.creep[0], s.creep[1], 0);
  pair.solve();
  pair.creep(1.01 * s.creep[0], s.creep[1], 0);
  pair.solve();
  pair.creep(s.creep[0], s.creep[1], 0);
  const std::int64_t allocations = heap_allocations();
  const double warm = now();
  pair.solve();
  const double warm_seconds = now() - warm;
  record.extra = {{"p0", p0},
                  {"warm_seconds", warm_seconds},
                  {"warm_iterations", pair.stat("iterations")},
                  {"warm_heap_allocations", static_cast<double>(heap_allocations() - allocations)},
                  {"law_normal", pair.stat("law_normal")},
                  {"law_friction", pair.stat("law_friction")}};
  // This scheme comes nearest to what is known on graded rings (cases a and b).
  const bool trusted = frame.element.ends_with("rings") && record.method == "characteristic";
  const double a = example3::hertz().a;
  study.add(record, scenes::found_creepage(s, example3::mu * example3::load, a), frame.across, trusted);
}

void run(Runner& runner) {
  Study study;
  for (const Frame& frame : all_frames(runner.quick))
    for (const char* scheme : {"godunov", "least_squares", "characteristic"}) roll(runner, study, frame, scheme);
  study.emit(runner, symmetric_limit(study.limit()), "own extrapolation of graded rings, characteristic");
}

}  // namespace

std::vector<Case> example3_cases() {
  return {{"example3", "sphere on a rigid plane, the paper's four frames and others", run}};
}

}  // namespace rollcon::bench
