// Compares bodies whose factors are hierarchical with dense ones, and blocks of their equations with the whole matrix.

#include <filesystem>

#include "bodies/bem/collocation_blocks.hpp"
#include "bodies/model/mesh_models.hpp"
#include "bodies/model/surface_response.hpp"
#include "linalg/hierarchical_factor.hpp"
#include "mesh/surface_geometry.hpp"
#include "support/error.hpp"
#include "support/interrupt.hpp"
#include "support/static_cases.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using bem::CollocationBlocks;

constexpr double young = 200, poisson = 0.3;

/// Holds a brick with a clamped face, a sliding one and, if asked for, a node held alone.
struct Brick {
  explicit Brick(ElementType type, bool alone) {
    mesh.surface = surfaces::block(surfaces::brick({3, 2, 2}, {3, 1.5, 2}), type);
    mesh.held.assign(mesh.surface.node.size(), 0);
    mesh.held_value.assign(mesh.surface.node.size(), Vec3{0, 0, 0});
    const auto hold = [&](std::int32_t tag, std::uint8_t mask) {
      for (const std::int64_t e : surfaces::elements_with_tag(mesh.surface, tag))
        for (const std::int32_t k : mesh.surface.element(e)) mesh.held[static_cast<std::size_t>(k)] |= mask;
    };
    hold(1, 7);
    hold(3, 2);
    if (alone) mesh.held[static_cast<std::size_t>(mesh.surface.element(mesh.surface.elements() - 1)[0])] |= 1;
    fans = split_at_edges(mesh.surface, 40);
  }
  BodyMesh mesh;
  TractionNodes fans;
};

TEST(CollocationBlocks, are_parts_of_the_matrix) {
  for (const ElementType type : {ElementType::tri3, ElementType::quad4, ElementType::tri6, ElementType::quad8})
    for (const bool alone : {false, true}) {
      const Brick brick(type, alone);
      const auto body = bem::make_response(brick.mesh, brick.fans, young, poisson, {.prepare = 0}, 1, nullptr);
      const auto equations = body->as_equations()->equations(1);
      const auto n = static_cast<std::size_t>(equations->unknowns);

      const bem::LiftedSurface lifted = bem::lift(brick.mesh, 40);
      const bem::BoundaryIntegrals integrals(lifted.mesh, poisson, 1e-6);
      bem::Unknowns unknowns = bem::choose_unknowns(brick.mesh, brick.fans);
      for (bem::CollocationPoint& p : unknowns.point)
        if (p.element >= 0) p.x = evaluate_surface(lifted.mesh, p.element, p.xi, p.eta).x;
      std::vector<double> size(static_cast<std::size_t>(brick.fans.size()), 0.0);
      for (std::int64_t e = 0; e < brick.mesh.surface.elements(); ++e)
        for (std::int64_t k = brick.mesh.surface.offset[static_cast<std::size_t>(e)];
             k < brick.mesh.surface.offset[static_cast<std::size_t>(e) + 1]; ++k) {
          double& of = size[static_cast<std::size_t>(brick.fans.of[static_cast<std::size_t>(k)])];
          of = std::max(of, element_diameter(brick.mesh.surface, e));
        }
      const CollocationBlocks blocks(brick.mesh, brick.fans, lifted, integrals, unknowns, size, 2);
      double error = 0;
      for (const std::int32_t width : {1, 7, 40}) {
        std::vector<std::int32_t> rows, columns;
        for (std::int32_t k = width % 5; k < static_cast<std::int32_t>(n); k += 3) rows.push_back(k);
        std::reverse(rows.begin(), rows.end());
        for (std::int32_t k = 0; k < width; ++k) columns.push_back((37 * k) % static_cast<std::int32_t>(n));
        std::vector<double> part(rows.size() * columns.size());
        blocks.block(rows, columns, part.data());
        for (std::size_t j = 0; j < columns.size(); ++j)
          for (std::size_t i = 0; i < rows.size(); ++i)
            error = std::max(
                error,
                std::abs(
                    part[i + j * rows.size()] -
                    equations->dense[static_cast<std::size_t>(rows[i]) + static_cast<std::size_t>(columns[j]) * n]));
      }
      expect_error(surfaces::name_of(type) + (alone ? ", a node held alone" : "") + ", of entries near .5", error,
                   1e-6);

      // Each row belongs to one column and each column to one row.
      const std::vector<std::int32_t> column = unknowns.column_of_rows(brick.fans);
      std::vector<int> taken(n, 0);
      for (const std::int32_t k : column) ++taken[static_cast<std::size_t>(k)];
      EXPECT_EQ(taken, std::vector<int>(n, 1));
    }
}

