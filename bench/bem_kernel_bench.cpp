// Measures the boundary integrals in detail: the cost of one pair of point and element near, on and far from each
// other, and all rows of a ring of about the size of the paper's first example. (bem_kernel.cpp has the far kernel
// alone.)

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "bodies/bem/boundary_integrals.hpp"
#include "bodies/bem/near_field.hpp"
#include "support/surface_meshes.hpp"

namespace rollcon {
namespace {

/// Integrates for one point at a height over a place on an element (0: on it), T and U to 1e-6.
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
  const bem::Kernels& kernels = bem::kelvin_kernels(rollcon::instruction_set());
  bem::NearWorkspace workspace;
  bem::NearIntegrals integrals;
  for (auto _ : state) {
    bem::near_integrals(element, x, on, {1e-7, 1e-8}, bem::both_layers, constants, kernels, workspace, integrals);
    benchmark::DoNotOptimize(integrals.t[0][0]);
  }
  state.counters["points"] = static_cast<double>(workspace.evaluations) / static_cast<double>(state.iterations());
}

/// Computes all rows at all nodes; with_u adds columns of all tractions.
void rows_of_ring(benchmark::State& state, ElementType type, bool with_u) {
  const SurfaceMesh mesh = surfaces::ring({}, type);
  const bem::BoundaryIntegrals integrals(mesh, 0.3, 1e-6);
  std::vector<bem::CollocationPoint> points;
  for (std::size_t i = 0; i < mesh.node.size(); ++i)
    points.push_back({mesh.node[i], static_cast<std::int32_t>(i), -1, 0, 0});
  std::vector<double> h(9 * bem::lanes * mesh.node.size()), g(h.size());
  for (auto _ : state)
    for (std::size_t i = 0; i < points.size(); i += bem::lanes)
      integrals.rows({points.data() + i, std::min<std::size_t>(bem::lanes, points.size() - i)}, h.data(),
                     mesh.connectivity.data(), mesh.nodes(), with_u ? g.data() : nullptr);
  state.counters["nodes"] = static_cast<double>(mesh.nodes());
  state.counters["points/s"] =
      benchmark::Counter(static_cast<double>(integrals.kernel_evaluations()), benchmark::Counter::kIsRate);
}

#define ROLLCON_NEAR_BENCH(type)                                      \
  BENCHMARK_CAPTURE(near_pair, type##_on, ElementType::type, 0.0);    \
  BENCHMARK_CAPTURE(near_pair, type##_1e_3, ElementType::type, 1e-3); \
  BENCHMARK_CAPTURE(near_pair, type##_1e_1, ElementType::type, 0.1)
ROLLCON_NEAR_BENCH(tri3);
ROLLCON_NEAR_BENCH(quad4);
ROLLCON_NEAR_BENCH(quad9);
BENCHMARK_CAPTURE(rows_of_ring, quad4_T, ElementType::quad4, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(rows_of_ring, quad4_T_and_U, ElementType::quad4, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(rows_of_ring, quad8_T, ElementType::quad8, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(rows_of_ring, quad8_T_and_U, ElementType::quad8, true)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rollcon

BENCHMARK_MAIN();
