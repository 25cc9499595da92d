// Tests frames of their own laid on blocks of finite elements in whatever way: finer than the body's faces, from edge
// to edge of the top, over an insert of another material, in a steep groove; with and without contact faces named.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "support/volume_meshes.hpp"
#include "validation/scenes.hpp"

namespace rollcon::validation {
namespace {

using frames::uniform_lines;

/// Makes [-half, half]^2 x [-depth, 0] in n x n x layers hexahedra.
surfaces::Block slab(int n, int layers, double half, double depth) {
  surfaces::Block shape;
  shape.line = {uniform_lines(-half, half, n), uniform_lines(-half, half, n), uniform_lines(-depth, 0, layers)};
  return shape;
}

SurfaceMesh square(const Vec3& middle, double half, int n) {
  return frames::rectangle(ElementType::quad4, uniform_lines(middle[0] - half, middle[0] + half, n),
                           uniform_lines(middle[1] - half, middle[1] + half, n));
}

constexpr double mu = 0.3;

struct Fine {
  const char* name;
  VolumeType type;
  double node, between;  ///< bounds of the pressure over p0, on a node of the body and elsewhere
};

/// Presses a ball of radius 100 on a block whose faces are as large as the radius of the contact.
class FineFrame : public ::testing::TestWithParam<Fine> {
 protected:
  static constexpr double curvature = 0.005, load = 300;
  const Elastic material{.shear = 2e3 / 2.6, .poisson = 0.3};
  const Hertz hertz =
      closed_forms::hertz_from_load(curvature, curvature, closed_forms::effective_modulus(material), load);

  /// Lays a frame of n x n elements with its middle at (shift, shift); a node of the body is at the origin.
  std::unique_ptr<RollingPair> ball(double shift, int n) const {
    MeshedBody body = held(volumes::block(slab(10, 5, 10, 10), GetParam().type), material, {5}, {6});
    auto pair = std::make_unique<RollingPair>(body, RigidBody{}, 1);
    const Vec3 middle{shift, shift, 0};
    pair->frame(square(middle, 2.4, n)).axes(middle, {1, 0, 0}, {0, 0, 1});
    pair->gap_quadratic(curvature, curvature).friction(0);
    return pair;
  }
};

TEST_P(FineFrame, pressures_are_hertzian) {
  ASSERT_GT(hertz.a, 2);  // the size of a face
  for (const double shift : {0.0, 0.7, 1.0}) {
    const auto pair = ball(shift, 12);
    pair->load(load).solve();
    const Solution s = pair->solution();
    double on_node = 0, between = 0;
    for (std::size_t k = 0; k < s.nodes(); ++k) {
      if (std::hypot(s.x[k], s.y[k]) > hertz.a / 2) continue;
      const double error = std::abs(s.pressure[k] - hertz.pressure(s.x[k], s.y[k])) / hertz.p0;
      double& worst = std::hypot(s.x[k] + shift, s.y[k] + shift) < 1e-9 ? on_node : between;
      worst = std::max(worst, error);
    }
    const std::string where = "middle at " + std::to_string(shift) + ", pressure ";
    ASSERT_GT(between, 0);
    if (shift == 0) {
      ASSERT_GT(on_node, 0);
      expect_error(where + "on the body's node", on_node, GetParam().node);
    }
    expect_error(where + "around the middle", between, GetParam().between);
  }
}

TEST_P(FineFrame, refining_it_keeps_the_force) {
  for (const double shift : {0.0, 0.7}) {
    double force[2];
    for (const int half : {0, 1}) {
      const auto pair = ball(shift, half ? 24 : 12);
      pair->approach(hertz.approach).solve();
      force[half] = pair->solution().force[2];
    }
    EXPECT_LT(force[0], -load / 2);
    expect_error("middle at " + std::to_string(shift) + ", force of 24^2 elements against 12^2",
                 relative(force[1], force[0]), 0.02);
  }
}

INSTANTIATE_TEST_SUITE_P(Types, FineFrame, ::testing::Values(Fine{"hex8", VolumeType::hex8, 0.25, 0.12}),
                         [](const auto& param) { return std::string(param.param.name); });
INSTANTIATE_TEST_SUITE_P(Types_long, FineFrame, ::testing::Values(Fine{"hex20", VolumeType::hex20, 0.1, 0.1}),
                         [](const auto& param) { return std::string(param.param.name); });

// The half-space under the frame is of the insert's material, however soft most of the faces are that may come into
// contact.
class Insert : public ::testing::TestWithParam<double> {
 protected:
  enum class Contact { unnamed, named };

