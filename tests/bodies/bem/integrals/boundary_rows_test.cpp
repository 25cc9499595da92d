// Tests rows as a whole: instruction sets, units, incompressible bodies, points of a layer, unwanted columns,
// tolerance.

#include "bodies/bem/integrals/assembled_rows.hpp"
#include "bodies/bem/integrals/element_reference.hpp"
#include "bodies/halfspace/kernels.hpp"
#include "support/error.hpp"
#include "support/surface_meshes.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using assembled_rows::System;

System whole_system(const SurfaceMesh& mesh, double poisson, double tolerance) {
  const bem::BoundaryIntegrals integrals(mesh, poisson, tolerance);
  return assembled_rows::assemble(integrals, mesh, assembled_rows::all_nodes(mesh), true, true);
}

SurfaceMesh scaled(SurfaceMesh mesh, double factor) {
  for (Vec3& x : mesh.node) x = factor * x;
  return mesh;
}

class BoundaryRows : public ::testing::TestWithParam<ElementType> {};

TEST_P(BoundaryRows, instruction_sets_agree) {
  using rollcon::InstructionSet;
  const SurfaceMesh mesh = surfaces::cube_sphere(GetParam(), 2, 1);
  const System best = whole_system(mesh, 0.3, 1e-6);
  for (const InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2}) {
    rollcon::force_instruction_set(set);
    const System other = whole_system(mesh, 0.3, 1e-6);
    rollcon::force_instruction_set(InstructionSet::avx512);
    const double h = assembled_rows::difference(best.h, other.h),
                 g = assembled_rows::difference(best.g, other.g) / best.g.largest();
    std::printf("%s against the best: h %.1e, g %.1e (bound 1e-13)\n",
                set == InstructionSet::avx2 ? "avx2" : "baseline", h, g);
    EXPECT_LE(h, 1e-13);
    EXPECT_LE(g, 1e-13);
  }
}

TEST_P(BoundaryRows, every_entry_keeps_the_tolerance) {
  const SurfaceMesh mesh =
      surfaces::distort(surfaces::block(surfaces::brick({4, 2, 2}, {6, 2, 0.4}), GetParam()), 0.2, 3);
  const System exact = whole_system(mesh, 0.3, 1e-11);
  for (const double tolerance : {1e-3, 1e-6}) {
    const System rows = whole_system(mesh, 0.3, tolerance);
    // The sums run over up to all elements, each of which has a fifth of the tolerance.
    const double h = assembled_rows::difference(rows.h, exact.h) / 0.5,
                 g = assembled_rows::difference(rows.g, exact.g) / exact.g.largest();
    std::printf("tolerance %.0e: h %.1e, g %.1e\n", tolerance, h, g);
    EXPECT_LE(h, tolerance);
    EXPECT_LE(g, tolerance);
  }
}

TEST_P(BoundaryRows, units) {
  const SurfaceMesh mesh = surfaces::cube_sphere(GetParam(), 2, 1);
  const System one = whole_system(mesh, 0.3, 1e-6);
  // A power of two changes nothing but exponents; another unit may turn a choice of rules that hangs by a hair, with an
  // effect well below the tolerance.
  const struct {
    double unit, bound;
  } cases[] = {{0x1p-200, 1e-15}, {0x1p+200, 1e-15}, {1e-60, 1e-9}, {1e-6, 1e-9}, {1e6, 1e-9}, {1e60, 1e-9}};
  for (const auto& [unit, bound] : cases) {
    const System other = whole_system(scaled(mesh, unit), 0.3, 1e-6);
    double g = 0;
    for (std::size_t k = 0; k < one.g.value.size(); ++k)
      g = std::max(g, std::abs(other.g.value[k] / unit - one.g.value[k]));
    const double h = assembled_rows::difference(one.h, other.h);
    std::printf("unit %.2g: h %.1e, g %.1e (bound %.0e)\n", unit, h, g, bound);
    EXPECT_LE(h, bound);
    EXPECT_LE(g, bound);
  }
}

INSTANTIATE_TEST_SUITE_P(types, BoundaryRows, ::testing::ValuesIn(surfaces::all_types),
                         [](const auto& info) { return surfaces::name_of(info.param); });

TEST(BoundaryRows, incompressible) {
  const SurfaceMesh mesh = surfaces::cube_sphere(ElementType::quad8, 2, 1);
  const System rows = whole_system(mesh, 0.5, 1e-6), near = whole_system(mesh, 0.4999999, 1e-6);
  const double h = assembled_rows::difference(rows.h, near.h),
               g = assembled_rows::difference(rows.g, near.g) / rows.g.largest();
  std::printf("0.5 against 0.4999999: h %.1e, g %.1e (bound 1e-6)\n", h, g);
  EXPECT_LE(h, 1e-6);
  EXPECT_LE(g, 1e-6);
  EXPECT_TRUE(std::isfinite(rows.h.largest()) && std::isfinite(rows.g.largest()));
}

