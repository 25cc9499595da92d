/// Compares points, angles, areas and volumes of curved elements with closed forms.

#include "mesh/surface_geometry.hpp"

#include "support/surface_meshes.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using std::numbers::pi;

using surfaces::all_types;
using surfaces::name_of;

double surface_area(const SurfaceMesh& mesh) {
  double area = 0;
  for (std::int64_t e = 0; e < mesh.elements(); ++e) area += element_area(mesh, e);
  return area;
}

TEST(SurfaceGeometry, BrickHasItsAreaAndVolumeWhereverItStands) {
  for (ElementType type : all_types) {
    SurfaceMesh mesh = surfaces::block(surfaces::brick({2, 3, 4}, {1, 2, 3}), type);
    for (Vec3& x : mesh.node) x = x + Vec3{1000, -2000, 3000};
    expect_error("brick far from the origin, area, " + name_of(type), surface_area(mesh) / 22 - 1, 1e-12);
    expect_error("volume", enclosed_volume(mesh) / 6 - 1, 1e-12);
    expect_error("volume inside out", enclosed_volume(surfaces::turn_inside_out(mesh)) / 6 + 1, 1e-12);
  }
}

TEST(SurfaceGeometry, VolumeIsThatOfThePolynomialsThemselves) {
  // A quad9 face has a bump xi^2 eta^2, a tri6 a bulge 4 xi (1 - xi - eta) of one edge: cones from a far apex less
  // those of the flat element are the volume under the bump.
  const auto bump = surfaces::one_element(ElementType::quad9, [](const Vec3& r) {
    return Vec3{r[0], r[1], r[0] * r[0] * r[1] * r[1]};
  });
  expect_error("quad9 z = x^2 y^2, cone from (0, 0, -5)", cone_volume(bump, 0, {0, 0, -5}) - (20 - 3 * 4.0 / 9) / 3,
               1e-14);
  const auto bulge = surfaces::one_element(ElementType::tri6, [](const Vec3& r) {
    return Vec3{r[0], r[1], 4 * r[0] * (1 - r[0] - r[1])};
  });
  // The bulge is z = 4 x (1 - x - y), so the cone from (0, 0, -h) has h A/3 + int z = h/6 + 1/6.
  expect_error("tri6 z = 4 x (1 - x - y), cone from (0, 0, -3)", cone_volume(bulge, 0, {0, 0, -3}) - (3.0 + 1) / 6,
               1e-15);
}

TEST(SurfaceGeometry, SphereConvergesWithTheElementsOrder) {
  // Quadratic elements interpolate the sphere to h^3, but area and volume gain one order.
  for (ElementType type : all_types) {
    const int low = is_quadratic(type) ? 4 : 2;
    double area[2], volume[2];
    for (int i = 0; i < 2; ++i) {
      const SurfaceMesh mesh = surfaces::cube_sphere(type, 8 << i, 2);
      area[i] = std::abs(surface_area(mesh) / (16 * pi) - 1);
      volume[i] = std::abs(enclosed_volume(mesh) / (32 * pi / 3) - 1);
    }
    expect_error("sphere, order of the area less the expected, " + name_of(type), std::log2(area[0] / area[1]) - low,
                 0.1);
    expect_error("order of the volume less the expected", std::log2(volume[0] / volume[1]) - low, 0.1);
    expect_error("area", area[1], is_quadratic(type) ? 1e-5 : 1e-2);
    expect_error("volume", volume[1], is_quadratic(type) ? 1e-5 : 1.1e-2);
  }
}

TEST(SurfaceGeometry, NormalsOfASphereConvergeToRadialOnes) {
  for (ElementType type : {ElementType::tri6, ElementType::quad8, ElementType::quad9}) {
    double error[2] = {0, 0};
    for (int i = 0; i < 2; ++i) {
      const SurfaceMesh mesh = surfaces::cube_sphere(type, 16 << i, 3);
      for (std::int64_t e = 0; e < mesh.elements(); ++e) {
        const SurfaceFrame f = evaluate_surface(mesh, e, 0.3, 0.2);
        error[i] = std::max(error[i], length(normalized(f.x) - unit_normal(mesh, e, 0.3, 0.2)));
      }
    }
    expect_error("normals of a sphere, 32 elements to a quarter, " + name_of(type), error[1], 6e-4);
    expect_order("order", std::log2(error[0] / error[1]), 1.85);
  }
}

TEST(SurfaceGeometry, AnglesAroundANodeOfAFlatFaceAreAFullTurn) {
  for (ElementType type : all_types) {
    const SurfaceMesh mesh = surfaces::distort(surfaces::block(surfaces::brick({3, 3, 3}, {3, 3, 3}), type), 0.2, 7);
    std::vector<double> sum(mesh.node.size(), 0);
    for (std::int64_t e = 0; e < mesh.elements(); ++e)
      for (std::size_t i = 0; i < mesh.element(e).size(); ++i)
        sum[static_cast<std::size_t>(mesh.element(e)[i])] += angle_at_node(mesh, e, static_cast<int>(i));
    double flat = 0, edge = 0, corner = 0;
    int corners = 0;
    for (std::size_t k = 0; k < sum.size(); ++k) {
      int on = 0;
      for (double c : mesh.node[k]) on += c == 0 || c == 3;
      if (on == 1) flat = std::max(flat, std::abs(sum[k] - 2 * pi));
      if (on == 2) edge = std::max(edge, std::abs(sum[k] - 2 * pi));
      if (on == 3) corner = std::max(corner, std::abs(sum[k] - 1.5 * pi)), ++corners;
    }
    expect_error("angles on faces, " + name_of(type), flat, 1e-13);
    expect_error("angles on edges", edge, 1e-13);
    expect_error("angles at corners", corner, 1e-13);
    EXPECT_EQ(corners, 8);
  }
}

TEST(SurfaceGeometry, AnglesKeepTheirDigits) {
  expect_error("angle of 1e-10", angle_between({1, 0, 0}, {1, 1e-10, 0}) / 1e-10 - 1, 1e-15);
  expect_error("opposite vectors", angle_between({1e-200, 0, 0}, {-1e200, 0, 0}) - pi, 1e-15);
  EXPECT_EQ(length(normalized({0, 0, 0})), 0);
}

}  // namespace
}  // namespace rollcon
