// A block of boundary elements, held at its bottom, against the half-space that it becomes as it grows: a rigid sphere
// pressed on it, and rolling.

#include "support/example3.hpp"
#include "support/hertz_fit.hpp"
#include "support/surface_meshes.hpp"
#include "validation/report.hpp"

namespace rollcon::validation {
namespace {

namespace example3 = scenes::example3;

/// Zone 1.25 times as wide as the contact of example 3's sphere.
constexpr double zone = 2.5;

std::unique_ptr<scenes::RollingPair> block(double side, int n, int grade, ElementType type) {
  scenes::MeshedBody body;
  body.mesh = surfaces::zone_block({side, side / 2, zone, n, grade, grade}, type);
  body.material = example3::sphere;
  body.held_tag = {3};
  auto pair = std::make_unique<scenes::RollingPair>(body, scenes::RigidBody{}, 1);
  const double curvature = 1 / (2 * example3::radius);
  pair->frame_from_body(1, 2).gap_quadratic(curvature, curvature).speed(example3::speed);
  return pair;
}

/// The faces of a tag as a mesh of their own, all nodes kept.
SurfaceMesh faces_with_tag(const SurfaceMesh& mesh, std::int32_t tag) {
  SurfaceMesh part;
  part.node = mesh.node;
  part.offset.push_back(0);
  for (const std::int64_t e : surfaces::elements_with_tag(mesh, tag)) {
    const auto nodes = mesh.element(e);
    part.connectivity.insert(part.connectivity.end(), nodes.begin(), nodes.end());
    part.offset.push_back(static_cast<std::int64_t>(part.connectivity.size()));
    part.type.push_back(mesh.type[static_cast<std::size_t>(e)]);
    part.tag.push_back(tag);
  }
  return part;
}

struct Pressed {
  double p0 = 0, radius = 0, approach = 0;  ///< relative errors
};

Pressed press(scenes::RollingPair& pair) {
  pair.friction(0).load(example3::load);
  EXPECT_EQ(pair.solve(), ROLLCON_OK);
  const scenes::Solution s = pair.solution();
  const closed_forms::Hertz hertz = example3::hertz();
  const scenes::FittedEllipse fit = scenes::fit_hertz(s, hertz.a, hertz.a);
  return {relative(fit.p0, hertz.p0), relative(std::sqrt(fit.a * fit.b), hertz.a),
          relative(s.approach, hertz.approach)};
}

TEST(Block, becomes_a_half_space_as_it_grows) {
  double last = 0, last_side = 0;
  for (const double side : {10.0, 20.0, 40.0}) {
    auto pair = block(side, 10, side < 15 ? 4 : side < 30 ? 5 : 6, ElementType::quad4);
    const Pressed error = press(*pair);
    const std::string name = "block of side " + std::to_string(static_cast<int>(side)) + " mm: ";
    expect_error(name + "p0", error.p0, 0.02);
    expect_error(name + "radius", error.radius, 0.03);
    // A point load moves the half-space below it, at the depth side/2 of the held bottom, by
    // F (1 + nu)(3 - 2 nu)/(pi E side): 1.46 a/side of Hertz's approach. The free sides give back a part of it.
    expect_error(name + "approach", error.approach, 1.5 * example3::hertz().a / side);
    if (last > 0)
      expect_order(name + "approach against the block's size", observed_order(last, error.approach, side, last_side),
                   0.8);
    last = error.approach;
    last_side = side;
  }
}

TEST(Block_long, meets_the_half_space_as_its_mesh_is_refined) {
  double last = 0;
  for (const int n : {8, 12}) {
    auto pair = block(40, n, 7, ElementType::quad4);
    const Pressed error = press(*pair);
    const std::string name = "quad4, zone of " + std::to_string(n) + " x " + std::to_string(n);
    expect_error(name + ": p0", error.p0, 0.03 * 64 / (n * n));
    expect_error(name + ": radius", error.radius, 0.015 * 64 / (n * n));
    if (last > 0) expect_order(name + ": p0", observed_order(last, error.p0, 12, 8), 1.5);
    last = error.p0;
  }
  // Fewer quadratic elements do not resolve the edge of the contact (6 x 6: 4 % and 6 %).
  auto pair = block(40, 8, 4, ElementType::quad8);
  const Pressed error = press(*pair);
  expect_error("quad8, zone of 8 x 8: p0", error.p0, 0.005);
  expect_error("quad8, zone of 8 x 8: radius", error.radius, 0.015);
}

TEST(Block_long, rolls_like_the_half_space) {
  const surfaces::ZoneBlock shape{40, 20, zone, 8, 4, 4};
  auto pair = block(40, 8, 4, ElementType::quad8);
  scenes::RollingPair flat(example3::sphere, std::nullopt, 1);
  const double curvature = 1 / (2 * example3::radius);
  flat.frame(faces_with_tag(surfaces::zone_block(shape, ElementType::quad8), 2));
  flat.gap_quadratic(curvature, curvature).speed(example3::speed);
  for (scenes::RollingPair* p : {pair.get(), &flat}) p->friction(example3::mu).load(example3::load);
  const double bound = example3::mu * example3::load;
  for (const auto& creep : {std::array{-2e-3, 0.0, 0.0}, {0.0, -2e-3, 0.0}, {-1e-3, 5e-4, 1e-3}}) {
    std::array<scenes::Solution, 2> s;
    for (std::size_t i = 0; i < 2; ++i) {
      scenes::RollingPair& p = i == 0 ? *pair : flat;
      p.creep(creep[0], creep[1], creep[2]);
      ASSERT_EQ(p.solve(), ROLLCON_OK);
      s[i] = p.solution();
    }
    const std::string name = "block of side 40 mm, creepages " + std::to_string(creep[0]) + ", " +
                             std::to_string(creep[1]) + ", spin " + std::to_string(creep[2]);
    for (std::size_t c = 0; c < 2; ++c)
      expect_error(name + ": F" + std::to_string(c + 1) + " over mu Fn, half-space",
                   (s[0].force[c] - s[1].force[c]) / bound, 0.02);
  }
}

}  // namespace
}  // namespace rollcon::validation
