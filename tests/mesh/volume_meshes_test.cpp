// Tests the volume meshes of tests and benches: sound, full, with the boundary that they claim.

#include "support/volume_meshes.hpp"

#include "mesh/volume_boundary.hpp"
#include "mesh/volume_shape.hpp"
#include "support/error.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using volumes::all_types;
using volumes::Mesh;
using volumes::name_of;

using surfaces::at;

/// Returns the nodes of every element in its order, elements sorted by their corners.
std::vector<std::vector<std::int32_t>> faces_of_surface(const SurfaceMesh& mesh) {
  std::vector<std::vector<std::int32_t>> all;
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const auto n = mesh.element(e);
    all.emplace_back(n.begin(), n.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// Checks what holds for every mesh.
void expect_sound(const Mesh& mesh, const std::string& what, std::int64_t euler = 2) {
  try {
    check_volume(mesh.surface.node, mesh.volume, 0);
  } catch (const Error& error) {
    ADD_FAILURE() << what << ": " << error.what();
    return;
  }
  const SurfaceMesh boundary = boundary_surface(mesh.volume, boundary_faces(mesh.volume));
  EXPECT_EQ(faces_of_surface(boundary), faces_of_surface(mesh.surface)) << what;
  const surfaces::Facts facts = surfaces::facts(mesh.surface);
  EXPECT_EQ(facts.euler, euler) << what;
  EXPECT_EQ(facts.open_edges, 0) << what;
  EXPECT_EQ(facts.clashing_edges, 0) << what;
  const volumes::Filling filling = volumes::filling(mesh);
  EXPECT_GT(filling.least, 0.02) << what;
  expect_error("volume within the surface, " + what, filling.volume / facts.volume - 1, 1e-12);
  expect_error("centroid, " + what, length(filling.centroid - facts.centroid) / std::cbrt(facts.volume), 1e-12);
}

std::int64_t tagged(const Mesh& mesh, std::int32_t tag) {
  return std::count(mesh.surface.tag.begin(), mesh.surface.tag.end(), tag);
}

double area_with_tag(const Mesh& mesh, std::int32_t tag) {
  return surfaces::facts(surfaces::part_with_tag(mesh.surface, tag)).area;
}

/// Returns the largest distance of a node of the surface's elements with these tags to the nearest node of those of the
/// other surface.
double farthest_apart(const SurfaceMesh& a, const SurfaceMesh& b, std::initializer_list<std::int32_t> tags) {
  double largest = 0;
  const auto of_b = surfaces::nodes_with_tag(b, {tags.begin(), tags.size()});
  for (const std::int32_t i : surfaces::nodes_with_tag(a, {tags.begin(), tags.size()})) {
    double nearest = 1e9;
    for (const std::int32_t k : of_b) nearest = std::min(nearest, length(a.node[at(i)] - b.node[at(k)]));
    largest = std::max(largest, nearest);
  }
  return largest;
}

TEST(VolumeMeshes, Bricks) {
  const Vec3 size{2, 1, 0.5};
  for (const VolumeType type : all_types) {
    const Mesh mesh = volumes::block(surfaces::brick({4, 3, 2}, size), type);
    expect_sound(mesh, name_of(type) + " brick");
    expect_error("volume", volumes::filling(mesh).volume - 1, 1e-13);
    const int elements = corner_count(type) == 8 ? 1 : corner_count(type) == 6 ? 2 : 6;
    EXPECT_EQ(mesh.volume.elements(), 24 * elements);
    const double area[] = {0.5, 0.5, 1, 1, 2, 2};
    for (std::int32_t tag = 1; tag <= 6; ++tag) {
      expect_error("face " + std::to_string(tag), area_with_tag(mesh, tag) - area[tag - 1], 1e-13);
      // Each node is on its plane: x = 0, x = 2, y = 0, ...
      const std::size_t axis = at(tag - 1) / 2;
      for (const std::int32_t k : surfaces::nodes_with_tag(mesh.surface, std::array{tag}))
        EXPECT_EQ(mesh.surface.node[at(k)][axis], tag % 2 == 1 ? 0 : size[axis]);
    }
    const Mesh bent = volumes::distort(mesh, 0.12, 4);
    expect_sound(bent, name_of(type) + " brick, distorted");
    expect_error("its volume", volumes::filling(bent).volume - 1, 1e-12);
    EXPECT_NE(bent.surface.node, mesh.surface.node);
    EXPECT_EQ(bent.surface.node, volumes::distort(mesh, 0.12, 4).surface.node);
  }
}

TEST(VolumeMeshes, MixedBricks) {
  for (const bool quadratic : {false, true}) {
    const Mesh mesh = volumes::mixed_block(surfaces::brick({4, 4, 2}, {1, 1, 1}), quadratic);
    expect_sound(mesh, quadratic ? "mixed quadratic" : "mixed linear");
    expect_sound(volumes::distort(mesh, 0.12, 3), "distorted");
    int wedges = 0;
    for (const VolumeType type : mesh.volume.type) {
      EXPECT_EQ(is_quadratic(type), quadratic);
      wedges += corner_count(type) == 6;
    }
    EXPECT_GT(wedges, 10);
    EXPECT_GT(mesh.volume.elements() - wedges, 10);
  }
}

TEST(VolumeMeshes, PartsKeepTheirPlaces) {
  const Mesh whole = volumes::with_materials(volumes::block(surfaces::brick({4, 2, 2}, {2, 1, 1}), VolumeType::tet10),
                                             [](const Vec3& x) { return x[0] < 1 ? 7 : 8; });
  const Mesh half = volumes::part_of(whole, [&](std::int64_t e) { return volumes::mean_corner(whole, e)[0] < 1; });
  EXPECT_EQ(2 * half.volume.elements(), whole.volume.elements());
  EXPECT_EQ(std::count(half.volume.tag.begin(), half.volume.tag.end(), 7), half.volume.elements());
  check_volume(half.surface.node, half.volume, 0);
  expect_error("half the volume", volumes::filling(half).volume - 1, 1e-13);
  expect_error("its middle", length(volumes::filling(half).centroid - Vec3{0.5, 0.5, 0.5}), 1e-13);
}

TEST(VolumeMeshes, Rings) {
  for (const double sector : {0.0, 1.2}) {
    surfaces::Ring shape{.sector = sector, .around = 42};
    if (sector > 0) shape.around = 16;
    for (const VolumeType type : all_types) {
      const Mesh mesh = volumes::ring(shape, type);
      const std::string what = name_of(type) + (sector > 0 ? " sector of a ring" : " ring");
      expect_sound(mesh, what, sector > 0 ? 2 : 0);
      const int parts = corner_count(type) == 8 ? 1 : corner_count(type) == 6 ? 2 : 6;
      EXPECT_EQ(mesh.volume.elements(), (sector > 0 ? 768 : 2016) * parts);
      EXPECT_EQ(tagged(mesh, 2), corner_count(type) == 8 ? 144 : 288);
      double radius = 0;
      for (const auto& [tag, r] : {std::pair{1, 50.0}, {2, 50.0}, {3, 25.0}})
        for (const std::int32_t k : surfaces::nodes_with_tag(mesh.surface, std::array{tag})) {
          const Vec3& x = mesh.surface.node[at(k)];
          radius = std::max(radius, std::abs(std::hypot(x[0], x[2]) - r));
        }
      expect_error("nodes on the true surfaces, " + what, radius, 1e-13);
    }
    // The nodes are those of the surface meshes one for one, also by tag.
    const std::pair<VolumeType, ElementType> pairs[] = {{VolumeType::hex8, ElementType::quad4},
                                                        {VolumeType::hex20, ElementType::quad8}};
    for (const auto& [type, face] : pairs) {
      const SurfaceMesh a = volumes::ring(shape, type).surface, b = surfaces::ring(shape, face);
      EXPECT_EQ(a.elements(), b.elements());
      EXPECT_EQ(a.nodes() - surfaces::facts(a).unused_nodes, b.nodes());
      double apart = 0;
      for (const std::int32_t tag : {1, 2, 3, 4, 5, 6, 7})
        apart = std::max({apart, farthest_apart(a, b, {tag}), farthest_apart(b, a, {tag})});
      expect_error("nodes of " + name_of(type) + " and " + surfaces::name_of(face), apart, 1e-13);
    }
    const SurfaceMesh a = volumes::ring(shape, VolumeType::wedge15).surface;
    const SurfaceMesh b = surfaces::ring(shape, ElementType::tri6);
    expect_error("outer nodes of wedge15 and tri6",
                 std::max(farthest_apart(a, b, {1, 2}), farthest_apart(b, a, {1, 2})), 1e-13);
  }
}

TEST(VolumeMeshes, BlocksWithAZone) {
  const surfaces::ZoneBlock shape{.n = 4, .grade = 3, .deep = 3};
  for (const VolumeType type : all_types) {
    const Mesh mesh = volumes::zone_block(shape, type);
    expect_sound(mesh, name_of(type) + " block with a zone");
    expect_error("zone", area_with_tag(mesh, 2) - 0.01, 1e-15);
    expect_error("top", area_with_tag(mesh, 1) - 0.99, 1e-13);
    for (std::int32_t tag = 3; tag <= 7; ++tag) expect_error("face", area_with_tag(mesh, tag) - 1, 1e-13);
  }
  const SurfaceMesh a = volumes::zone_block(shape, VolumeType::hex20).surface;
  const SurfaceMesh b = surfaces::zone_block(shape, ElementType::quad8);
  double apart = 0;
  for (const std::int32_t tag : {1, 2, 3, 4, 5, 6, 7})
    apart = std::max({apart, farthest_apart(a, b, {tag}), farthest_apart(b, a, {tag})});
  expect_error("nodes of hex20 and quad8", apart, 1e-15);
}

}  // namespace
}  // namespace rollcon
