// Compares blocks of boundary and of finite elements, held at their bottom, under the sphere of example 3, pressed and
// rolling, with Hertz and with the half-space that they become as they grow, on their own faces and under frames laid
// on them, and as nu tends to 1/2.

#include "mesh/corner_elements.hpp"
#include "support/any_element.hpp"
#include "support/example3.hpp"
#include "validation/scenes.hpp"

namespace rollcon::validation {
namespace {

namespace example3 = scenes::example3;
using surfaces::ZoneBlock;

/// The zone is 1.25 times as wide as the contact.
constexpr double zone = 2.5, curvature = 1 / (2 * example3::radius);

MeshedBody block(const ZoneBlock& shape, AnyElement type, const Elastic& material = example3::sphere) {
  if (is_finite_element(type)) return held(volumes::zone_block(shape, std::get<VolumeType>(type)), material, {3}, {2});
  return held(surfaces::zone_block(shape, std::get<ElementType>(type)), material, {3}, {2});
}

/// Holds results over those of Hertz.
struct Pressed {
  double p0, a, approach;
};

Pressed press(RollingPair& pair) {
  pair.gap_quadratic(curvature, curvature).friction(0).load(example3::load);
  EXPECT_EQ(pair.solve(), ROLLCON_OK);
  const Solution s = pair.solution();
  const Hertz hertz = example3::hertz();
  const FittedEllipse fit = fit_hertz(s, hertz.a, hertz.a);
  return {fit.p0 / hertz.p0, std::sqrt(fit.a * fit.b) / hertz.a, s.approach / hertz.approach};
}

Pressed press_on_faces(const MeshedBody& body) {
  RollingPair pair(body, RigidBody{}, 1);
  return press(pair.frame_from_body(1, 2));
}

TEST(Block, becomes_a_half_space_as_it_grows) {
  double last = 0, last_side = 0;
  for (const double side : {10.0, 20.0, 40.0}) {
    const int grade = side < 15 ? 4 : side < 30 ? 5 : 6;
    const Pressed p = press_on_faces(block({side, side / 2, zone, 10, grade, grade}, ElementType::quad4));
    const std::string name = "block of side " + std::to_string(static_cast<int>(side)) + " mm: ";
    expect_error(name + "p0", p.p0 - 1, 0.02);
    expect_error(name + "radius", p.a - 1, 0.03);
    // A point load moves the half-space below it, at the depth side/2 of the held bottom, by
    // F (1 + nu)(3 - 2 nu)/(pi E side): 1.46 a/side of Hertz's approach. The free sides give back a part of it.
    const double approach = p.approach - 1;
    expect_error(name + "approach", approach, 1.5 * example3::hertz().a / side);
    if (last != 0)
      expect_order(name + "approach against the block's size", observed_order(last, approach, side, last_side), 0.8);
    last = approach;
    last_side = side;
  }
}

TEST(Block_nightly, meets_the_half_space_as_its_mesh_is_refined) {
  double last = 0;
  for (const int n : {8, 12}) {
    const Pressed p = press_on_faces(block({40, 20, zone, n, 7, 7}, ElementType::quad4));
    const std::string name = "quad4, zone of " + std::to_string(n) + " x " + std::to_string(n);
    expect_error(name + ": p0", p.p0 - 1, 0.03 * 64 / (n * n));
    expect_error(name + ": radius", p.a - 1, 0.015 * 64 / (n * n));
    if (last != 0) expect_order(name + ": p0", observed_order(last, p.p0 - 1, 12, 8), 1.5);
    last = p.p0 - 1;
  }
  // Fewer quadratic elements do not resolve the edge of the contact (6 x 6: 4 % and 6 %).
  const Pressed p = press_on_faces(block({40, 20, zone, 8, 4, 4}, ElementType::quad8));
  expect_error("quad8, zone of 8 x 8: p0", p.p0 - 1, 0.005);
  expect_error("quad8, zone of 8 x 8: radius", p.a - 1, 0.015);
}

/// Names the frame: graded triangles of its own that match no element of the body, or the body's own faces.
enum class FrameOf { its_own, the_body };
struct Rolling {
  const char* name;
  AnyElement type;
  int deep;
  FrameOf frame;
};

class RollingBlock : public ::testing::TestWithParam<Rolling> {};

// The block is compared with the same frame on a half-space, where its integrals are exact.
TEST_P(RollingBlock, is_like_a_half_space) {
  constexpr double bound = 0.02;  // bound of forces over mu Fn; half of it for pressure and semi-axes
  const auto& [name_of_case, type, deep, frame] = GetParam();
  const bool laid = frame == FrameOf::its_own;
  const Hertz hertz = example3::hertz();
  const MeshedBody body = block({40, 20, zone, 8, 4, deep}, type);
  RollingPair on_block(body, RigidBody{}, 1), flat(example3::sphere, std::nullopt);
  if (laid)
    on_block.frame(graded_disc(hertz.a, hertz.a, 10));
  else
    on_block.frame_from_body(1, 2);
  flat.frame(laid ? graded_disc(hertz.a, hertz.a, 10) : surfaces::part_with_tag(body.mesh, 2));
  for (RollingPair* p : {&on_block, &flat})
    p->gap_quadratic(curvature, curvature).speed(example3::speed).friction(example3::mu).load(example3::load);
  for (const char* scheme : {"characteristic", "least_squares", "godunov"})
    for (const auto& creep : {std::array{-2e-3, 0.0, 0.0}, {0.0, -2e-3, 0.0}, {-1e-3, 5e-4, 1e-3}}) {
      Solution s[2];
      for (std::size_t i = 0; i < 2; ++i) {
        RollingPair& p = i == 0 ? on_block : flat;
        p.option("convection", scheme).creep(creep[0], creep[1], creep[2]);
        ASSERT_EQ(p.solve(), ROLLCON_OK);
        s[i] = p.solution();
      }
      const std::string name = std::string(name_of_case) + ", " + scheme + ", creepages " + std::to_string(creep[0]) +
                               ", " + std::to_string(creep[1]) + ", spin " + std::to_string(creep[2]) + ": ";
      for (std::size_t c = 0; c < 2; ++c)
        expect_error(name + "F" + std::to_string(c + 1) + " over mu Fn",
                     (s[0].force[c] - s[1].force[c]) / (example3::mu * example3::load), bound);
      const FittedEllipse fit = fit_hertz(s[0], hertz.a, hertz.a), reference = fit_hertz(s[1], hertz.a, hertz.a);
      expect_error(name + "p0", relative(fit.p0, reference.p0), bound / 2);
      expect_error(name + "semi-axis along", relative(fit.a, reference.a), bound / 2);
      expect_error(name + "semi-axis across", relative(fit.b, reference.b), bound / 2);
      expect_laws_kept(name, on_block, 1e-7);
    }
  EXPECT_EQ(on_block.plan().find("laid on it") != std::string::npos, laid) << on_block.plan();
}

constexpr auto rolling_name = [](const auto& param) { return std::string(param.param.name); };
INSTANTIATE_TEST_SUITE_P(Bodies, RollingBlock,
                         ::testing::Values(Rolling{"laid_on_hex20", VolumeType::hex20, 6, FrameOf::its_own}),
                         rolling_name);
INSTANTIATE_TEST_SUITE_P(Bodies_long, RollingBlock,
                         ::testing::Values(Rolling{"faces_of_quad8", ElementType::quad8, 4, FrameOf::the_body}),
                         rolling_name);
INSTANTIATE_TEST_SUITE_P(Bodies_nightly, RollingBlock,
                         ::testing::Values(Rolling{"laid_on_quad8", ElementType::quad8, 4, FrameOf::its_own}),
                         rolling_name);

constexpr double side = 30;

/// Makes a block of side 30 for finite elements near incompressibility.
MeshedBody soft_block(VolumeType type, const Elastic& material) {
  if (type == VolumeType::hex8) return block({side, side / 2, zone, 12, 5, 8}, type, material);
  return block({side, side / 2, zone, 8, 3, 4}, type, material);
}

/// Returns a material with the same E* throughout, so the same Hertz.
Elastic material(double poisson) {
  const double young = 1e4 / (1 - 0.3 * 0.3) * (1 - poisson * poisson);
  return {.shear = young / (2 * (1 + poisson)), .poisson = poisson};
}

class NearIncompressible : public ::testing::TestWithParam<VolumeType> {};

TEST_P(NearIncompressible, pressed_as_hertz_says) {
  const VolumeType type = GetParam();
  SurfaceMesh frame = surfaces::part_with_tag(soft_block(type, material(0.3)).mesh, 2);
  if (type == VolumeType::tet10) {
    const auto lines = frames::uniform_lines(-zone / 2, zone / 2, 8);
    frame = frames::rectangle(ElementType::quad4, lines, lines);
  }
  for (const double poisson : {0.3, 0.49, 0.499, 0.4999}) {
    RollingPair pair(soft_block(type, material(poisson)), RigidBody{}, 1), flat(material(poisson), std::nullopt);
    const Pressed p = press(pair.frame(frame)), half_space = press(flat.frame(frame));
    const std::string name = volumes::name_of(type) + ", nu " + std::to_string(poisson) + ": ";
    expect_error(name + "p0, Hertz", p.p0 - 1, 0.03);
    expect_error(name + "p0, half-space", p.p0 / half_space.p0 - 1, 0.025);
    expect_error(name + "a, half-space", p.a / half_space.a - 1, 0.02);
    // The held bottom takes away from the approach; the comment on it above tells how much.
    expect_error(name + "approach, half-space", p.approach / half_space.approach - 1,
                 1.5 * example3::hertz().a / side + 0.025);
  }
}

// Frames taken from tet10 have the vertices of its faces alone.
TEST(NearIncompressibleTet10, pressed_on_its_own_faces) {
  for (const double poisson : {0.3, 0.49, 0.4999}) {
    const MeshedBody body = soft_block(VolumeType::tet10, material(poisson));
    RollingPair flat(material(poisson), std::nullopt);
    const Pressed p = press_on_faces(body);
    const Pressed half_space = press(flat.frame(corner_elements(surfaces::part_with_tag(body.mesh, 2))));
    const std::string name = "tet10's own faces, nu " + std::to_string(poisson) + ": ";
    expect_error(name + "p0, half-space", p.p0 / half_space.p0 - 1, 0.01);
    expect_error(name + "a, half-space", p.a / half_space.a - 1, 0.02);
    expect_error(name + "approach, Hertz", p.approach - 1, 1.5 * example3::hertz().a / side + 0.03);
  }
}

INSTANTIATE_TEST_SUITE_P(Bodies, NearIncompressible, ::testing::Values(VolumeType::hex8),
                         [](const auto& param) { return volumes::name_of(param.param); });
INSTANTIATE_TEST_SUITE_P(Bodies_long, NearIncompressible,
                         ::testing::Values(VolumeType::hex20, VolumeType::tet10, VolumeType::wedge15),
                         [](const auto& param) { return volumes::name_of(param.param); });

}  // namespace
}  // namespace rollcon::validation
