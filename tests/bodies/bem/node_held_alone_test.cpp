// Tests that reactions of nodes that are held alone, without a held face, on elements with nodes between their corners
// do not depend on the corner at which an element's list of nodes begins.

#include "support/static_solution.hpp"
#include "support/surface_meshes.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using statics::StaticBody;

/// Makes every element begin at another one of its corners.
SurfaceMesh begun_elsewhere(SurfaceMesh mesh) {
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const auto k = static_cast<std::size_t>(e);
    const int corners = corner_count(mesh.type[k]);
    std::int32_t* node = mesh.connectivity.data() + mesh.offset[k];
    const int by = 1 + static_cast<int>(e % (corners - 1));
    std::rotate(node, node + by, node + corners);
    if (is_quadratic(mesh.type[k])) std::rotate(node + corners, node + corners + by, node + 2 * corners);
  }
  return mesh;
}

class NodeHeldAlone : public ::testing::TestWithParam<ElementType> {};

// A block on three single nodes is pushed sideways, so the supports have to react.
TEST_P(NodeHeldAlone, moves_alike_whichever_corner_elements_begin_at) {
  constexpr double accuracy = 1e-8, bound = 1e-6;
  const SurfaceMesh block = surfaces::block(surfaces::brick({3, 2, 2}, {3, 2, 2}), GetParam());
  const std::array<std::int32_t, 3> held{surfaces::node_at(block, {1, 1, 0}), surfaces::node_at(block, {2, 1, 0}),
                                         surfaces::node_at(block, {2, 2, 1})};
  std::vector<Vec3> u[2];
  Vec3 reaction[2];
  for (const int k : {0, 1}) {
    StaticBody body(k == 0 ? block : begun_elsewhere(block), 1e4, 0.3, accuracy);
    body.hold(held).traction(2, {3, 1, -2}).solve();
    for (std::int32_t i = 0; i < block.nodes(); ++i) u[k].push_back(body.displacement(i));
    reaction[k] = body.reaction().force;
  }
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < u[0].size(); ++i) {
    difference = std::max(difference, length(u[1][i] - u[0][i]));
    size = std::max(size, length(u[0][i]));
  }
  const double off = length(reaction[1] - reaction[0]) / length(reaction[0]);
  std::printf("%s: displacements differ by %.1e, reactions by %.1e (bound %.0e)\n",
              surfaces::name_of(GetParam()).c_str(), difference / size, off, bound);
  EXPECT_LT(difference, bound * size);
  EXPECT_LT(off, bound);
}

INSTANTIATE_TEST_SUITE_P(types, NodeHeldAlone,
                         ::testing::Values(ElementType::tri6, ElementType::quad8, ElementType::quad9),
                         [](const auto& info) { return surfaces::name_of(info.param); });

}  // namespace
}  // namespace rollcon
