// The meshes that bodies are tested and shown with: closed, oriented, of the right shape and count.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "support/surface_meshes.hpp"
#include "validation/report.hpp"

namespace rollcon {
namespace {

using surfaces::all_types;
using surfaces::Facts;
using surfaces::name_of;
using validation::expect_error;
using validation::expect_order;
using validation::observed_order;
using validation::relative;

constexpr double pi = std::numbers::pi;
void expect_closed(const SurfaceMesh& mesh, std::int64_t euler) {
  const Facts f = surfaces::facts(mesh);
  EXPECT_EQ(f.open_edges, 0);
  EXPECT_EQ(f.clashing_edges, 0);
  EXPECT_EQ(f.unused_nodes, 0);
  EXPECT_EQ(f.euler, euler);
  EXPECT_GT(f.volume, 0);
}

double zone_area(const SurfaceMesh& mesh) {
  double area = 0;
  for (const std::int64_t e : surfaces::elements_with_tag(mesh, 2)) {
    const auto n = mesh.element(e);
    const auto at = [&](std::size_t i) { return mesh.node[static_cast<std::size_t>(n[i])]; };
    area += 0.5 * length(cross(at(2) - at(0), at(n.size() > 3 ? 3 : 1) - at(1)));
  }
  return area;
}

TEST(Meshes, bricks_of_all_types_are_exact_and_stay_so_when_distorted) {
  const auto shape = surfaces::brick({3, 2, 4}, {1.5, 1, 2});
  const auto check = [](const SurfaceMesh& mesh, const std::string& what) {
    expect_closed(mesh, 2);
    const Facts f = surfaces::facts(mesh);
    expect_error(what + " volume", relative(f.volume, 3), 1e-13);
    expect_error(what + " area", relative(f.area, 13), 1e-13);
    expect_error(what + " centroid", length(f.centroid - Vec3{0.75, 0.5, 1}), 1e-13);
    for (std::int64_t e = 0; e < mesh.elements(); ++e)
      for (const std::int32_t k : mesh.element(e)) {
        const auto tag = static_cast<std::size_t>(mesh.tag[static_cast<std::size_t>(e)]) - 1;
        const double size[3] = {1.5, 1, 2};
        EXPECT_EQ(mesh.node[static_cast<std::size_t>(k)][tag / 2], tag % 2 ? size[tag / 2] : 0);
      }
  };
  for (const ElementType type : all_types) {
    check(surfaces::block(shape, type), name_of(type));
    check(surfaces::distort(surfaces::block(shape, type), 0.25, 3), name_of(type) + " distorted");
  }
  for (const bool quadratic : {false, true})
    check(surfaces::distort(surfaces::mixed_block(shape, quadratic), 0.2, 5),
          quadratic ? "mixed quadratic" : "mixed linear");
}

TEST(Meshes, spheres_converge_to_the_sphere) {
  const double volume = 4 * pi / 3 * 8;
  for (const ElementType type : all_types) {
    double error[2];
    for (const int level : {0, 1}) {
      const SurfaceMesh mesh = surfaces::cube_sphere(type, 3 << level, 2);
      expect_closed(mesh, 2);
      error[level] = relative(surfaces::facts(mesh).volume, volume);
    }
    expect_order("cube sphere " + name_of(type), observed_order(error[0], error[1], 2, 1),
                 is_quadratic(type) ? 3.5 : 1.8);
    if (corner_count(type) != 3) continue;
    for (const int level : {0, 1}) {
      const SurfaceMesh mesh = surfaces::icosphere(type, 2 << level, 2);
      EXPECT_EQ(mesh.elements(), 20 * (2 << level) * (2 << level));
      expect_closed(mesh, 2);
      error[level] = relative(surfaces::facts(mesh).volume, volume);
    }
    expect_order("icosphere " + name_of(type), observed_order(error[0], error[1], 2, 1),
                 is_quadratic(type) ? 3.5 : 1.8);
  }
}

TEST(Meshes, a_cavity_is_a_second_closed_surface_seen_from_inside) {
  const SurfaceMesh mesh = surfaces::with_cavity(surfaces::cube_sphere(ElementType::quad8, 6, 2, 1),
                                                 surfaces::icosphere(ElementType::tri6, 4, 1, 2));
  expect_closed(mesh, 4);
  expect_error("thick sphere, volume", relative(surfaces::facts(mesh).volume, 4 * pi / 3 * 7), 3e-4);
}

TEST(Meshes, ring_of_the_first_example_has_the_papers_counts) {
  const SurfaceMesh full = surfaces::ring({}, ElementType::quad4);
  EXPECT_EQ(full.nodes(), 1472);
  EXPECT_EQ(full.elements(), 1472);
  expect_closed(full, 0);
  EXPECT_EQ(surfaces::elements_with_tag(full, 2).size(), 144u);
  expect_error("zone of the ring, area", relative(zone_area(full), 2.4 * 8), 1e-3);

  surfaces::Ring half;
  half.sector = pi;
  half.around = 32;
  half.deep = 8;
  const SurfaceMesh sector = surfaces::ring(half, ElementType::quad4);
  EXPECT_EQ(sector.nodes(), 1474);
  EXPECT_EQ(sector.elements(), 1472);
  expect_closed(sector, 2);
}

TEST(Meshes, all_nodes_of_a_ring_lie_on_it) {
  for (const ElementType type : all_types) {
    const SurfaceMesh mesh = surfaces::ring({}, type);
    double error = 0;
    for (std::int64_t e = 0; e < mesh.elements(); ++e) {
      const std::int32_t tag = mesh.tag[static_cast<std::size_t>(e)];
      for (const std::int32_t k : mesh.element(e)) {
        const Vec3& x = mesh.node[static_cast<std::size_t>(k)];
        if (tag <= 3) error = std::max(error, std::abs(std::hypot(x[0], x[2]) - (tag == 3 ? 25 : 50)));
        if (tag > 3) error = std::max(error, std::abs(x[1] - (tag == 4 ? -4 : 4)));
        if (tag == 2) {
          EXPECT_LE(std::abs(50 * std::atan2(x[0], x[2])), 1.2 + 1e-9);
        }
      }
    }
    expect_error(name_of(type) + " distance of nodes from the ring", error, 1e-12);
    const double volume = pi * 8 * (50 * 50 - 25 * 25);
    expect_error(name_of(type) + " volume", relative(surfaces::facts(mesh).volume, volume),
                 is_quadratic(type) ? 2e-4 : 0.02);
  }
}

TEST(Meshes, wheel_of_the_fourth_example_has_the_papers_counts) {
  const SurfaceMesh mesh = surfaces::wheel(0, ElementType::quad4);
  EXPECT_EQ(mesh.nodes(), 1954);
  EXPECT_EQ(mesh.elements(), 1952);
  expect_closed(mesh, 2);
  EXPECT_EQ(surfaces::elements_with_tag(mesh, 2).size(), 14u * 15u);
  expect_error("zone of the wheel, area", relative(zone_area(mesh), 5.49 * 7 * std::hypot(1, 0.05)), 1e-4);
  const SurfaceMesh crowned = surfaces::wheel(300, ElementType::quad8);
  expect_closed(crowned, 2);
  double error = 0;
  for (const std::int32_t tag : {1, 2})
    for (const std::int64_t e : surfaces::elements_with_tag(crowned, tag))
      for (const std::int32_t k : crowned.element(e)) {
        const Vec3& x = crowned.node[static_cast<std::size_t>(k)];
        error = std::max(error, std::abs(std::hypot(x[0], x[2]) - (355.6 - 0.05 * x[1] - x[1] * x[1] / 600)));
      }
  expect_error("distance of nodes from cone and crown", error, 1e-10);
}

TEST(Meshes, block_with_a_fine_zone) {
  for (const ElementType type : all_types) {
    const surfaces::ZoneBlock shape{.side = 3, .depth = 2, .zone = 0.4, .n = 6, .grade = 4, .deep = 5};
    const SurfaceMesh mesh = surfaces::zone_block(shape, type);
    expect_closed(mesh, 2);
    expect_error(name_of(type) + " volume", relative(surfaces::facts(mesh).volume, 18), 1e-13);
    EXPECT_EQ(surfaces::elements_with_tag(mesh, 2).size(), corner_count(type) == 3 ? 72u : 36u);
    for (const std::int64_t e : surfaces::elements_with_tag(mesh, 2))
      for (const std::int32_t k : mesh.element(e)) {
        const Vec3& x = mesh.node[static_cast<std::size_t>(k)];
        EXPECT_LE(std::max(std::abs(x[0]), std::abs(x[1])), 0.2 + 1e-12);
        EXPECT_EQ(x[2], 0);
      }
  }
}

}  // namespace
}  // namespace rollcon