/// The points of the layer are no part of the mesh: on it, very near, near and far from it.
TEST(BoundaryRows, single_layer_off_the_nodes) {
  constexpr double tolerance = 1e-6;
  const SurfaceMesh mesh = surfaces::cube_sphere(ElementType::quad4, 3, 1);
  SurfaceMesh element;
  double worst = 0;
  for (const double height : {-1e-3, -1e-12, 0.0, 1e-9, 1e-5, 1e-3, 0.1, 1.0, 30.0}) {
    std::vector<bem::CollocationPoint> points;
    for (std::int64_t e = 0; e < mesh.elements(); e += 7) {
      Vec3 centre{}, x[4];
      for (std::size_t k = 0; k < 4; ++k) {
        x[k] = mesh.node[static_cast<std::size_t>(mesh.element(e)[k])];
        centre = centre + (0.1 + 0.1 * static_cast<double>(k)) * x[k];
      }
      const Vec3 n = cross(x[2] - x[0], x[3] - x[1]);
      points.push_back({centre + (height / length(n)) * n, -1, -1, 0, 0});
    }
    const bem::BoundaryIntegrals integrals(mesh, 0.3, tolerance);
    const auto g = assembled_rows::assemble(integrals, mesh, points, false, true).g;
    for (std::size_t p = 0; p < points.size(); ++p) {
      std::vector<double> exact(9 * mesh.node.size());
      double largest = 0, error = 0;
      for (std::int64_t e = 0; e < mesh.elements(); ++e) {
        element = {};
        element.type = {mesh.type[0]};
        for (const std::int32_t node : mesh.element(e))
          element.node.push_back(mesh.node[static_cast<std::size_t>(node)]);
        const auto part = element_reference::integrate(element, points[p].x, 0.3);
        for (std::size_t k = 0; k < 4; ++k)
          for (std::size_t i = 0; i < 9; ++i)
            exact[9 * static_cast<std::size_t>(mesh.element(e)[k]) + i] += part.u[i][k];
      }
      for (std::size_t j = 0; j < mesh.node.size(); ++j)
        for (std::size_t i = 0; i < 9; ++i) {
          largest = std::max(largest, std::abs(exact[9 * j + i]));
          const double d = std::abs(g(p, static_cast<int>(i % 3), j, static_cast<int>(i / 3)) - exact[9 * j + i]);
          error = d <= error ? error : d;
        }
      worst = error / largest <= worst ? worst : error / largest;
    }
  }
  std::printf("points of a layer: error of g %.1e of the row's largest (bound %.0e)\n", worst, tolerance);
  EXPECT_LE(worst, tolerance);
}

TEST(BoundaryRows, unwanted_columns_and_lanes) {
  const SurfaceMesh mesh = surfaces::cube_sphere(ElementType::quad8, 2, 1);
  const auto points = assembled_rows::all_nodes(mesh);
  const bem::BoundaryIntegrals integrals(mesh, 0.3, 1e-6);
  const auto nodes = static_cast<std::size_t>(mesh.nodes());
  const std::size_t block = 9 * bem::lanes;
  // The tractions are those of two elements, one of them with a node left out; each node has its own column.
  std::vector<std::int32_t> column(mesh.connectivity.size(), -1);
  std::int32_t columns = 0;
  for (std::size_t k = 0; k < 8; ++k) column[k] = columns++;
  for (std::size_t k = 24; k < 31; ++k) column[k] = columns++;
  std::vector<double> h(block * nodes, 7), g(block * static_cast<std::size_t>(columns), 7);
  integrals.rows({points.data() + 5, 3}, h.data(), column.data(), columns, g.data());
  // The rows to compare with have one column for each entry of the connectivity.
  std::vector<std::int32_t> every(column.size());
  for (std::size_t k = 0; k < every.size(); ++k) every[k] = static_cast<std::int32_t>(k);
  std::vector<double> all(block * every.size());
  integrals.rows({points.data() + 5, 3}, nullptr, every.data(), static_cast<std::int64_t>(every.size()), all.data());
  double worst = 0, largest = 0;
  for (std::size_t k = 0; k < column.size(); ++k)
    for (std::size_t i = 0; i < block && column[k] >= 0; ++i) {
      const double a = g[block * static_cast<std::size_t>(column[k]) + i];
      worst = std::max(worst, std::abs(a - all[block * k + i]));
      largest = std::max(largest, std::abs(a));
      if (i % bem::lanes >= 3) {
        EXPECT_EQ(a, 0);
      }
    }
  std::printf("wanted columns: %.1e of the largest (bound 1e-6)\n", worst / largest);
  EXPECT_GT(largest, 0);
  EXPECT_LE(worst, 1e-6 * largest);
  for (std::size_t i = 0; i < h.size(); ++i)
    if (i % bem::lanes >= 3) {
      EXPECT_EQ(h[i], 0);
    }
  const std::int64_t before = integrals.kernel_evaluations();
  std::fill(column.begin(), column.end(), -1);
  integrals.rows({points.data(), 8}, nullptr, column.data(), 0, g.data());
  EXPECT_EQ(integrals.kernel_evaluations(), before);
  EXPECT_GT(integrals.bytes(), sizeof(void*));
}

TEST(BoundaryRows, misuse_is_refused) {
  const SurfaceMesh mesh = surfaces::cube_sphere(ElementType::tri3, 2, 1);
  const bem::BoundaryIntegrals integrals(mesh, 0.3, 1e-6);
  std::vector<double> h(9 * bem::lanes * mesh.node.size());
  const std::vector<bem::CollocationPoint> layer(1, {{0, 0, 2}, -1, -1, 0, 0});
  EXPECT_THROW(integrals.rows(layer, h.data(), nullptr, 0, nullptr), Error);
  const std::vector<bem::CollocationPoint> many(9, {{0, 0, 1}, 0, -1, 0, 0});
  EXPECT_THROW(integrals.rows(many, h.data(), nullptr, 0, nullptr), Error);
}

}  // namespace
}  // namespace rollcon