#if ROLLCON_BUILD_HMAT
statics::StaticBody quarter(int n, std::int64_t factor) {
  statics::StaticBody body(surfaces::block(statics::walls::quarter_cylinder(n), ElementType::quad8),
                           statics::walls::young, poisson);
  body.body().set_int("factor", factor);
  statics::walls::press_cylinder(body);
  return body;
}

TEST(HierarchicalBodies, answer_as_dense_ones_do) {
  std::vector<Vec3> first;
  for (const std::int64_t factor : {1, 2}) {
    statics::StaticBody body = quarter(4, factor);
    body.body().set_real("factor_accuracy", 1e-5);
    body.solve();
    expect_error(
        "Lame, factor " + std::to_string(factor),
        body.displacement_error([](const Vec3& x) { return statics::walls::cylinder_displacement(x, poisson); }), 3e-4);
    std::vector<Vec3> u =
        statics::load_faces(body.body(), surfaces::elements_with_tag(body.mesh(), 6), [](const Vec3& x) {
          return Vec3{x[0], 1, -x[2]};
        }).u;
    for (std::int32_t k = 0; k < body.mesh().nodes(); ++k) u.push_back(100 * body.displacement(k));
    if (factor == 1) {
      first = u;
      continue;
    }
    double error = 0, size = 0;
    for (std::size_t k = 0; k < u.size(); ++k) {
      error = std::max(error, length(u[k] - first[k]));
      size = std::max(size, length(first[k]));
    }
    expect_error("beside dense factors", error / size, 2e-5);
    const BodyStatistics s = body.body().response()->statistics();
    EXPECT_LT(s.nonzeros, s.unknowns * s.unknowns);
    EXPECT_GT(s.condition, 1);
    EXPECT_GT(s.needed_bytes, 8.0 * static_cast<double>(s.nonzeros)) << "foreseen";
  }
}

// Blocks that are compressed by ACA+ to the accuracy itself make this error 9e-4.
TEST(HierarchicalBodies_long, errors_stay_near_the_accuracy_on_fine_meshes) {
  statics::StaticBody body = quarter(10, 2);
  body.body().set_real("factor_accuracy", 1e-4);
  body.solve();
  expect_error(std::to_string(body.mesh().nodes()) + " nodes, Lame",
               body.displacement_error([](const Vec3& x) { return statics::walls::cylinder_displacement(x, poisson); }),
               4e-4);
}

TEST(HierarchicalBodies, are_saved) {
  const std::string path = ::testing::TempDir() + "hierarchical.rcb";
  statics::StaticBody body = quarter(2, 2);
  body.solve();
  body.body().save(path);
  const auto loaded = Body::load(std::make_shared<Context>(), path);
  std::filesystem::remove(path);
  const std::vector<std::int64_t> faces = surfaces::elements_with_tag(body.mesh(), 6);
  const auto press = [&](Body& b) {
    return statics::load_faces(b, faces, [](const Vec3& x) { return Vec3{x[0], 1, -x[2]}; }).u;
  };
  EXPECT_EQ(press(*loaded), press(body.body()));
  EXPECT_EQ(loaded->response()->statistics().assemblies, 0);
  EXPECT_EQ(loaded->response()->statistics().factorizations, 0);
}

TEST(HierarchicalBodies, are_refused_where_they_are_too_inaccurate) {
  statics::StaticBody body(surfaces::block(statics::beam::shape(12, 36, 3), ElementType::quad8), 1000, 0.0);
  body.body().set_int("factor", 2);
  body.body().set_real("factor_accuracy", 1e-2);
  body.hold_tags({1});
  try {
    body.solve();
    FAIL() << "it was solved";
  } catch (const Error& e) {
    EXPECT_EQ(e.status(), Status::err_singular);
    EXPECT_NE(std::string(e.what()).find("factor_accuracy"), std::string::npos) << e.what();
  }
}
#else
TEST(HierarchicalBodies, are_refused_by_name) {
  statics::StaticBody body(surfaces::block(surfaces::brick({1, 1, 1}, {1, 1, 1}), ElementType::quad8), 1000, 0.3);
  body.body().set_int("factor", 2);
  body.hold_tags({1});
  try {
    body.solve();
    FAIL() << "it was solved";
  } catch (const Error& e) {
    EXPECT_EQ(e.status(), Status::err_unsupported);
    EXPECT_NE(std::string(e.what()).find("ROLLCON_WITH_HMAT"), std::string::npos) << e.what();
  }
}
#endif

}  // namespace
}  // namespace rollcon
