// Compares sections, finite elements and boundary elements on the paper's example 1: errors of all components over
// processor time, all on one frame.

#include <array>
#include <cmath>
#include <ctime>

#include "bench.hpp"
#include "meshes.hpp"
#include "support/example1.hpp"
#include "support/mid_plane.hpp"

namespace rollcon::bench {
namespace {

namespace example1 = scenes::example1;

struct Made {
  std::string model, mesh;
  scenes::MeshedBody ring;
};

/// Returns n x n quad8 of the ring's section, fine at its ends, in the plane x = 0.
scenes::MeshedBody section(int n) {
  surfaces::Block block;
  for (int k = 0; k <= n; ++k) {
    const double c = std::cos(std::acos(-1.0) * k / n);
    block.line[0].push_back(-example1::width / 2 * c);
    block.line[1].push_back(37.5 - 12.5 * c);
  }
  block.line[2] = {0, 1};
  scenes::MeshedBody body =
      scenes::meshed(surfaces::part_with_tag(surfaces::block(block, ElementType::quad8), 6), example1::material);
  for (Vec3& x : body.mesh.node) x = {0, x[0], x[1]};
  std::fill(body.mesh.tag.begin(), body.mesh.tag.end(), 0);
  body.turned = true;
  return body;
}

std::vector<Made> all_meshes(bool quick) {
  std::vector<Made> all;
  for (const int n : quick ? std::vector{6} : std::vector{6, 8, 12, 16, 20})
    all.push_back({"section", std::to_string(n) + " x " + std::to_string(n) + " quad8", section(n)});
  for (const int n : quick ? std::vector{4} : std::vector{4, 6, 8, 10})
    all.push_back({"hex20", "zone " + std::to_string(n) + " x " + std::to_string(n),
                   example1::ring_body(example1::fem_ring(n), VolumeType::hex20)});
  for (const int n : quick ? std::vector{4} : std::vector{4, 6, 8})
    all.push_back({"quad8, BEM", "zone " + std::to_string(n) + " x " + std::to_string(n),
                   example1::ring_body(example1::bem_ring(n), ElementType::quad8)});
  return all;
}

/// Holds the pressure in the middle, the approach, and the creepages under tangential forces along and across.
using Answers = std::array<double, 4>;

Answers solve(const scenes::MeshedBody& ring, Record& record, int threads) {
  Answers found{};
  const double began = now(), used = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  auto pair = example1::pair(ring, scenes::TwinBody{}, "characteristic", threads);
  SurfaceMesh frame = graded_strip(example1::hertz_a, example1::width, 24);
  for (Vec3& x : frame.node) x[2] = example1::radius;
  pair->frame(frame);
  const auto s = timed_solve(*pair, record, began);
  found = {scenes::mid_plane(s, example1::paper_ring().zone, example1::width).p0, s.approach, s.creep[0], 0};
  record.extra.emplace_back("processor", static_cast<double>(std::clock()) / CLOCKS_PER_SEC - used);
  record.extra.emplace_back("body_unknowns", pair->body_stat(1, "unknowns"));
  rollcon_contact_prescribe(pair->handle(), ROLLCON_LONGITUDINAL, ROLLCON_BY_MOTION, 0);
  pair->tangential_force(ROLLCON_LATERAL, example1::force_ratio * example1::mu * example1::load).solve();
  found[3] = pair->solution().creep[1];
  return found;
}

}  // namespace

void ring_sections(Runner& runner) {
  Record unused;
  const Answers fine = solve(section(runner.quick ? 8 : 24), unused, runner.threads);
  for (const Made& made : all_meshes(runner.quick)) {
    Record record{.case_name = "ring_sections", .method = "characteristic", .model = made.model, .mesh = made.mesh};
    const Answers found = solve(made.ring, record, runner.threads);
    record.threads = runner.threads;
    record.quantity = "creepage at Ft = 0.6271 mu Fn";
    record.against = "section of 24 x 24 quad8, the same frame";
    record.value = found[2];
    record.error = found[2] / fine[2] - 1;
    record.extra.emplace_back("p0", found[0] / fine[0] - 1);
    record.extra.emplace_back("approach", found[1] / fine[1] - 1);
    record.extra.emplace_back("lateral", found[3] / fine[3] - 1);
    record.extra.emplace_back("fine_p0", fine[0] / example1::fine_p0 - 1);
    record.extra.emplace_back("fine_creepage", fine[2] / example1::fine_creepage - 1);
    runner.emit(record);
  }
}

}  // namespace rollcon::bench
