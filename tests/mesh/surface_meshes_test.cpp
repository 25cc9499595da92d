// Tests the surface meshes of tests, benches and examples: closed, oriented, of the right shape and count.

#include "support/surface_meshes.hpp"

#include "support/testing.hpp"

namespace rollcon {
namespace {

using surfaces::all_types;
using surfaces::name_of;

constexpr double pi = std::numbers::pi;

/// Expects a closed mesh of this Euler characteristic and volume, with every node of a face in its place: off(tag,
/// node) is 0.
void expect_made(const SurfaceMesh& mesh, const std::string& what, std::int64_t euler, double volume, double bound,
                 const std::function<double(std::int32_t, const Vec3&)>& off) {
  const surfaces::Facts f = surfaces::facts(mesh);
  EXPECT_EQ(f.open_edges + f.clashing_edges + f.unused_nodes, 0) << what;
  EXPECT_EQ(f.euler, euler) << what;
  expect_error(what + ", volume", relative(f.volume, volume), bound);
  double worst = 0;
  for (std::int64_t e = 0; e < mesh.elements(); ++e)
    for (const std::int32_t k : mesh.element(e))
      worst = std::max(worst, std::abs(off(mesh.tag[surfaces::at(e)], mesh.node[surfaces::at(k)])));
  expect_error(what + ", nodes off their places", worst, 1e-10);
}

std::size_t tagged(const SurfaceMesh& mesh, std::int32_t tag) {
  return surfaces::elements_with_tag(mesh, tag).size();
}

double zone_area(const SurfaceMesh& mesh) {
  return surfaces::facts(surfaces::part_with_tag(mesh, 2)).area;
}

TEST(SurfaceMeshes, BricksStayBricksWhenDistorted) {
  const Vec3 size{1.5, 1, 2};
  const auto shape = surfaces::brick({3, 2, 4}, size);
  const auto check = [&](const SurfaceMesh& mesh, const std::string& what) {
    // Each node is on its plane: x = 0, x = 1.5, y = 0, ...
    expect_made(mesh, what, 2, 3, 1e-13, [&](std::int32_t tag, const Vec3& x) {
      const std::size_t axis = surfaces::at(tag - 1) / 2;
      return x[axis] - (tag % 2 ? 0 : size[axis]);
    });
    const surfaces::Facts f = surfaces::facts(mesh);
    expect_error(what + " area", relative(f.area, 13), 1e-13);
    expect_error(what + " centroid", length(f.centroid - Vec3{0.75, 0.5, 1}), 1e-13);
  };
  for (const ElementType type : all_types) {
    check(surfaces::block(shape, type), name_of(type));
    check(surfaces::distort(surfaces::block(shape, type), 0.25, 3), name_of(type) + " distorted");
  }
  for (const bool quadratic : {false, true})
    check(surfaces::distort(surfaces::mixed_block(shape, quadratic), 0.2, 5),
          quadratic ? "mixed quadratic" : "mixed linear");
}

TEST(SurfaceMeshes, Spheres) {
  const double volume = 4 * pi / 3 * 8;
  const auto off = [](std::int32_t tag, const Vec3& x) { return length(x) - tag; };
  for (const ElementType type : all_types)
    expect_made(surfaces::cube_sphere(type, 6, 2, 2), "cube sphere " + name_of(type), 2, volume,
                is_quadratic(type) ? 3e-4 : 0.04, off);
  for (const ElementType type : {ElementType::tri3, ElementType::tri6}) {
    const SurfaceMesh mesh = surfaces::icosphere(type, 4, 2, 2);
    EXPECT_EQ(mesh.elements(), 20 * 4 * 4);
    expect_made(mesh, "icosphere " + name_of(type), 2, volume, is_quadratic(type) ? 3e-4 : 0.05, off);
  }
  const SurfaceMesh hollow = surfaces::with_cavity(surfaces::cube_sphere(ElementType::quad8, 6, 2, 2),
                                                   surfaces::icosphere(ElementType::tri6, 4, 1, 1));
  expect_made(hollow, "thick sphere", 4, 4 * pi / 3 * 7, 3e-4, off);
}

TEST(SurfaceMeshes, RingOfTheFirstExample) {
  for (const ElementType type : all_types)
    expect_made(surfaces::ring({}, type), name_of(type) + " ring", 0, pi * 8 * (50 * 50 - 25 * 25),
                is_quadratic(type) ? 2e-4 : 0.02, [](std::int32_t tag, const Vec3& x) {
                  if (tag > 3) return x[1] - (tag == 4 ? -4 : 4);
                  EXPECT_TRUE(tag != 2 || std::abs(50 * std::atan2(x[0], x[2])) <= 1.2 + 1e-9);
                  return std::hypot(x[0], x[2]) - (tag == 3 ? 25 : 50);
                });
  // The counts are the paper's.
  const SurfaceMesh full = surfaces::ring({}, ElementType::quad4);
  EXPECT_EQ(full.nodes(), 1472);
  EXPECT_EQ(full.elements(), 1472);
  EXPECT_EQ(tagged(full, 2), 144u);
  expect_error("zone of the ring, area", relative(zone_area(full), 2.4 * 8), 1e-3);
  const SurfaceMesh sector = surfaces::ring({.sector = pi, .around = 32, .deep = 8}, ElementType::quad4);
  EXPECT_EQ(sector.nodes(), 1474);
  EXPECT_EQ(sector.elements(), 1472);
  EXPECT_EQ(surfaces::facts(sector).euler, 2);
}

TEST(SurfaceMeshes, WheelOfTheFourthExample) {
  const SurfaceMesh mesh = surfaces::wheel(0, ElementType::quad4), crowned = surfaces::wheel(300, ElementType::quad8);
  EXPECT_EQ(mesh.nodes(), 1954);
  EXPECT_EQ(mesh.elements(), 1952);
  EXPECT_EQ(tagged(mesh, 2), 14u * 15u);
  expect_error("zone of the wheel, area", relative(zone_area(mesh), 5.49 * 7 * std::hypot(1, 0.05)), 1e-4);
  for (const auto& [wheel, crown] : {std::pair{&mesh, 0.0}, {&crowned, 1 / 600.0}})
    expect_made(*wheel, "wheel", 2, surfaces::facts(mesh).volume, 0.05,
                [crown](std::int32_t tag, const Vec3& x) {  // tread, cone and crown
                  return tag > 2 ? 0 : std::hypot(x[0], x[2]) - (355.6 - 0.05 * x[1] - crown * x[1] * x[1]);
                });
}

TEST(SurfaceMeshes, BlockWithAFineZone) {
  const surfaces::ZoneBlock shape{.side = 3, .depth = 2, .zone = 0.4, .n = 6, .grade = 4, .deep = 5};
  for (const ElementType type : all_types) {
    const SurfaceMesh mesh = surfaces::zone_block(shape, type);
    EXPECT_EQ(tagged(mesh, 2), corner_count(type) == 3 ? 72u : 36u);
    expect_made(mesh, name_of(type) + " block", 2, 18, 1e-13, [](std::int32_t tag, const Vec3& x) {
      EXPECT_TRUE(tag != 2 || std::max(std::abs(x[0]), std::abs(x[1])) <= 0.2 + 1e-12);
      return tag <= 2 ? x[2] : tag == 3 ? x[2] + 2 : std::abs(x[tag < 6 ? 0 : 1]) - 1.5;
    });
  }
}

}  // namespace
}  // namespace rollcon
