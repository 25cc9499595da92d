// Measures the paper's example 2, a ring of finite elements on a half-space or on a block of boundary elements:
// creepage over element size.

#include "support/example2.hpp"

#include "meshes.hpp"
#include "study.hpp"
#include "support/mid_plane.hpp"

namespace rollcon::bench {
namespace {

namespace example2 = scenes::example2;

constexpr double side = 80, depth = 40;  ///< size of the block

/// Takes as `parts` the elements along and across the zone.
scenes::MeshedBody ring(const BodyKind& kind, int parts) {
  const surfaces::Ring shape = ring_shape(example2::ring_of().zone, parts, kind.volume);
  scenes::MeshedBody body = meshed_ring(shape, kind, example2::ring);
  body.held_tag = {3};
  body.contact_tag = {1, 2};
  return body;
}

/// Puts as many elements below the ring's zone as there are in it.
scenes::MeshedBody ground(const BodyKind& kind, int parts) {
  surfaces::Block b;
  b.line[0] = lines_with_zone(example2::ring_of().zone / 2, parts, std::max(2, parts / 4), side / 2);
  b.line[1] = lines_with_zone(example2::width / 2, parts, std::max(2, parts / 4), side / 2);
  b.line[2] = surfaces::graded_to(std::max(2, parts / 4), -depth, 0, 1);
  b.tag = {4, 5, 6, 7, 3, 1};
  scenes::MeshedBody body = meshed_block(b, kind, example2::ground);
  body.held_tag = {3};
  body.contact_tag = {1};
  return body;
}

std::unique_ptr<scenes::RollingPair> roll(const scenes::MeshedBody& ring1, const scenes::AnyBody& body2, int threads) {
  auto p = std::make_unique<scenes::RollingPair>(ring1, body2, threads);
  // The ring stands on its top, the ground lies above it.
  if (std::holds_alternative<scenes::MeshedBody>(body2))
    p->pose(2, {{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}}, {0, 0, example2::radius});
  p->axes({0, 0, example2::radius}, {1, 0, 0}, {0, 0, 1}).frame_from_body(1, 2);
  p->friction(example2::mu).load(example2::load).speed(example2::speed);
  p->tangential_force(ROLLCON_LONGITUDINAL, example2::force_ratio * example2::mu * example2::load);
  return p;
}

/// Lays lines graded to the edges of the contact on top of the ring.
SurfaceMesh graded_frame(int lines) {
  SurfaceMesh frame = graded_strip(example2::hertz.a, example2::width, lines);
  for (Vec3& x : frame.node) x[2] = example2::radius;
  return frame;
}

/// Adds a reference with such lines on a fine ring.
void add_reference(FrameLimits& limits, const BodyKind& kind, int parts, int coarse, const scenes::AnyBody& body2,
                   int lines, int threads) {
  add_frame_limits(
      limits, parts, coarse, lines, [&](int n) { return roll(ring(kind, n), body2, threads); },
      [](scenes::RollingPair& pair, int n) {
        pair.frame(graded_frame(n)).solve();
        const scenes::Solution s = pair.solution();
        return std::vector{s.creep[0], s.approach};
      });
}

std::vector<int> sizes(bool quadratic, bool quick) {
  if (quick) return quadratic ? std::vector{4} : std::vector{6, 8};
  return quadratic ? std::vector{2, 3, 4, 5, 6} : std::vector{4, 6, 8, 10, 12};
}

void run(Runner& runner) {
  const auto boundary = boundary_elements(), finite = finite_elements();
  const BodyKind &quad4 = boundary[0], &quad8 = boundary[2];
  const double zone = example2::ring_of().zone;
  for (const bool on_block : {false, true}) {
    Study study;
    const auto body2 = [&](bool quadratic, int parts) -> scenes::AnyBody {
      if (!on_block) return scenes::HalfspaceBody{example2::ground};
      return quadratic ? ground(quad8, parts) : ground(quad4, parts);
    };
    FrameLimits limits;
    for (const BodyKind& kind : finite)
      if (kind.name == "hex20" || kind.name == "wedge15") {
        if (runner.quick)
          add_reference(limits, kind, 4, 3, body2(true, 4), 12, runner.threads);
        else
          add_reference(limits, kind, 8, 6, body2(true, 5), 32, runner.threads);
      }
    Record blank{.case_name = "example2"};
    blank.model = on_block ? "FEM on BEM block" : "FEM on half-space";
    blank.threads = runner.threads;
    blank.quantity = "creepage at Ft = 0.5373 mu Fn, turned like the force";
    const auto solve = [&](double across, const MakePair& make) {
      solve_by_schemes(runner, blank, make, [&](Record& record, const Solved& solved) {
        record.extra.emplace_back("approach", solved.solution.approach);
        record.extra.emplace_back("p0", scenes::mid_plane(solved.solution, zone, example2::width).p0);
        const scenes::Solution& s = solved.solution;
        study.add(record, scenes::found_creepage(s, example2::mu * example2::load, example2::arm), across);
      });
    };
    const auto zone_name = [](const std::string& element, int n) {
      return element + ", zone " + std::to_string(n) + " x " + std::to_string(n);
    };
    for (const BodyKind& kind : finite)
      for (const int n : sizes(kind.quadratic, runner.quick)) {
        blank.element = kind.name;
        blank.mesh = zone_name(kind.name, n);
        const scenes::MeshedBody ring1 = ring(kind, n);
        const scenes::AnyBody under = body2(kind.quadratic, n);
        solve(2 * example2::hertz.a / zone * n * (kind.quadratic ? 2 : 1),
              [&] { return roll(ring1, under, runner.threads); });
      }
    const BodyKind& hex20 = finite[3];
    const int parts = runner.quick ? 4 : 6;
    const scenes::MeshedBody ring1 = ring(hex20, parts);
    const scenes::AnyBody under = body2(true, 4);
    for (const int lines : {8, 12, 16, 20, 24}) {
      if (runner.quick && lines > 12) continue;
      blank.element = "laid on hex20";
      blank.mesh = std::to_string(lines) + " graded lines on " + zone_name("hex20", parts);
      solve(lines, [&] {
        auto pair = roll(ring1, under, runner.threads);
        pair->frame(graded_frame(lines));
        return pair;
      });
    }
    study.compare("approach", combine(limits[1]));
    study.emit(runner, symmetric_limit(combine(limits[0])), "own extrapolation, frames graded to the contact's edges");
  }
}

}  // namespace

std::vector<Case> example2_cases() {
  return {{"example2", "ring of finite elements on a half-space or block, the paper's example 2", run}};
}

}  // namespace rollcon::bench
