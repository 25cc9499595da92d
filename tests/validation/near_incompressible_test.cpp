// A finite-element block under a rigid sphere as nu tends to 1/2: pressure, radius and approach of Hertz and of a
// half-space on the same frame; no locking.

#include <string>
#include <vector>

#include "mesh/corner_elements.hpp"
#include "support/example3.hpp"
#include "support/frames.hpp"
#include "support/hertz_fit.hpp"
#include "validation/report.hpp"

namespace rollcon::validation {
namespace {

namespace example3 = scenes::example3;

constexpr double zone = 2.5, side = 30, load = 298.6;

/// Zone of n x n elements.
volumes::Mesh block(VolumeType type) {
  if (type == VolumeType::hex8) return volumes::zone_block({side, side / 2, zone, 12, 5, 8}, type);
  return volumes::zone_block({side, side / 2, zone, 8, 3, 4}, type);
}

/// What a sphere's pressure says, relative to Hertz.
struct Pressed {
  double p0 = 0, a = 0, approach = 0;
};

Pressed press(scenes::RollingPair& pair) {
  const double curvature = 1 / (2 * example3::radius);
  pair.gap_quadratic(curvature, curvature).friction(0).load(load);
  EXPECT_EQ(pair.solve(), ROLLCON_OK);
  const scenes::Solution s = pair.solution();
  const closed_forms::Hertz hertz = example3::hertz();
  const scenes::FittedEllipse fit = scenes::fit_hertz(s, hertz.a, hertz.a);
  return {fit.p0 / hertz.p0, std::sqrt(fit.a * fit.b) / hertz.a, s.approach / hertz.approach};
}

scenes::MeshedBody held_block(const volumes::Mesh& mesh, const closed_forms::Elastic& material) {
  scenes::MeshedBody body = scenes::meshed(mesh, material);
  body.held_tag = {3};
  body.contact_tag = {2};
  return body;
}

/// The same E* throughout: the same Hertz.
closed_forms::Elastic material(double poisson) {
  const double young = 1e4 / (1 - 0.3 * 0.3) * (1 - poisson * poisson);
  return {.shear = young / (2 * (1 + poisson)), .poisson = poisson};
}

class NearIncompressible : public ::testing::TestWithParam<VolumeType> {};

TEST_P(NearIncompressible, pressed_as_hertz_says) {
  const VolumeType type = GetParam();
  const volumes::Mesh mesh = block(type);
  std::vector<std::int32_t> unused;
  SurfaceMesh frame = surfaces::part_of(mesh.surface, surfaces::elements_with_tag(mesh.surface, 2), unused);
  if (type == VolumeType::tet10) {
    const auto lines = frames::uniform_lines(-zone / 2, zone / 2, 8);
    frame = frames::rectangle(ElementType::quad4, lines, lines);
  }
  for (const double poisson : {0.3, 0.49, 0.499, 0.4999}) {
    scenes::RollingPair pair(held_block(mesh, material(poisson)), scenes::RigidBody{}, 1);
    scenes::RollingPair flat(material(poisson), std::nullopt);
    const Pressed p = press(pair.frame(frame)), half_space = press(flat.frame(frame));
    const std::string name = volumes::name_of(type) + ", nu " + std::to_string(poisson) + ": ";
    expect_error(name + "p0, Hertz", p.p0 - 1, 0.03);
    expect_error(name + "p0, half-space", p.p0 / half_space.p0 - 1, 0.025);
    expect_error(name + "a, half-space", p.a / half_space.a - 1, 0.02);
    // A held bottom at the depth side/2 takes away from the approach (block_test.cpp).
    expect_error(name + "approach, half-space", p.approach / half_space.approach - 1,
                 1.5 * example3::hertz().a / side + 0.025);
  }
}

// Frames taken from tet10 have the vertices of its faces alone.
TEST(NearIncompressibleTet10, pressed_on_its_own_faces) {
  const volumes::Mesh mesh = block(VolumeType::tet10);
  std::vector<std::int32_t> unused;
  const SurfaceMesh own = surfaces::part_of(mesh.surface, surfaces::elements_with_tag(mesh.surface, 2), unused);
  for (const double poisson : {0.3, 0.49, 0.4999}) {
    scenes::RollingPair pair(held_block(mesh, material(poisson)), scenes::RigidBody{}, 1);
    scenes::RollingPair flat(material(poisson), std::nullopt);
    const Pressed p = press(pair.frame_from_body(1, 2));
    const Pressed half_space = press(flat.frame(corner_elements(own)));
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
