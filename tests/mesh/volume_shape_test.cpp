// Tests edges, faces and numbering of volume elements; shape_test tests their functions.

#include "mesh/volume_shape.hpp"

#include <set>

#include "mesh/shape.hpp"
#include "support/frames.hpp"
#include "support/testing.hpp"
#include "support/volume_meshes.hpp"

namespace rollcon {
namespace {

using volumes::all_types;
using volumes::name_of;

using surfaces::at;

TEST(VolumeShape, MidsideNodesLieInTheMiddleOfTheirEdges) {
  for (const VolumeType type : all_types) {
    const auto nodes = reference_nodes(type);
    const auto edges = edges_of(type);
    double error = 0;
    for (std::size_t k = 0; is_quadratic(type) && k < edges.size(); ++k)
      error = std::max(
          error, length(nodes[at(corner_count(type)) + k] - 0.5 * (nodes[at(edges[k][0])] + nodes[at(edges[k][1])])));
    expect_error("midside nodes, " + name_of(type), error, 0);
    const auto corners = at(corner_count(type));
    EXPECT_EQ(edges.size(), corners == 4 ? 6u : corners == 6 ? 9u : 12u);
    EXPECT_EQ(nodes.size(), corners + (is_quadratic(type) ? edges.size() : 0));
  }
}

TEST(VolumeShape, FacesLookOutwards) {
  for (const VolumeType type : all_types) {
    const auto nodes = reference_nodes(type);
    Vec3 centre{0, 0, 0};
    for (int i = 0; i < corner_count(type); ++i) centre = centre + (1.0 / corner_count(type)) * nodes[at(i)];
    Vec3 closed{0, 0, 0};
    for (const VolumeFace& f : faces_of(type)) {
      const Vec3 a = nodes[at(f.node[0])], b = nodes[at(f.node[1])], c = nodes[at(f.node[2])];
      const Vec3 normal = cross(b - a, c - a);
      EXPECT_GT(dot(normal, a - centre), 0) << name_of(type);
      // The faces' areas as vectors cancel.
      closed = closed + (corner_count(f.type) == 3 ? 0.5 : 1) * normal;
      // All nodes of the face, and no others, lie in its plane.
      std::set<int> own(f.node.begin(), f.node.begin() + node_count(f.type));
      EXPECT_EQ(own.size(), at(node_count(f.type))) << name_of(type);
      for (int i = 0; i < node_count(type); ++i)
        EXPECT_EQ(std::abs(dot(normal, nodes[at(i)] - a)) < 1e-14, own.contains(i)) << name_of(type) << " node " << i;
    }
    expect_error("closed surface, " + name_of(type), length(closed), 0);
  }
}

TEST(VolumeShape, OnFacesTheyAreTheSurfaceElements) {
  frames::Random random(3);
  for (const VolumeType type : all_types) {
    double error = 0;
    const auto nodes = reference_nodes(type);
    for (const VolumeFace& f : faces_of(type)) {
      EXPECT_EQ(is_quadratic(f.type), is_quadratic(type));
      for (int k = 0; k < 20; ++k) {
        double u = random(), v = random();
        if (corner_count(f.type) == 3) u = 0.5 * (1 + u), v = 0.5 * (1 - u) * (1 + v);
        Shape s;
        evaluate_shape(f.type, u, v, s);
        // Reference faces are flat and straight: their nodes interpolate the place.
        Vec3 x{0, 0, 0};
        for (int i = 0; i < node_count(f.type); ++i) x = x + s.value[at(i)] * nodes[at(f.node[at(i)])];
        VolumeShape volume;
        evaluate_shape(type, x, volume);
        std::array<double, max_volume_nodes> expected{};
        for (int i = 0; i < node_count(f.type); ++i) expected[at(f.node[at(i)])] = s.value[at(i)];
        for (int i = 0; i < node_count(type); ++i)
          error = std::max(error, std::abs(volume.value[at(i)] - expected[at(i)]));
      }
    }
    expect_error("faces as surface elements, " + name_of(type), error, 2e-15);
  }
}

TEST(VolumeShape, FacesAreInTheDocumentedOrder) {
  const auto corners = [](VolumeType type) {
    std::vector<std::set<int>> sets;
    for (const VolumeFace& f : faces_of(type)) sets.emplace_back(f.node.begin(), f.node.begin() + corner_count(f.type));
    return sets;
  };
  using Sets = std::vector<std::set<int>>;
  for (const VolumeType type : {VolumeType::tet4, VolumeType::tet10})
    EXPECT_EQ(corners(type), (Sets{{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {0, 2, 3}}));
  for (const VolumeType type : {VolumeType::wedge6, VolumeType::wedge15})
    EXPECT_EQ(corners(type), (Sets{{0, 1, 2}, {3, 4, 5}, {0, 1, 3, 4}, {1, 2, 4, 5}, {0, 2, 3, 5}}));
  for (const VolumeType type : {VolumeType::hex8, VolumeType::hex20})
    EXPECT_EQ(corners(type),
              (Sets{{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 4, 5}, {1, 2, 5, 6}, {2, 3, 6, 7}, {0, 3, 4, 7}}));
}

}  // namespace
}  // namespace rollcon
