/// Tests tractions at edges and corners: one value per smooth fan of elements.

#include <map>

#include "mesh/surface_check.hpp"
#include "mesh/surface_geometry.hpp"
#include "mesh/traction_nodes.hpp"
#include "support/surface_meshes.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using std::numbers::pi;

using surfaces::all_types;
using surfaces::name_of;

/// Checks what holds for every mesh and angle.
void expect_consistent(const SurfaceMesh& mesh, const TractionNodes& t) {
  ASSERT_EQ(t.of.size(), mesh.connectivity.size());
  ASSERT_EQ(t.start.size(), mesh.node.size() + 1);
  ASSERT_EQ(t.start.front(), 0);
  ASSERT_EQ(t.start.back(), t.size());
  ASSERT_EQ(t.normal.size(), t.node.size());
  EXPECT_TRUE(std::is_sorted(t.node.begin(), t.node.end()));
  for (std::size_t i = 0; i < t.of.size(); ++i)
    EXPECT_EQ(t.node[static_cast<std::size_t>(t.of[i])], mesh.connectivity[i]);
  for (std::size_t k = 0; k < mesh.node.size(); ++k)
    for (std::int64_t i = t.start[k]; i < t.start[k + 1]; ++i)
      EXPECT_EQ(t.node[static_cast<std::size_t>(i)], static_cast<std::int32_t>(k));
  for (const Vec3& n : t.normal) EXPECT_NEAR(length(n), 1, 1e-14);
}

std::int64_t fans(const TractionNodes& t, std::int32_t node) {
  return t.start[static_cast<std::size_t>(node) + 1] - t.start[static_cast<std::size_t>(node)];
}

TEST(TractionNodes, CubeHasOnePerFaceAtEdgesAndCorners) {
  for (ElementType type : all_types) {
    SurfaceMesh mesh = surfaces::block(surfaces::brick({3, 2, 4}, {1, 1, 1}), type);
    std::fill(mesh.tag.begin(), mesh.tag.end(), 0);
    const TractionNodes t = split_at_edges(mesh, 40);
    expect_consistent(mesh, t);
    double error = 0;
    for (std::int32_t k = 0; k < mesh.nodes(); ++k) {
      const Vec3& x = mesh.node[static_cast<std::size_t>(k)];
      std::int64_t faces = 0;
      Vec3 sum{0, 0, 0};
      for (std::size_t c = 0; c < 3; ++c)
        if (x[c] == 0 || x[c] == 1) ++faces, sum[c] = x[c] == 0 ? -1 : 1;
      EXPECT_EQ(fans(t, k), faces) << x[0] << " " << x[1] << " " << x[2];
      Vec3 normals{0, 0, 0};
      for (std::int64_t i = t.start[static_cast<std::size_t>(k)]; i < t.start[static_cast<std::size_t>(k) + 1]; ++i)
        normals = normals + t.normal[static_cast<std::size_t>(i)];
      error = std::max(error, length(normals - sum));
    }
    expect_error("cube, normals of the fans, " + name_of(type), error, 1e-14);
    EXPECT_EQ(split_at_edges(mesh, 90).size(), mesh.nodes()) << "90 degrees are not more than 90";
    EXPECT_GT(split_at_edges(mesh, 89.9).size(), mesh.nodes());
  }
}

TEST(TractionNodes, SphereHasOnePerNodeWithTheRadialNormal) {
  for (ElementType type : all_types) {
    const SurfaceMesh mesh = surfaces::cube_sphere(type, 6, 1);
    const TractionNodes t = split_at_edges(mesh, 40);
    expect_consistent(mesh, t);
    EXPECT_EQ(t.size(), mesh.nodes());
    double error = 0;
    for (std::size_t k = 0; k < t.normal.size(); ++k)
      error = std::max(error, length(t.normal[k] - normalized(mesh.node[k])));
    // A mean of facets is less good than the quadratic elements' own normals.
    expect_error("sphere of 6 elements to a quarter, nodal normals, " + name_of(type), error,
                 is_quadratic(type) ? 0.02 : 0.06);
  }
}

