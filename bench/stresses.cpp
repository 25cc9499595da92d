// Measures stresses inside half-spaces: points per second below grids and irregular frames, near the surface and far
// from it.

#include <algorithm>
#include <cmath>

#include "bench.hpp"
#include "meshes.hpp"
#include "support/frames.hpp"
#include "support/scene.hpp"

namespace rollcon::bench {
namespace {

using scenes::RollingPair;

const closed_forms::Elastic steel{.shear = 82000, .poisson = 0.28};

/// Solves a contact of semi-axes 1 in the middle of a frame that reaches to 1.1.
std::unique_ptr<RollingPair> solved(const Runner& runner, const SurfaceMesh& mesh) {
  const double e_star = closed_forms::effective_modulus(steel, steel);
  const closed_forms::Hertz circle = closed_forms::hertz_from_axes(1, 1, 1000, e_star);
  auto pair = std::make_unique<RollingPair>(steel, steel, runner.threads);
  pair->frame(mesh).gap_quadratic(circle.A, circle.B).friction(0.3);
  pair->approach(circle.approach).creep(1e-3, 0, 0).option("tolerance", 1e-6);
  pair->solve();
  return pair;
}

struct Block {
  const char* name;
  int nx, ny, nz;
  double from, to;  ///< depth
  double shift;     ///< shift from place to place, in cells; negative: on no grid
};

std::vector<double> points_of(const Block& block, int cells) {
  const double h = 2.2 / cells;
  std::vector<double> xyz;
  for (int k = 0; k < block.nz; ++k)
    for (int j = 0; j < block.ny; ++j)
      for (int i = 0; i < block.nx; ++i) {
        const double u = block.shift < 0 ? 0.3 * std::sin(i + 3.0 * j + 7.0 * k) : block.shift;
        const double depth = block.nz > 1 ? block.from + (block.to - block.from) * k / (block.nz - 1) : block.from;
        xyz.insert(xyz.end(), {-1.1 + (i + u) * h, -1.1 + (j + u) * h, -depth});
      }
  return xyz;
}

void measure(Runner& runner, RollingPair& pair, const std::string& mesh, int cells, const Block& block) {
  const std::vector<double> xyz = points_of(block, cells);
  const auto n = static_cast<std::int64_t>(xyz.size() / 3);
  std::vector<double> stress(2 * xyz.size()), u(xyz.size());
  Record record{.case_name = "stresses", .method = "halfspace", .model = block.name, .mesh = mesh};
  record.threads = runner.threads;
  record.quantity = "seconds";
  record.against = "none";
  record.seconds = 1e300;
  for (int run = 0; run < 3; ++run) {
    const double began = now();
    record.status =
        rollcon_contact_get_fields_at(pair.handle(), 1, n, xyz.data(), ROLLCON_IN_CONTACT, u.data(), stress.data());
    record.seconds = std::min(record.seconds, now() - began);
  }
  std::int64_t loaded = 0;
  const scenes::Solution s = pair.solution();
  for (const std::int32_t state : s.state) loaded += state == ROLLCON_STICK || state == ROLLCON_SLIP ? 1 : 0;
  rollcon_contact_get_size(pair.handle(), &record.nodes, &record.elements);
  record.value = record.seconds;
  const auto points = static_cast<double>(n);
  record.extra = {{"points", points},
                  {"us_per_point", 1e6 * record.seconds / points},
                  {"loaded_nodes", static_cast<double>(loaded)},
                  {"pairs_per_second", points * static_cast<double>(record.elements) / record.seconds},
                  {"loaded_pairs_per_second", points * static_cast<double>(loaded) / record.seconds}};
  runner.emit(record);
}

void run(Runner& runner) {
  const int cells = runner.quick ? 16 : 64, deep = runner.quick ? 4 : 32;
  const Block blocks[] = {{"block below the nodes", cells, cells, deep, 0, 2, 0},
                          {"block, moved by 0.3 cells", cells, cells, deep, 0, 2, 0.3},
                          {"surface, off the grid", cells, cells, 1, 0, 0, -1},
                          {"depth 0.1, off the grid", cells, cells, 1, 0.1, 0.1, -1},
                          {"depth 0.5, off the grid", cells, cells, 1, 0.5, 0.5, -1},
                          {"depth 2, off the grid", cells, cells, 1, 2, 2, -1},
                          {"line of 100 points", 1, 1, 100, 0, 2, 0}};
  const std::vector<double> line = frames::uniform_lines(-1.1, 1.1, cells);
  const SurfaceMesh grid = frames::rectangle(ElementType::quad4, line, line);
  const auto on_grid = solved(runner, grid);
  for (const Block& block : blocks) measure(runner, *on_grid, "grid " + std::to_string(cells), cells, block);
  const SurfaceMesh disc = frames::o_grid(ElementType::quad8, 16, 6, 1.1, 1.1);
  const auto on_disc = solved(runner, disc);
  for (const Block& block : blocks)
    if (block.nz == 1 || block.nx == 1) measure(runner, *on_disc, "disc of 640 quad8", cells, block);
}

}  // namespace

std::vector<Case> stress_cases() {
  return {{"stresses", "stresses inside half-spaces: blocks, layers and lines of points", run}};
}

}  // namespace rollcon::bench
