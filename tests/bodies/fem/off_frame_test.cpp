// Tests displacements off a frame that is made of the body's own faces: they go down like those of a half-space, and
// agree with those under a frame that reaches as far.

#include "support/frames.hpp"
#include "support/scene.hpp"
#include "support/testing.hpp"
#include "support/volume_meshes.hpp"

namespace rollcon {
namespace {

using frames::uniform_lines;
using scenes::RollingPair;

const closed_forms::Elastic material{.shear = 1, .poisson = 0.3};
constexpr double width = 0.5, rim = width / 2;
/// The points lie on the rim, then one and two of the frame's widths away from it, straight and along a diagonal.
const std::vector<double> points{rim, 0, rim + width, 0, rim + 2 * width, 0, 0, rim + width, rim + 0.35, rim + 0.35};

/// Returns displacements of body `which` at the points under a rigid ball without friction.
std::vector<double> pressed(RollingPair& pair, int which) {
  pair.axes({0, 0, 0}, {1, 0, 0}, {0, 0, 1}).gap_quadratic(0.1, 0.1).friction(0);
  pair.approach(0.005).solve();
  return pair.displacements_at(which, points);
}

struct Case {
  VolumeType type;
  int body;  ///< 1 or 2
};

class OffFrame : public ::testing::TestWithParam<Case> {};

// The block is 40 times as wide as its frame.
TEST_P(OffFrame, a_large_block_moves_like_a_half_space) {
  const auto [type, which] = GetParam();
  scenes::MeshedBody block = scenes::meshed(volumes::zone_block({20, 10, width, 6, 5, 6}, type), material);
  block.held_tag = {3};
  block.contact_tag = {2};
  const scenes::AnyBody elastic = block, rigid = scenes::RigidBody{};
  RollingPair pair(which == 1 ? elastic : rigid, which == 1 ? rigid : elastic, 1);
  // The axes' normal looks out of body 1 into body 2.
  if (which == 2) pair.pose(2, {{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}}, {0, 0, 0});
  pair.frame_from_body(which, 2);
  RollingPair flat(which == 1 ? std::optional(material) : std::nullopt,
                   which == 1 ? std::nullopt : std::optional(material), 1);
  flat.frame(frames::rectangle(ElementType::quad4, uniform_lines(-rim, rim, 6), uniform_lines(-rim, rim, 6)));
  const std::vector<double> u = pressed(pair, which), reference = pressed(flat, which);
  const std::vector<std::string> place{"on the rim", "one width away", "two widths away", "one width aside",
                                       "on the diagonal"};
  const double on_rim = std::abs(reference[2]);
  ASSERT_LT(std::abs(reference[8]), 0.25 * on_rim) << "two widths away nearly nothing is left";
  // Coarse faces around the frame and far supports add a nearly constant part.
  for (std::size_t k = 0; k < place.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c)
      expect_error(place[k] + ", u" + std::to_string(c + 1) + " over the rim's normal one",
                   (u[3 * k + c] - reference[3 * k + c]) / on_rim, 0.12);
}

INSTANTIATE_TEST_SUITE_P(Types, OffFrame, ::testing::Values(Case{VolumeType::hex8, 1}), [](const auto& param) {
  return volumes::name_of(param.param.type) + "_body_" + std::to_string(param.param.body);
});
INSTANTIATE_TEST_SUITE_P(Types_long, OffFrame, ::testing::Values(Case{VolumeType::hex8, 2}, Case{VolumeType::hex20, 1}),
                         [](const auto& param) {
                           return volumes::name_of(param.param.type) + "_body_" + std::to_string(param.param.body);
                         });

// The block is so small that its supports and sides are felt.
TEST(OffFrameOfSmallBlock_long, a_larger_frame_shows_the_same) {
  std::vector<double> u[2];
  for (const int larger : {0, 1}) {
    surfaces::Block shape;
    shape.line = {uniform_lines(-2, 2, 32), uniform_lines(-2, 2, 32), uniform_lines(-2, 0, 8)};
    const int half = larger ? 12 : 2;
    shape.zone_from = {16 - half, 16 - half};
    shape.zone_to = {16 + half, 16 + half};
    shape.zone_tag = 9;
    scenes::MeshedBody body = scenes::meshed(volumes::block(shape, VolumeType::hex8), material);
    body.held_tag = {5};
    body.contact_tag = {9};
    RollingPair pair(body, scenes::RigidBody{}, 1);
    pair.frame_from_body(1, 9);
    u[larger] = pressed(pair, 1);
  }
  for (std::size_t k = 0; k < points.size() / 2; ++k)
    expect_error("point " + std::to_string(k) + ", error over the rim's displacement",
                 (u[0][3 * k + 2] - u[1][3 * k + 2]) / u[1][2], 0.1);
}

}  // namespace
}  // namespace rollcon
