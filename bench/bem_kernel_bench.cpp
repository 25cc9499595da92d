// The boundary integrals alone: point evaluations per second of the far kernel (T and U together,
// all shape functions) for each instruction set, the cost of one pair of point and element near,
// on and far from each other, and all rows of a ring of about the size of the paper's first
// example.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "bodies/bem/boundary_integrals.hpp"
#include "bodies/bem/near_field.hpp"
#include "bodies/bem/rule_tables.hpp"
#include "support/surface_meshes.hpp"

namespace rollcon {
namespace {

using halfspace::InstructionSet;

bool unavailable(benchmark::State& state, InstructionSet set) {
  if (set <= halfspace::best_instruction_set()) return false;
  state.SkipWithError("not on this processor");
  return true;
}

/// Eight points far from the elements of a sphere; the smallest rule of order 4.
void far_kernel(benchmark::State& state, ElementType type, InstructionSet set) {
  if (unavailable(state, set)) return;
  const SurfaceMesh mesh = surfaces::cube_sphere(type, 4, 1);
  std::vector<bem::ElementGeometry> elements;
  for (std::int64_t e = 0; e < mesh.elements(); ++e)
    elements.push_back(bem::element_geometry(mesh, e, 1));
  const bem::Kernels& kernels = bem::kelvin_kernels(set);
  const bem::KelvinConstants constants(0.3);
  const int n = corner_count(type) == 3 ? 4 : is_quadratic(type) ? 3 : 2;
  const bem::RuleTable& table = bem::rule_table(type, n, n);
  bem::PointPack pack;
  for (std::size_t p = 0; p < bem::pack_points; ++p) {
    pack.x[0][p] = 5 + 0.1 * static_cast<double>(p);
    pack.x[1][p] = 0.2;
    pack.x[2][p] = 0.3;
    pack.mask[p] = 1;
  }
  constexpr std::size_t block = 9 * bem::pack_points;
  std::vector<double> h(block * mesh.node.size()), g(h.size());
  bem::FarPoints points;
  for (auto _ : state)
    for (std::size_t e = 0; e < elements.size(); ++e) {
      double *hp[max_element_nodes], *gp[max_element_nodes];
      const auto nodes = mesh.element(static_cast<std::int64_t>(e));
      for (std::size_t k = 0; k < nodes.size(); ++k) {
        hp[k] = h.data() + block * static_cast<std::size_t>(nodes[k]);
        gp[k] = g.data() + block * static_cast<std::size_t>(nodes[k]);
      }
      kernels.place(table, elements[e].nodes, elements[e].node, points);
      kernels.far(points, table, elements[e].nodes, pack, constants, bem::both_layers, hp, gp);
      benchmark::DoNotOptimize(h[0]);
    }
  state.counters["points/s"] = benchmark::Counter(
      static_cast<double>(state.iterations() * mesh.elements() * table.n * bem::pack_points),
      benchmark::Counter::kIsRate);
}

/// One point at a height over a place on an element (0: on it), T and U to 1e-6.
void near_pair(benchmark::State& state, ElementType type, double height) {
  const SurfaceMesh mesh = surfaces::cube_sphere(type, 4, 1);
  const bem::ElementGeometry element = bem::element_geometry(mesh, 5, 1);
  const bem::Vec2 place{0.3, 0.2};
  Vec3 x, u, v;
  element.tangents(place, x, u, v);
  const Vec3 n = cross(u, v);
  x = x + (height / length(n)) * n;
  const bem::OnElement on{height == 0, place};
  const bem::KelvinConstants constants(0.3);
  const bem::Kernels& kernels = bem::kelvin_kernels(halfspace::instruction_set());
  bem::NearWorkspace workspace;
  bem::NearIntegrals integrals;
  for (auto _ : state) {
    bem::near_integrals(element, x, on, {1e-7, 1e-8}, bem::both_layers, constants, kernels,
                        workspace, integrals);
    benchmark::DoNotOptimize(integrals.t[0][0]);
  }
  state.counters["points"] =
      static_cast<double>(workspace.evaluations) / static_cast<double>(state.iterations());
}

/// All rows at all nodes; with_u: columns of all tractions, too.
void rows_of_ring(benchmark::State& state, ElementType type, bool with_u) {
  const SurfaceMesh mesh = surfaces::ring({}, type);
  const bem::BoundaryIntegrals integrals(mesh, 0.3, 1e-6);
  std::vector<bem::CollocationPoint> points;
  for (std::size_t i = 0; i < mesh.node.size(); ++i)
    points.push_back({mesh.node[i], static_cast<std::int32_t>(i), -1, 0, 0});
  std::vector<double> h(9 * bem::lanes * mesh.node.size()), g(h.size());
  for (auto _ : state)
    for (std::size_t i = 0; i < points.size(); i += bem::lanes)
      integrals.rows({points.data() + i, std::min<std::size_t>(bem::lanes, points.size() - i)},
                     h.data(), mesh.connectivity.data(), mesh.nodes(), with_u ? g.data() : nullptr);
  state.counters["nodes"] = static_cast<double>(mesh.nodes());
  state.counters["points/s"] = benchmark::Counter(
      static_cast<double>(integrals.kernel_evaluations()), benchmark::Counter::kIsRate);
}

#define ROLLCON_FAR_BENCH(type)                                                                \
  BENCHMARK_CAPTURE(far_kernel, type##_baseline, ElementType::type, InstructionSet::baseline); \
  BENCHMARK_CAPTURE(far_kernel, type##_avx2, ElementType::type, InstructionSet::avx2);         \
  BENCHMARK_CAPTURE(far_kernel, type##_avx512, ElementType::type, InstructionSet::avx512)
ROLLCON_FAR_BENCH(tri3);
ROLLCON_FAR_BENCH(quad4);
ROLLCON_FAR_BENCH(quad9);
#define ROLLCON_NEAR_BENCH(type)                                      \
  BENCHMARK_CAPTURE(near_pair, type##_on, ElementType::type, 0.0);    \
  BENCHMARK_CAPTURE(near_pair, type##_1e_3, ElementType::type, 1e-3); \
  BENCHMARK_CAPTURE(near_pair, type##_1e_1, ElementType::type, 0.1)
ROLLCON_NEAR_BENCH(tri3);
ROLLCON_NEAR_BENCH(quad4);
ROLLCON_NEAR_BENCH(quad9);
BENCHMARK_CAPTURE(rows_of_ring, quad4_T, ElementType::quad4, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(rows_of_ring, quad4_T_and_U, ElementType::quad4, true)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(rows_of_ring, quad8_T, ElementType::quad8, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(rows_of_ring, quad8_T_and_U, ElementType::quad8, true)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rollcon

BENCHMARK_MAIN();
