// The ring of the paper's first example under loads on a patch of its outer surface (support/loaded_ring.hpp).

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "support/loaded_ring_body.hpp"
#include "validation/report.hpp"

namespace rollcon {
namespace {

namespace loaded_ring = statics::loaded_ring;
using loaded_ring::Load;
using statics::StaticBody;
using validation::expect_error;
using validation::relative;

/// How the whole ring is made of what is meshed.
enum class Part { whole, quarter };

struct Case {
  Part part;
  ElementType type;
  loaded_ring::Quarter elements;
  double bound, axial;  ///< axial: of the load that bends the ring out of its plane
};

SurfaceMesh ring_mesh(const Case& c) {
  const auto [zone, far, across, deep] = c.elements;
  if (c.part == Part::quarter) return surfaces::block(loaded_ring::quarter(c.elements), c.type);
  SurfaceMesh mesh = surfaces::ring({.zone = 4,
                                     .around = 2 * (zone + far),
                                     .zone_around = 2 * zone,
                                     .across = 2 * across,
                                     .deep = deep,
                                     .largest = 0,
                                     .top_layer = 2.0 / zone,
                                     .side_grading = 1},
                                    c.type);
  for (std::int32_t& tag : mesh.tag)  // as the quarter's: outer 6, hub 5, sides 3 and 4
    tag = tag <= 2 ? 6 : tag == 3 ? 5 : tag - 1;
  return mesh;
}

/// The factorised ring for one kind of load (the quarter's supports depend on it).
std::unique_ptr<StaticBody> held_ring(Part part, SurfaceMesh mesh, Load kind, double poisson) {
  auto body = std::make_unique<StaticBody>(std::move(mesh), loaded_ring::young, poisson);
  if (part == Part::whole) {
    body->hold_tags({5}).solve();
  } else {
    loaded_ring::hold_quarter(*body, kind);
  }
  return body;
}

void expect_listed(const Case& c, const SurfaceMesh& mesh, Load kind, double poisson) {
  const auto body = held_ring(c.part, mesh, kind, poisson);
  for (const auto& [what, error] : loaded_ring::listed_errors(*body, kind, poisson))
    expect_error(surfaces::name_of(c.type) + (c.part == Part::whole ? " ring, " : " quarter ring, ") +
                     std::to_string(mesh.nodes()) + " nodes, " + what,
                 error, kind == Load::axial ? c.axial : c.bound);
}

class PatchLoad : public ::testing::TestWithParam<Case> {};

TEST_P(PatchLoad, moves_the_ring_as_listed) {
  const Case& c = GetParam();
  const SurfaceMesh mesh = ring_mesh(c);
  expect_listed(c, mesh, Load::normal, 0.3);
  expect_listed(c, mesh, Load::tangential, 0.3);
  expect_listed(c, mesh, Load::normal, 0.49);
  expect_listed(c, mesh, Load::axial, 0.3);
}

constexpr auto ring_part_name = [](const auto& param) {
  return surfaces::name_of(param.param.type) + (param.param.part == Part::whole ? "_whole" : "_quarter");
};

// Bounds: 2 % (linear) and 0.5 % (quadratic) as asked of meshes that fit 4000 nodes; coarser ones as measured. Wholes
// of 2816 nodes (quad4) and 3456 (quad8), too long for here: 0.7 % and 0.4 %.
INSTANTIATE_TEST_SUITE_P(Ring, PatchLoad,
                         ::testing::Values(Case{Part::whole, ElementType::quad4, {4, 16, 3, 8}, 0.018, 0.011}),
                         ring_part_name);
INSTANTIATE_TEST_SUITE_P(Ring_long, PatchLoad,
                         ::testing::Values(Case{Part::whole, ElementType::quad8, {2, 8, 3, 5}, 0.0085, 0.03},
                                           Case{Part::quarter, ElementType::tri3, {6, 20, 3, 12}, 0.02, 0.006},
                                           Case{Part::quarter, ElementType::quad4, {6, 20, 3, 12}, 0.02, 0.006},
                                           Case{Part::quarter, ElementType::tri6, {2, 8, 3, 6}, 0.0075, 0.012},
                                           Case{Part::quarter, ElementType::quad8, {4, 10, 3, 8}, 0.005, 0.012},
                                           Case{Part::quarter, ElementType::quad9, {2, 8, 3, 6}, 0.0075, 0.012}),
                         ring_part_name);

// Three ways to the same load: nodal tractions on the body's faces, on a mesh of its own laid on them, and the body's
// own load by tag.
TEST(RingLoads_long, by_faces_by_a_layer_and_by_tag_agree) {
  for (const ElementType type : surfaces::all_types) {
    SurfaceMesh mesh = surfaces::block(loaded_ring::quarter({2, 6, 3, 3}), type);
    const auto patch = loaded_ring::patch_of(mesh);
    for (const std::int64_t e : patch) mesh.tag[static_cast<std::size_t>(e)] = 9;
    StaticBody body(mesh, loaded_ring::young, 0.3);
    const Vec3 t{30, 10, -80};
    body.hold_tags({5}).traction(9, t).solve();
    const statics::Loaded faces = statics::load_faces(body.body(), patch, [&](const Vec3&) { return t; });
    std::vector<std::int32_t> node;
    const SurfaceMesh part = surfaces::part_of(mesh, patch, node);
    const auto layer = body.body().response()->rows({{}, part, faces.node}, 1);
    std::vector<double> loads, u(3 * faces.node.size());
    for (std::size_t k = 0; k < part.node.size(); ++k) loads.insert(loads.end(), t.begin(), t.end());
    multiply(layer->u.data(), layer->u.rows(), layer->u.columns(), loads.data(), 0, u.data());
    double by_layer = 0, by_tag = 0, size = 0;
    for (std::size_t k = 0; k < faces.node.size(); ++k) {
      size = std::max(size, length(faces.u[k]));
      by_layer = std::max(by_layer, length(faces.u[k] - Vec3{u[3 * k], u[3 * k + 1], u[3 * k + 2]}));
      by_tag = std::max(by_tag, length(faces.u[k] - body.displacement(faces.node[k])));
    }
    // A layer of linear elements lies a little below faces that are curved through their nodes.
    expect_error(surfaces::name_of(type) + " ring, layer against faces", by_layer / size,
                 is_quadratic(type) ? 1e-6 : 5e-4);
    expect_error(surfaces::name_of(type) + " ring, tag against faces", by_tag / size, 1e-6);
  }
}

TEST(RingMaterials_long, displacements_are_smooth_up_to_incompressible) {
  const SurfaceMesh mesh = surfaces::block(loaded_ring::quarter({4, 6, 3, 3}), ElementType::quad8);
  const auto middle = [&](double poisson) {
    const auto body = held_ring(Part::quarter, mesh, Load::normal, poisson);
    return loaded_ring::loaded(*body, Load::normal).at(0, 0)[2];
  };
  const double u49 = middle(0.49), u499 = middle(0.499), u5 = middle(0.5);
  // A straight line through 0.49 and 0.499 misses 0.5 by the curvature only.
  expect_error("u_n at nu = 0.5 against extrapolation", relative(u5, u499 + (u499 - u49) / 9), 1e-3);
  expect_error("nu = 0.5 against 0.499", relative(u5, u499), 0.02);
}

}  // namespace
}  // namespace rollcon