TEST(TractionNodes, NormalsDoNotDependOnHowAFaceIsCut) {
  // A corner of a cube is cut into 1, 2 and many slivers: the fan's mean is that of angles.
  SurfaceMesh mesh;
  mesh.node = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
  const auto triangle = [&](std::int32_t a, std::int32_t b, std::int32_t c) {
    surfaces::add_element(mesh, ElementType::tri3, {a, b, c});
  };
  triangle(0, 2, 1);  // y = 0
  triangle(0, 1, 3);  // x = 0
  // The side z = 0 is cut into 30 unequal slivers.
  std::int32_t last = 3;
  for (int i = 1; i < 30; ++i) {
    const double a = 0.5 * pi * std::pow(i / 30.0, 2);
    mesh.node.push_back({std::sin(a), std::cos(a), 0});
    const auto next = static_cast<std::int32_t>(mesh.node.size() - 1);
    triangle(0, last, next);
    last = next;
  }
  triangle(0, last, 2);
  const TractionNodes t = split_at_edges(mesh, 100);
  EXPECT_EQ(fans(t, 0), 1);
  const double c = -1 / std::sqrt(3.0);
  expect_error("normal at a corner of a cube", length(t.normal[static_cast<std::size_t>(t.start[0])] - Vec3{c, c, c}),
               1e-14);
}

TEST(TractionNodes, TagsSplitSmoothSurfaces) {
  for (ElementType type : all_types) {
    SurfaceMesh mesh = surfaces::cube_sphere(type, 4, 1);
    // The upper half has another tag, so nodes on the equator have two fans.
    for (std::int64_t e = 0; e < mesh.elements(); ++e) {
      double z = 0;
      for (std::int32_t k : mesh.element(e)) z += mesh.node[static_cast<std::size_t>(k)][2];
      mesh.tag[static_cast<std::size_t>(e)] = z > 0 ? 1 : 2;
    }
    const TractionNodes t = split_at_edges(mesh, 180);
    expect_consistent(mesh, t);
    std::int64_t equator = 0;
    for (std::int32_t k = 0; k < mesh.nodes(); ++k) {
      const bool on = std::abs(mesh.node[static_cast<std::size_t>(k)][2]) < 1e-12;
      equator += on;
      EXPECT_EQ(fans(t, k), on ? 2 : 1);
    }
    EXPECT_EQ(equator, is_quadratic(type) ? 32 : 16);
  }
}

TEST(TractionNodes, EdgeAngleDecidesOnAPrism) {
  // A ring's outer and inner cylinders are cut in n pieces: neighbours differ by 360/n degrees when linear, by the kink
  // between arcs when quadratic.
  for (ElementType type : {ElementType::quad4, ElementType::tri3}) {
    surfaces::Block shape = surfaces::brick({12, 1, 1}, {1, 1, 1});
    shape.ring = true;
    shape.line[0].clear();
    for (int i = 0; i <= 12; ++i) shape.line[0].push_back(i / 12.0);
    shape.map = [](const Vec3& x) {
      const double a = 2 * pi * x[0], r = 1 + x[2];
      return Vec3{r * std::sin(a), x[1], r * std::cos(a)};
    };
    const SurfaceMesh mesh = surfaces::block(shape, type);
    ASSERT_NO_THROW(check_surface(mesh, SurfaceKind::closed));
    ASSERT_EQ(mesh.nodes(), 48);
    EXPECT_EQ(split_at_edges(mesh, 31).size(), 96) << "edges of 90 degrees alone";
    EXPECT_EQ(split_at_edges(mesh, 30).size(), 96) << "30 degrees are not more than 30";
    EXPECT_EQ(split_at_edges(mesh, 29.9).size(), 144) << "every strip of the cylinders its own";
  }
}

TEST(TractionNodes, ASharpEdgeThatEndsLeavesOneFan) {
  // A square pyramid's surface without base is flattened on one side: around its apex the fan is broken only where two
  // sharp edges meet.
  SurfaceMesh mesh;
  mesh.node = {{0, 0, 0.0}, {1, 0, 0.0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0.7, 0.7, 1}};
  const std::int32_t ring[] = {1, 5, 2, 3, 4};
  for (std::size_t i = 0; i < 5; ++i) surfaces::add_element(mesh, ElementType::tri3, {0, ring[i], ring[(i + 1) % 5]});
  // The angles at the edges from the apex are equal at 1 and 2, and sharpest at 5.
  const double at_1 = angle_between(unit_normal(mesh, 0, 0, 0), unit_normal(mesh, 4, 0, 0));
  const double at_5 = angle_between(unit_normal(mesh, 0, 0, 0), unit_normal(mesh, 1, 0, 0));
  ASSERT_GT(at_5, at_1 + 0.1);
  const TractionNodes one = split_at_edges(mesh, 0.5 * (at_1 + at_5) * 180 / pi);
  EXPECT_EQ(fans(one, 0), 1) << "round the other way";
  EXPECT_EQ(fans(one, 5), 2) << "the rim's end of the sharp edge";
  const TractionNodes three = split_at_edges(mesh, 0.9 * at_1 * 180 / pi);
  EXPECT_EQ(fans(three, 0), 3);
}

}  // namespace
}  // namespace rollcon
