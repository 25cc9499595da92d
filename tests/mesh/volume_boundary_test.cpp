/// Tests boundaries of volume meshes, and the surface meshes made of them.

#include "mesh/volume_boundary.hpp"

#include "geometry/surface_search.hpp"
#include "mesh/refusals.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/traction_nodes.hpp"
#include "mesh/volume_shape.hpp"
#include "support/testing.hpp"
#include "support/volume_meshes.hpp"

namespace rollcon {
namespace {

using volumes::all_types;
using volumes::name_of;

using surfaces::at;

SurfaceMesh boundary_of(const volumes::Mesh& mesh) {
  SurfaceMesh surface = boundary_surface(mesh.volume, boundary_faces(mesh.volume));
  surface.node = mesh.surface.node;
  return surface;
}

/// Drops nodes of no element.
SurfaceMesh compact(const SurfaceMesh& mesh) {
  std::vector<std::int64_t> all(mesh.type.size());
  for (std::size_t e = 0; e < all.size(); ++e) all[e] = static_cast<std::int64_t>(e);
  std::vector<std::int32_t> node;
  return surfaces::part_of(mesh, all, node);
}

TEST(VolumeBoundary, OfABrickIsAClosedSurface) {
  const Vec3 size{1, 2, 0.5};
  for (const VolumeType type : all_types) {
    const auto mesh = volumes::block(surfaces::brick({3, 4, 2}, size), type);
    const SurfaceMesh surface = boundary_of(mesh);
    const surfaces::Facts f = surfaces::facts(surface);
    EXPECT_EQ(f.euler, 2);
    EXPECT_EQ(f.open_edges, 0);
    EXPECT_EQ(f.clashing_edges, 0);
    expect_error("area of " + name_of(type), f.area / 7 - 1, 1e-13);
    expect_error("volume of " + name_of(type), f.volume - 1, 1e-14);
    EXPECT_EQ(surface.tag, std::vector<std::int32_t>(surface.type.size(), 0));
    EXPECT_NO_THROW(check_surface(surface, SurfaceKind::boundary));
    EXPECT_NO_THROW(check_surface(compact(surface), SurfaceKind::closed));
  }
}

TEST(VolumeBoundary, OfOneElementHasAllItsFacesInOrder) {
  for (const VolumeType type : all_types) {
    VolumeElements one;
    std::vector<std::int32_t> backwards;
    for (std::int32_t k = 0; k < node_count(type); ++k) backwards.push_back(100 - k);
    volumes::add_element(one, type, backwards);
    const auto faces = boundary_faces(one);
    const auto expected = faces_of(type);
    ASSERT_EQ(faces.size(), expected.size());
    const SurfaceMesh surface = boundary_surface(one, faces);
    EXPECT_TRUE(surface.node.empty());
    for (std::size_t s = 0; s < faces.size(); ++s) {
      EXPECT_EQ(faces[s].element, 0);
      EXPECT_EQ(faces[s].side, static_cast<std::int32_t>(s));
      EXPECT_EQ(surface.type[s], expected[s].type);
      const auto nodes = surface.element(static_cast<std::int64_t>(s));
      for (std::size_t i = 0; i < nodes.size(); ++i) EXPECT_EQ(nodes[i], 100 - expected[s].node[i]);
    }
  }
}

TEST(VolumeBoundary, FacesAscendByElementAndSide) {
  const auto mesh = volumes::mixed_block(surfaces::brick({4, 3, 2}, {1, 1, 1}), true);
  const auto faces = boundary_faces(mesh.volume);
  EXPECT_TRUE(std::is_sorted(faces.begin(), faces.end(), [](const BoundaryFace& a, const BoundaryFace& b) {
    return std::pair(a.element, a.side) < std::pair(b.element, b.side);
  }));
  EXPECT_EQ(faces.size(), mesh.surface.type.size());
  // Any choice of faces may be made a surface.
  const std::vector<BoundaryFace> last{faces.back()};
  const SurfaceMesh one = boundary_surface(mesh.volume, last);
  const SurfaceMesh all = boundary_surface(mesh.volume, faces);
  EXPECT_TRUE(std::equal(one.element(0).begin(), one.element(0).end(), all.element(all.elements() - 1).begin()));
}

TEST(VolumeBoundary, CavitiesBelongToIt) {
  const auto whole = volumes::block(surfaces::brick({3, 3, 3}, {1, 1, 1}), VolumeType::hex20);
  const auto mesh = volumes::part_of(whole, [](std::int64_t e) { return e != 13; });  // the one in the middle
  const surfaces::Facts f = surfaces::facts(boundary_of(mesh));
  EXPECT_EQ(f.euler, 4);
  EXPECT_EQ(f.quadrilaterals, 9 * 6 + 6);
}

TEST(VolumeBoundary, TractionNodesAndSearchPassOverInnerNodes) {
  // The surface is compared with and without the nodes inside the body.
  for (const VolumeType type : {VolumeType::tet4, VolumeType::tet10, VolumeType::hex8, VolumeType::hex20}) {
    const auto mesh = volumes::distort(volumes::block(surfaces::brick({3, 3, 3}, {1, 1, 1}), type), 0.1, 5);
    SurfaceMesh surface = boundary_of(mesh);
    ASSERT_GT(surfaces::facts(surface).unused_nodes, 0);
    const SurfaceMesh alone = compact(surface);
    const TractionNodes a = split_at_edges(surface, 40), b = split_at_edges(alone, 40);
    ASSERT_EQ(a.size(), b.size());
    ASSERT_EQ(a.start.size(), surface.node.size() + 1);
    for (std::size_t i = 0; i < a.of.size(); ++i) EXPECT_EQ(a.node[at(a.of[i])], surface.connectivity[i]);
    double error = 0;
    for (std::size_t i = 0; i < a.of.size(); ++i)
      error = std::max(error, length(a.normal[at(a.of[i])] - b.normal[at(b.of[i])]));
    expect_error("normals of traction nodes, " + name_of(type), error, 0);
    const SurfaceSearch in(surface, {}), of(alone, {});
    for (const Vec3& x : {Vec3{0.1, 0.2, 2}, Vec3{-1, 0.3, 0.1}, Vec3{0.2, -0.9, 0.4}}) {
      const SurfacePoint p = in.nearest(x), q = of.nearest(x);
      EXPECT_EQ(p.element, q.element);
      EXPECT_EQ(p.x, q.x);
      const auto r = in.along(x, {0, 0, 1}, {0, 0, 0}), s = of.along(x, {0, 0, 1}, {0, 0, 0});
      ASSERT_EQ(r.has_value(), s.has_value());
      EXPECT_TRUE(!r || r->x == s->x);
    }
  }
}

TEST(VolumeBoundary, EdgesOfMoreThanTwoFacesAreRefused) {
  // Two bricks meet along an edge only, and are connected by a bridge of bricks beside it.
  const auto whole = volumes::block(surfaces::brick({2, 2, 2}, {1, 1, 1}), VolumeType::hex8);
  const auto mesh = volumes::part_of(whole, [&whole](std::int64_t e) {
    const Vec3 mean = volumes::mean_corner(whole, e);
    return mean[2] < 0.5 || (mean[0] > 0.5) == (mean[1] > 0.5);
  });
  EXPECT_EQ(mesh.volume.elements(), 6);
  // The elements are sound and share faces: only the edge is wrong.
  EXPECT_NO_THROW(check_volume(mesh.surface.node, mesh.volume, 0));
  SurfaceMesh surface = boundary_of(mesh);
  surface.index_base = 1;
  const auto low = surfaces::node_at(surface, {0.5, 0.5, 0.5}) + 1;
  const auto high = surfaces::node_at(surface, {0.5, 0.5, 1}) + 1;
  const std::string words =
      "the body touches itself along an edge: more than two of its boundary faces meet there; join its parts by a "
      "common face or give each its own nodes; 1 such in the volume; first: nodes " +
      std::to_string(std::min(low, high)) + " and " + std::to_string(std::max(low, high)) +
      ", with 4 faces (counting from 1)";
  expect_error_text([&] { check_surface(surface, SurfaceKind::boundary); }, words);
}

}  // namespace
}  // namespace rollcon
