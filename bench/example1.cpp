// Measures the paper's example 1, two equal rings: creepage over element size, by boundary and by finite elements and
// by one ring of each.

#include "support/example1.hpp"

#include "meshes.hpp"
#include "study.hpp"
#include "support/mid_plane.hpp"

namespace rollcon::bench {
namespace {

namespace example1 = scenes::example1;

/// Takes as `parts` the elements along and across the zone, odd or even.
scenes::MeshedBody ring(const BodyKind& kind, int parts) {
  const surfaces::Ring shape = ring_shape(example1::paper_ring().zone, parts, kind.volume);
  scenes::MeshedBody body = meshed_ring(shape, kind, example1::material);
  example1::hold(body, shape);
  return body;
}

Record blank(const Runner& runner, const std::string& model, const std::string& element) {
  Record record{.case_name = "example1", .model = model};
  record.element = element;
  record.threads = runner.threads;
  record.quantity = "creepage at Ft = 0.6271 mu Fn, turned like the force";
  return record;
}

/// Lays lines graded to the edges of the contact on top of the first ring.
SurfaceMesh graded_frame(int lines) {
  SurfaceMesh frame = graded_strip(example1::hertz_a, example1::width, lines);
  for (Vec3& x : frame.node) x[2] = example1::radius;
  return frame;
}

/// Adds a reference with lines graded to the edges of the contact, laid on rings of quadratic elements, because the
/// contact's own mesh limits the creepage more than the bodies' meshes do.
void add_reference(FrameLimits& limits, const BodyKind& kind, int parts, int coarse, int lines, int threads) {
  add_frame_limits(
      limits, parts, coarse, lines,
      [&](int n) { return example1::pair(ring(kind, n), scenes::TwinBody{}, "characteristic", threads); },
      [](scenes::RollingPair& pair, int n) {
        pair.frame(graded_frame(n)).solve();
        const scenes::Solution s = pair.solution();
        return std::vector{s.creep[0], s.approach};
      });
}

void solve(Runner& runner, Study& study, const Record& start, double across, const MakePair& make) {
  const double zone = example1::paper_ring().zone;
  solve_by_schemes(runner, start, make, [&](Record& record, const Solved& solved) {
    record.extra.emplace_back("approach", solved.solution.approach);
    record.extra.emplace_back("p0", scenes::mid_plane(solved.solution, zone, example1::width).p0);
    study.add(record, scenes::found_creepage(solved.solution, example1::mu * example1::load, example1::arm), across);
  });
}

/// Takes the first ring's zone as the frame.
void solve_on_zone(Runner& runner, Study& study, Record start, const scenes::MeshedBody& ring1,
                   const scenes::AnyBody& ring2, int parts, bool quadratic) {
  start.mesh = start.element + ", zone " + std::to_string(parts) + " x " + std::to_string(parts);
  const double across = 2 * example1::hertz_a / example1::paper_ring().zone * parts * (quadratic ? 2 : 1);
  solve(runner, study, start, across, [&] { return example1::pair(ring1, ring2, "characteristic", runner.threads); });
}

/// Lays frames graded to the contact's edges on one mesh of the rings.
void solve_on_graded(Runner& runner, Study& study, Record start, const BodyKind& kind, int parts) {
  const scenes::MeshedBody body = ring(kind, parts);
  start.element = "laid on " + kind.name;
  for (const int lines : {8, 12, 16, 20, 24}) {
    if (runner.quick && lines > 12) continue;
    start.mesh = std::to_string(lines) + " graded lines on " + kind.name + ", zone " + std::to_string(parts) + " x " +
                 std::to_string(parts);
    solve(runner, study, start, lines, [&] {
      auto pair = example1::pair(body, scenes::TwinBody{}, "characteristic", runner.threads);
      pair->frame(graded_frame(lines));
      return pair;
    });
  }
}

std::vector<int> sizes(bool quadratic, bool quick) {
  if (quick) return quadratic ? std::vector{3, 4} : std::vector{6, 8};
  return quadratic ? std::vector{2, 3, 4, 5, 6} : std::vector{4, 6, 8, 10, 12};
}

void run(Runner& runner) {
  Study study;
  FrameLimits limits;
  const auto boundary = boundary_elements(), finite = finite_elements();
  const auto& quad4 = boundary[0];
  const auto& quad8 = boundary[2];
  const auto& hex8 = finite[0];
  const auto& hex20 = finite[3];
  const int lines = runner.quick ? 16 : 32;
  add_reference(limits, quad8, runner.quick ? 4 : 8, runner.quick ? 3 : 6, lines, runner.threads);
  add_reference(limits, hex20, runner.quick ? 4 : 10, runner.quick ? 3 : 7, lines, runner.threads);
  for (const BodyKind& kind : boundary)
    for (const int n : sizes(kind.quadratic, runner.quick))
      solve_on_zone(runner, study, blank(runner, "BEM on BEM", kind.name), ring(kind, n), scenes::TwinBody{}, n,
                    kind.quadratic);
  for (const BodyKind& kind : finite)
    for (const int n : sizes(kind.quadratic, runner.quick))
      solve_on_zone(runner, study, blank(runner, "FEM on FEM", kind.name), ring(kind, n), scenes::TwinBody{}, n,
                    kind.quadratic);
  for (const auto& [volume, surface] : {std::pair{hex8, quad4}, {hex20, quad8}})
    for (const int n : sizes(volume.quadratic, runner.quick))
      solve_on_zone(runner, study, blank(runner, "FEM on BEM", volume.name + " on " + surface.name), ring(volume, n),
                    ring(surface, n), n, volume.quadratic);
  solve_on_graded(runner, study, blank(runner, "BEM on BEM", ""), quad8, runner.quick ? 3 : 4);
  solve_on_graded(runner, study, blank(runner, "FEM on FEM", ""), hex20, runner.quick ? 4 : 6);
  study.compare("approach", combine(limits[1]));
  study.emit(runner, symmetric_limit(combine(limits[0])), "own extrapolation, frames graded to the contact's edges");
}

}  // namespace

std::vector<Case> example1_cases() {
  return {{"example1", "two equal rings, the paper's example 1: every element, BEM and FEM", run}};
}

}  // namespace rollcon::bench
