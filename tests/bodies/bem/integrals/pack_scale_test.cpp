// Tests that the accuracy of the single layer is measured by the largest integral of an element whose traction is
// wanted, wherever a pack's points stand: middles of edges are as far from their elements' middle as the scale's own
// length.

#include "bodies/bem/boundary_integrals.hpp"
#include "support/surface_meshes.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

/// Returns the single layer at the first of a pack's points.
std::vector<double> single_layer(const SurfaceMesh& mesh, const std::vector<Vec3>& points, double tolerance) {
  const bem::BoundaryIntegrals integrals(mesh, 0.3, tolerance);
  std::vector<bem::CollocationPoint> pack;
  for (const Vec3& x : points) pack.push_back({x, -1, -1, 0, 0});
  std::vector<double> g(9 * bem::lanes * mesh.node.size()), first;
  integrals.rows(pack, nullptr, mesh.connectivity.data(), mesh.nodes(), g.data());
  for (std::size_t k = 0; k < g.size(); k += bem::lanes) first.push_back(g[k]);
  return first;
}

class PackScale : public ::testing::TestWithParam<ElementType> {};

// Elements have side 1, so coordinates and distances are exact.
TEST_P(PackScale, serves_points_on_edges_and_within_and_off_the_elements) {
  constexpr double tolerance = 1e-5;
  const SurfaceMesh mesh = surfaces::block(surfaces::brick({3, 2, 2}, {3, 2, 2}), GetParam());
  const struct {
    const char* where;
    Vec3 x;
  } points[] = {{"middle of an edge", {1, 0.5, 2}},
                {"middle of the block's edge", {1.5, 0, 2}},
                {"middle of an element", {1.5, 0.5, 2}},
                {"corner", {1, 1, 2}},
                {"above an edge", {1, 0.5, 2.3}},
                {"half a side above", {1.5, 0.5, 2.5}},
                {"far off", {9, 4, -7}}};
  for (const auto& [where, x] : points) {
    // The least scale of a pack counts, which is that of a point far off.
    const std::vector<double> exact = single_layer(mesh, {x, {20, 30, 40}}, 1e-11),
                              found = single_layer(mesh, {x}, tolerance);
    double error = 0, largest = 0;
    for (std::size_t k = 0; k < exact.size(); ++k) {
      const double off = std::abs(found[k] - exact[k]);
      error = off <= error ? error : off;  // a NaN stays
      largest = std::max(largest, std::abs(exact[k]));
    }
    std::printf("%s, %s: error of the single layer %.1e (bound %.0e)\n", surfaces::name_of(GetParam()).c_str(), where,
                error / largest, tolerance);
    EXPECT_LE(error, tolerance * largest) << where;
  }
}

INSTANTIATE_TEST_SUITE_P(types, PackScale, ::testing::ValuesIn(surfaces::all_types),
                         [](const auto& info) { return surfaces::name_of(info.param); });

}  // namespace
}  // namespace rollcon