  /// Presses a ball on the middle of a block of E = 1 with a square core of E = ratio.
  static std::array<double, 3> force(double ratio, Contact choice, VolumeType type) {
    surfaces::Block shape = slab(16, 8, 1, 1);
    shape.zone_from = {4, 4};
    shape.zone_to = {12, 12};
    shape.zone_tag = 9;
    const Elastic soft{.shear = 1 / 2.6, .poisson = 0.3};
    MeshedBody body = held(
        volumes::with_materials(volumes::block(shape, type),
                                [](const Vec3& x) { return std::abs(x[0]) < 0.5 && std::abs(x[1]) < 0.5 ? 1 : 0; }),
        soft, {5});
    if (choice == Contact::named) body.contact_tag = {9};
    RollingPair pair(body, RigidBody{}, 1);
    if (rollcon_body_set_elastic(pair.body(1), 1, ratio * soft.young(), soft.poisson) != ROLLCON_OK)
      throw std::runtime_error("the insert has no material");
    pair.frame(square({0, 0, 0}, 0.43, 7)).gap_quadratic(0.1, 0.1).friction(mu);
    pair.approach(0.02).creep(1e-3, 0, 0).solve();
    return pair.solution().force;
  }
};

TEST_P(Insert, the_stiff_material_carries) {
  const double ratio = GetParam();
  const auto unnamed = force(ratio, Contact::unnamed, VolumeType::hex8),
             named = force(ratio, Contact::named, VolumeType::hex8),
             quadratic = force(ratio, Contact::named, VolumeType::hex20);
  EXPECT_LT(named[2], 0);
  const std::string of = ", E ratio " + std::to_string(static_cast<int>(ratio));
  for (const std::size_t c : {std::size_t{0}, std::size_t{2}})
    expect_error("F" + std::to_string(c + 1) + " against contact faces named" + of,
                 (unnamed[c] - named[c]) / std::abs((c == 0 ? mu : 1) * named[2]), 0.01);
  expect_error("F3 against hex20" + of, relative(unnamed[2], quadratic[2]), 0.005);
}

INSTANTIATE_TEST_SUITE_P(Ratios, Insert, ::testing::Values(1e2));
INSTANTIATE_TEST_SUITE_P(Ratios_long, Insert, ::testing::Values(1.0, 1e4));

/// Compares forces on a body without and with its top named as what may come into contact.
void expect_walls_without_part(const std::string& name, MeshedBody body, const SurfaceMesh& frame,
                               const std::vector<double>& gap, double approach) {
  std::array<double, 3> force[2];
  for (const int named : {0, 1}) {
    if (named) body.contact_tag = {6};
    RollingPair pair(body, RigidBody{}, 1);
    pair.frame(frame).axes({0, 0, 0}, {1, 0, 0}, {0, 0, 1}).gap(gap).friction(mu);
    ASSERT_GE(pair.approach(approach).creep(1e-3, 0, 0).solve(), ROLLCON_OK) << name;
    force[named] = pair.solution().force;
  }
  EXPECT_LT(force[1][2], 0) << name;
  for (std::size_t c = 0; c < 3; ++c)
    expect_error(name + ", F" + std::to_string(c + 1), (force[0][c] - force[1][c]) / std::abs(force[1][2]), 1e-6);
}

std::vector<double> paraboloid(const SurfaceMesh& frame, double along, double across) {
  std::vector<double> gap;
  for (const Vec3& x : frame.node) gap.push_back(along * x[0] * x[0] + across * x[1] * x[1]);
  return gap;
}

class Edges : public ::testing::TestWithParam<VolumeType> {
 protected:
  const Elastic material{.shear = 1 / 2.6, .poisson = 0.3};
};

TEST_P(Edges, of_a_slab_do_not_feel_the_frame) {
  // The columns are faces of the body along an edge, its layers, elements of the frame, and half its width.
  const std::tuple<int, int, int, double> cases[] = {{1, 1, 1, 1}, {1, 1, 3, 1},   {1, 2, 7, 1},
                                                     {2, 3, 3, 1}, {3, 2, 2, 1},   {3, 2, 7, 1},
                                                     {5, 1, 4, 1}, {3, 2, 4, 0.9}, {3, 2, 7, 0.7}};
  for (const auto& [n, layers, elements, half] : cases) {
    const SurfaceMesh frame = square({0, 0, 0}, half, elements);
    char name[80];
    std::snprintf(name, sizeof name, "%d^2 faces, %d layers, frame %d^2, +-%g", n, layers, elements, half);
    expect_walls_without_part(name, held(volumes::block(slab(n, layers, 1, 0.5), GetParam()), material, {5}), frame,
                              paraboloid(frame, 0.05, 0.05), 0.15);
  }
}

// Rollers of radius 10 lie around the y axis, straight or crowned; the frame is as wide as they are.
TEST_P(Edges, of_a_roller_do_not_feel_the_frame) {
  for (const double crown : {0.0, 0.1})
    for (const int elements : {8, 11}) {
      surfaces::Block shape;
      shape.line = {uniform_lines(-0.2, 0.2, 9), uniform_lines(-1, 1, 5), uniform_lines(6, 10, 3)};
      shape.map = [&](const Vec3& q) -> Vec3 {
        const double r = q[2] - (q[2] - 6) / 4 * crown * q[1] * q[1];
        return {r * std::sin(q[0]), q[1], r * std::cos(q[0]) - 10};
      };
      const SurfaceMesh frame = frames::transform(
          frames::rectangle(ElementType::quad4, uniform_lines(-0.05, 0.05, elements), uniform_lines(-1, 1, elements)),
          [&](const Vec3& q) {
            return shape.map({q[0], q[1], 10});
          });
      expect_walls_without_part("crown " + std::to_string(crown) + ", frame " + std::to_string(elements) + "^2",
                                held(volumes::block(shape, GetParam()), material, {5}), frame,
                                paraboloid(frame, 0.06, 0.002), 0.01);
    }
}

INSTANTIATE_TEST_SUITE_P(Types, Edges, ::testing::Values(VolumeType::hex8),
                         [](const auto& param) { return volumes::name_of(param.param); });
INSTANTIATE_TEST_SUITE_P(Types_long, Edges, ::testing::Values(VolumeType::hex20),
                         [](const auto& param) { return volumes::name_of(param.param); });

// A groove along x has walls that stand 54 degrees off the normal of the axes.
TEST(SteepGroove, is_solved_on_coarse_faces) {
  constexpr double steepest = 0.95;
  std::array<double, 3> force[2];
  for (const int finer : {0, 1}) {
    surfaces::Block shape;
    shape.line = {uniform_lines(-1, 1, 6), uniform_lines(-1.4, 1.4, finer ? 20 : 10), uniform_lines(-2, -1, 3)};
    shape.map = [](const Vec3& q) -> Vec3 { return {q[0], -q[2] * std::sin(q[1]), q[2] * std::cos(q[1])}; };
    MeshedBody body = held(volumes::block(shape, VolumeType::hex20), {.shear = 1, .poisson = 0.3}, {5}, {6});
    const SurfaceMesh frame = frames::transform(
        frames::rectangle(ElementType::quad4, uniform_lines(-0.6, 0.6, 8), uniform_lines(-steepest, steepest, 14)),
        [&](const Vec3& q) {
          return shape.map({q[0], q[1], -1});
        });
    std::vector<double> gap;
    for (const Vec3& x : frame.node) gap.push_back(0.05 * x[0] * x[0] + 0.01 * (1 + x[2]));
    RollingPair pair(body, RigidBody{}, 1);
    pair.frame(frame).axes({0, 0, -1}, {1, 0, 0}, {0, 0, 1}).gap(gap).friction(mu);
    ASSERT_GE(pair.approach(0.01).creep(1e-3, 0, 0).solve(), ROLLCON_OK);
    force[finer] = pair.solution().force;
    const Solution s = pair.solution();
    bool wall = false;  // true if a node is in contact, and steep
    for (std::size_t k = 0; k < s.nodes(); ++k) wall = wall || (s.pressure[k] > 0 && std::abs(s.y[k]) > std::sin(0.8));
    EXPECT_TRUE(wall);
    for (const char* law : {"law_normal", "law_friction", "law_slip"}) expect_error(law, pair.stat(law), 1e-7);
  }
  EXPECT_LT(force[1][2], 0);
  for (const std::size_t c : {std::size_t{0}, std::size_t{2}})
    expect_error("F" + std::to_string(c + 1) + " of 10 faces around against 20",
                 (force[0][c] - force[1][c]) / std::abs((c == 0 ? mu : 1) * force[1][2]), 0.02);
}

// A plate thinner than its faces are wide lies under a finer frame and a rigid paraboloid.
TEST(ThinPlate, is_solved_on_coarse_faces) {
  double force[2];
  for (const int finer : {0, 1}) {
    RollingPair pair(held(volumes::block(slab(finer ? 32 : 8, 3, 2, 0.1), VolumeType::hex20),
                          {.shear = 1 / 2.6, .poisson = 0.3}, {5}, {6}),
                     RigidBody{}, 1);
    pair.frame(square({-0.05, -0.02, 0}, 1, 16)).gap_quadratic(0.05, 0.05).friction(0).approach(0.02).solve();
    force[finer] = pair.solution().force[2];
  }
  expect_error("faces five times as wide as the plate is thick", std::abs(force[0] / force[1] - 1), 0.04);
}

}  // namespace
}  // namespace rollcon::validation
