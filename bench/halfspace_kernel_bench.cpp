// Measures the half-space integrals alone: point evaluations per second of the far and near kernels for each
// instruction set, and whole matrices on discs of about the size of the frames of the paper's third example.

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "bodies/halfspace/far_field.hpp"
#include "bodies/halfspace/halfspace.hpp"
#include "bodies/halfspace/kernels.hpp"
#include "quadrature/element.hpp"

namespace rollcon {
namespace {

using rollcon::InstructionSet;

/// Makes a disc: a grid of n x n cells pressed into a circle, one quadrilateral or two triangles to a cell.
SurfaceMesh disc(ElementType type) {
  const bool triangles = corner_count(type) == 3, quadratic = is_quadratic(type);
  const int n = triangles ? 26 : 25, step = quadratic ? 2 : 1, row = n * step + 1;
  SurfaceMesh mesh;
  for (int j = 0; j < row; ++j)
    for (int i = 0; i < row; ++i) {
      const double u = 2.0 * i / (row - 1) - 1, v = 2.0 * j / (row - 1) - 1;
      mesh.node.push_back({u * std::sqrt(1 - v * v / 2), v * std::sqrt(1 - u * u / 2), 0});
    }
  mesh.offset.push_back(0);
  // The corners are in steps of the grid; midside nodes lie halfway between them.
  auto add = [&](std::vector<std::array<int, 2>> corner) {
    auto node = [&](int i, int j) { mesh.connectivity.push_back(j * row + i); };
    for (const auto& c : corner) node(c[0] * step, c[1] * step);
    for (std::size_t k = 0; quadratic && k < corner.size(); ++k) {
      const auto &c = corner[k], &d = corner[(k + 1) % corner.size()];
      node(c[0] + d[0], c[1] + d[1]);
    }
    if (type == ElementType::quad9) node(corner[0][0] + corner[2][0], corner[0][1] + corner[2][1]);
    mesh.type.push_back(type);
    mesh.tag.push_back(0);
    mesh.offset.push_back(static_cast<std::int64_t>(mesh.connectivity.size()));
  };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      if (!triangles) {
        add({{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}});
      } else if ((2 * i < n) == (2 * j < n)) {  // diagonals across the grid's, else the rim's
        add({{i, j}, {i + 1, j}, {i, j + 1}});  // corners of the grid would be flat
        add({{i + 1, j}, {i + 1, j + 1}, {i, j + 1}});
      } else {
        add({{i, j}, {i + 1, j}, {i + 1, j + 1}});
        add({{i, j}, {i + 1, j + 1}, {i, j + 1}});
      }
    }
  return mesh;
}

bool unavailable(benchmark::State& state, InstructionSet set) {
  if (set <= rollcon::best_instruction_set()) return false;
  state.SkipWithError("not on this processor");
  return true;
}

/// Computes all five kernels with the shape functions of a quad4, 4 x 4 points, far observers.
void far_kernel(benchmark::State& state, InstructionSet set) {
  if (unavailable(state, set)) return;
  const Frame frame = build_frame(disc(ElementType::quad4), Axes{});
  std::vector<std::int64_t> elements;
  for (std::int64_t e = 0; e < 64; ++e) elements.push_back(e);
  const halfspace::FarGroup group(frame, elements, ElementType::quad4, quadrature::MapKind::straight);
  const auto& kernels = halfspace::kernels(set);
  const auto sources = group.sources(2);
  alignas(64) double integral[halfspace::integral_count * halfspace::max_shape_stride];
  for (auto _ : state)
    for (std::int64_t e = 0; e < group.size(); ++e) {
      kernels.far(sources, e, 5.0, 3.0, halfspace::all_terms, integral);
      benchmark::DoNotOptimize(integral[0]);
    }
  state.counters["points/s"] = benchmark::Counter(static_cast<double>(state.iterations() * group.size() * sources.n),
                                                  benchmark::Counter::kIsRate);
}

/// Computes all rows and blocks at all nodes.
void matrix(benchmark::State& state, ElementType type, double tolerance) {
  const Frame frame = build_frame(disc(type), Axes{});
  const auto compliance = make_halfspace_compliance(frame, {1, 0.4, 0.2}, tolerance, 1);
  const auto n = static_cast<std::size_t>(frame.nodes());
  std::vector<double> storage(9 * n * n);
  ComplianceBlock block;
  block.stride = static_cast<std::ptrdiff_t>(n);
  for (std::size_t k = 0; k < 9; ++k) block.a[k / 3][k % 3] = storage.data() + k * n * n;
  const auto before = compliance->kernel_evaluations();
  for (auto _ : state) compliance->block({frame.x, frame.y}, block);
  state.counters["points/s"] =
      benchmark::Counter(static_cast<double>(compliance->kernel_evaluations() - before), benchmark::Counter::kIsRate);
}

void product(benchmark::State& state, ElementType type, double tolerance) {
  const Frame frame = build_frame(disc(type), Axes{});
  const auto compliance = make_halfspace_compliance(frame, {1, 0.4, 0.2}, tolerance, 1);
  std::vector<double> t(3 * frame.x.size(), 1.0), u(t.size());
  for (auto _ : state) compliance->apply({frame.x, frame.y}, t.data(), u.data());
}

BENCHMARK_CAPTURE(far_kernel, baseline, InstructionSet::baseline);
BENCHMARK_CAPTURE(far_kernel, avx2, InstructionSet::avx2);
BENCHMARK_CAPTURE(far_kernel, avx512, InstructionSet::avx512);
#define ROLLCON_FRAME_BENCH(type)                                                          \
  BENCHMARK_CAPTURE(matrix, type, ElementType::type, 1e-6)->Unit(benchmark::kMillisecond); \
  BENCHMARK_CAPTURE(product, type, ElementType::type, 1e-6)->Unit(benchmark::kMillisecond)
ROLLCON_FRAME_BENCH(quad4);
ROLLCON_FRAME_BENCH(quad8);
ROLLCON_FRAME_BENCH(tri3);
ROLLCON_FRAME_BENCH(tri6);

}  // namespace
}  // namespace rollcon

BENCHMARK_MAIN();
