// Measures frictionless contact of a rigid sphere with a block of boundary or of finite elements, the frame being the
// block's own faces: approach over element size.

#include <cmath>

#include "meshes.hpp"
#include "study.hpp"
#include "support/example3.hpp"
#include "support/graded_disc.hpp"
#include "support/hertz_fit.hpp"

namespace rollcon::bench {
namespace {

namespace example3 = scenes::example3;

constexpr double side = 10, depth = 5, zone = 2.5;

/// Makes a block with n elements along the zone, held at its bottom.
scenes::MeshedBody block(const BodyKind& kind, int n) {
  scenes::MeshedBody body =
      meshed_zone_block({side, depth, zone, n, (n + 1) / 2, kind.volume ? n : (n + 1) / 2}, kind, example3::sphere);
  body.held_tag = {3};
  body.contact_tag = {2};
  return body;
}

std::vector<int> sizes(const BodyKind& kind, bool quick) {
  if (quick) return kind.quadratic ? std::vector{3, 4} : std::vector{4, 6};
  if (kind.volume) return kind.quadratic ? std::vector{2, 3, 4, 6, 8} : std::vector{4, 6, 8, 10, 14};
  return kind.quadratic ? std::vector{2, 3, 4, 5, 6} : std::vector{4, 6, 8, 10, 12};
}

std::unique_ptr<scenes::RollingPair> press(const scenes::MeshedBody& body, int threads) {
  auto pair = std::make_unique<scenes::RollingPair>(body, scenes::RigidBody{}, threads);
  const double curvature = 1 / (2 * example3::radius);
  pair->frame_from_body(1, 2).gap_quadratic(curvature, curvature);
  pair->friction(0).load(example3::load);
  return pair;
}

/// Adds a reference with rings graded to the edge of the contact, laid on a fine block: approach and largest pressure.
void add_reference(FrameLimits& limits, const BodyKind& kind, int parts, int coarse, int rings, int threads) {
  const closed_forms::Hertz hertz = example3::hertz();
  add_frame_limits(
      limits, parts, coarse, rings, [&](int n) { return press(block(kind, n), threads); },
      [&](scenes::RollingPair& pair, int n) {
        pair.frame(scenes::graded_disc(hertz.a, hertz.a, n)).solve();
        const scenes::Solution s = pair.solution();
        return std::vector{s.approach, scenes::fit_hertz(s, hertz.a, hertz.a).p0};
      });
}

void run(Runner& runner) {
  std::vector<BodyKind> kinds = boundary_elements();
  for (BodyKind& kind : finite_elements()) kinds.push_back(std::move(kind));
  const closed_forms::Hertz hertz = example3::hertz();
  Study study;
  for (const BodyKind& kind : kinds)
    for (const int n : sizes(kind, runner.quick)) {
      Record record{.case_name = "hertz_block", .method = "frictionless"};
      record.model = kind.volume ? "FEM block" : "BEM block";
      record.element = kind.name;
      record.mesh = kind.name + ", zone " + std::to_string(n) + " x " + std::to_string(n);
      record.threads = runner.threads;
      record.quantity = "approach at given force";
      const scenes::MeshedBody body = block(kind, n);
      const auto s = cold_solve(runner, record, [&] { return press(body, runner.threads); }).solution;
      record.value = s.approach;
      const scenes::FittedEllipse fit = scenes::fit_hertz(s, hertz.a, hertz.a);
      record.extra.emplace_back("p0", fit.p0);
      record.extra.emplace_back("a", std::sqrt(fit.a * fit.b));
      study.add(record, n);
    }
  FrameLimits limits;
  for (const BodyKind& kind : kinds)
    if (kind.name == "quad8" || kind.name == "wedge15") {
      const int parts = runner.quick ? 4 : 6;
      add_reference(limits, kind, parts, parts - 2, runner.quick ? 8 : 12, runner.threads);
    }
  study.compare("p0", combine(limits[1]));
  study.emit(runner, combine(limits[0]), "own extrapolation, frames graded to the contact's edge");
}

}  // namespace

std::vector<Case> hertz_block_cases() {
  return {{"hertz_block", "rigid sphere on a block: every element, BEM and FEM", run}};
}

}  // namespace rollcon::bench
