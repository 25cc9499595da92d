// Tests a rigid cylinder in a groove of nearly its radius: contact that turns by 40 degrees to both sides, where
// pressures have directions of their own. Linear and quadratic meshes must tend to one answer.

#include <cmath>
#include <vector>

#include "support/example3.hpp"
#include "support/surface_meshes.hpp"
#include "validation/scenes.hpp"

namespace rollcon::validation {
namespace {

constexpr double radius = 10, thickness = 10, length_along = 6, half_angle = 1.0472;
constexpr double cylinder_radius = 9.9, depth = 0.05;

/// Makes a shell of 120 degrees around the x axis, held on its back; the groove is tag 6.
SurfaceMesh groove(ElementType type, int n) {
  surfaces::Block shape;
  for (int i = 0; i <= 2 * n; ++i) shape.line[0].push_back(half_angle * (i - n) / n);
  for (int i = 0; i <= n; ++i) shape.line[1].push_back(length_along * (1.0 * i / n - 0.5));
  for (int i = 0; i <= n / 2; ++i) shape.line[2].push_back(-radius - thickness * (1 - 2.0 * i / n));
  shape.map = [](const Vec3& q) { return Vec3{q[1], -q[2] * std::sin(q[0]), q[2] * std::cos(q[0])}; };
  return surfaces::turn_inside_out(surfaces::block(shape, type));
}

SurfaceMesh cylinder() {
  SurfaceMesh mesh =
      frames::rectangle(ElementType::quad8, frames::uniform_lines(-4, 4, 4), frames::uniform_lines(-1.3, 1.3, 24));
  for (Vec3& x : mesh.node)
    x = {x[0], cylinder_radius * std::sin(x[1]), cylinder_radius * (1 - std::cos(x[1])) - radius};
  return surfaces::turn_inside_out(mesh);
}

std::unique_ptr<RollingPair> pair(ElementType type, int n) {
  MeshedBody body, tool;
  body.mesh = groove(type, n);
  body.material = scenes::example3::sphere;
  body.held_tag = {5};
  body.contact_tag = {6};
  tool.mesh = cylinder();
  auto p = std::make_unique<RollingPair>(body, tool, 1);
  p->axes({0, 0, -radius}, {1, 0, 0}, {0, 0, 1}).frame_from_body(1, 6).friction(0);
  p->approach(depth);
  return p;
}

TEST(Conformal, a_cylinder_in_a_groove) {
  auto quadratic = pair(ElementType::quad8, 6);
  ASSERT_EQ(quadratic->solve(), ROLLCON_OK);
  const double force = -quadratic->solution().force[2];
  const double p0 = quadratic->stat("max_pressure");
  double last = 0;
  for (const int n : {6, 12}) {
    auto linear = pair(ElementType::quad4, n);
    ASSERT_EQ(linear->solve(), ROLLCON_OK);
    const Solution s = linear->solution();
    const std::string name = "quad4, " + std::to_string(n) + " elements along: ";
    const double error = relative(-s.force[2], force);
    expect_error(name + "force, 6 quad8", error, 0.012 * 6 / n);
    expect_error(name + "p0, 6 quad8", relative(linear->stat("max_pressure"), p0), 0.012 * 6 / n);
    double reach = 0;
    for (std::size_t k = 0; k < s.nodes(); ++k)
      if (s.pressure[k] > 0) reach = std::max(reach, std::asin(std::abs(s.y[k]) / radius));
    EXPECT_GT(reach, 0.6) << "radian to each side";
    if (last > 0) expect_order(name + "force", observed_order(last, error, 2, 1), 1);
    last = error;
  }
  quadratic->friction(0.3).creep(1e-3, 0, 0);
  ASSERT_EQ(quadratic->solve(), ROLLCON_OK);
  for (const char* law : {"law_normal", "law_friction", "law_slip"})
    expect_error(std::string("rolling along the groove: ") + law, quadratic->stat(law), 1e-8);
  EXPECT_NE(quadratic->plan().find("curved"), std::string::npos);
}

}  // namespace
}  // namespace rollcon::validation
