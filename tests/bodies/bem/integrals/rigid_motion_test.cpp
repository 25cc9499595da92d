// Tests that rigid motions leave no traction: rows of h times a translation vanish to rounding, times a rotation to the
// tolerance.

#include "bodies/bem/integrals/assembled_rows.hpp"
#include "mesh/shape.hpp"
#include "support/surface_meshes.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

constexpr double tolerance = 1e-6;

struct Residual {
  double translation = 0, rotation = 0;
};

Residual rigid_residual(const SurfaceMesh& mesh, std::span<const bem::CollocationPoint> points, double radius) {
  const bem::BoundaryIntegrals integrals(mesh, 0.3, tolerance);
  const auto system = assembled_rows::assemble(integrals, mesh, points, true, false);
  Residual worst;
  for (std::size_t p = 0; p < points.size(); ++p)
    for (int i = 0; i < 3; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        double translation = 0, rotation = 0;
        Vec3 w{};
        w[axis] = 1 / radius;
        for (std::size_t j = 0; j < mesh.node.size(); ++j) {
          const Vec3 u = cross(w, mesh.node[j]);
          translation += system.h(p, i, j, static_cast<int>(axis));
          for (int c = 0; c < 3; ++c) rotation += system.h(p, i, j, c) * u[static_cast<std::size_t>(c)];
        }
        worst.translation = std::max(worst.translation, std::abs(translation));
        worst.rotation = std::max(worst.rotation, std::abs(rotation));
      }
  return worst;
}

void check(const char* what, ElementType type, const Residual& r) {
  std::printf("%s %s: translation %.1e (bound 1e-13), rotation %.1e (bound %.0e)\n", surfaces::name_of(type).c_str(),
              what, r.translation, r.rotation, tolerance);
  EXPECT_LE(r.translation, 1e-13);
  EXPECT_LE(r.rotation, tolerance);
}

class RigidMotionRows : public ::testing::TestWithParam<ElementType> {};

TEST_P(RigidMotionRows, at_all_nodes) {
  const SurfaceMesh box = surfaces::block(surfaces::brick({3, 2, 2}, {3, 2, 1}), GetParam());
  check("box", GetParam(), rigid_residual(box, assembled_rows::all_nodes(box), 2));
  const SurfaceMesh plate = surfaces::block(surfaces::brick({4, 4, 1}, {1, 1, 0.02}), GetParam());
  check("thin plate", GetParam(), rigid_residual(plate, assembled_rows::all_nodes(plate), 1));
  const SurfaceMesh sphere = surfaces::cube_sphere(GetParam(), 3, 1);
  check("sphere", GetParam(), rigid_residual(sphere, assembled_rows::all_nodes(sphere), 1));
}

TEST_P(RigidMotionRows, at_points_inside_elements_and_on_their_edges) {
  const SurfaceMesh sphere = surfaces::cube_sphere(GetParam(), 2, 1);
  const bool triangle = corner_count(GetParam()) == 3;
  std::vector<bem::CollocationPoint> points;
  for (std::int32_t e = 0; e < sphere.elements(); e += 5)
    for (const double xi : {0.2, triangle ? 0.31 : 0.7, 0.999, 1.0}) {
      const double eta = triangle ? (1 - xi) / 3 : -0.4;
      points.push_back({{}, -1, e, xi, eta});
      Vec3 x{};
      Shape s;
      evaluate_shape(GetParam(), xi, eta, s);
      const auto nodes = sphere.element(e);
      for (std::size_t k = 0; k < nodes.size(); ++k)
        x = x + s.value[k] * sphere.node[static_cast<std::size_t>(nodes[k])];
      points.back().x = x;
    }
  check("points of the sphere", GetParam(), rigid_residual(sphere, points, 1));
}

INSTANTIATE_TEST_SUITE_P(types, RigidMotionRows, ::testing::Values(ElementType::tri6, ElementType::quad4),
                         [](const auto& info) { return surfaces::name_of(info.param); });
INSTANTIATE_TEST_SUITE_P(types_long, RigidMotionRows,
                         ::testing::Values(ElementType::tri3, ElementType::quad8, ElementType::quad9),
                         [](const auto& info) { return surfaces::name_of(info.param); });

TEST(RigidMotionRows, mixed_elements) {
  for (const bool quadratic : {false, true}) {
    const SurfaceMesh mesh = surfaces::mixed_block(surfaces::brick({3, 3, 3}, {1, 1, 1}), quadratic);
    check(quadratic ? "and others, mixed" : "and triangles, mixed", quadratic ? ElementType::quad8 : ElementType::quad4,
          rigid_residual(mesh, assembled_rows::all_nodes(mesh), 1));
  }
}

}  // namespace
}  // namespace rollcon
