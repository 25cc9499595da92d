// Tests contact over the full width of a body: where the body ends, a frame laid on it has no rim.

#include "support/frames.hpp"
#include "support/scene.hpp"
#include "support/testing.hpp"
#include "support/volume_meshes.hpp"

namespace rollcon {
namespace {

constexpr double side = 2, height = 1;

scenes::MeshedBody block(std::int32_t held, VolumeType type = VolumeType::hex8) {
  scenes::MeshedBody body = scenes::meshed(volumes::block(surfaces::brick({3, 3, 2}, {side, side, height}), type),
                                           {.shear = 1e3, .poisson = 0.3});
  body.held_tag = {held};
  return body;
}

/// Returns linear quadrilaterals from `margin` to side - margin in both directions.
SurfaceMesh laid(double margin, double z) {
  const auto lines = frames::uniform_lines(margin, side - margin, 5);
  return surfaces::transform(frames::rectangle(ElementType::quad4, lines, lines), [z](const Vec3& x) {
    return Vec3{x[0], x[1], z};
  });
}

std::int32_t press(scenes::RollingPair& pair, double z) {
  pair.axes({side / 2, side / 2, z}, {1, 0, 0}, {0, 0, 1}).friction(0).approach(1e-3);
  const std::int32_t status = pair.solve();
  std::printf("status %d, %g nodes in contact, %g on a rim\n", status, pair.stat("nodes_contact"),
              pair.stat("nodes_rim"));
  return status;
}

class RimAtEdges : public testing::Test {
  void SetUp() override {
    if (!rollcon_has_feature("fem")) GTEST_SKIP() << "this build has no finite elements";
  }
};

TEST_F(RimAtEdges, the_edge_of_body_1_is_none) {
  scenes::RollingPair pair(block(5), scenes::RigidBody{}, 1);
  pair.frame(laid(0, height));
  EXPECT_EQ(press(pair, height), ROLLCON_OK);
  EXPECT_EQ(pair.stat("nodes_contact"), 36);
  EXPECT_EQ(pair.stat("nodes_rim"), 0);
}

TEST_F(RimAtEdges, the_edge_of_body_2_is_none) {
  scenes::RollingPair pair(scenes::RigidBody{}, block(6), 1);
  pair.frame(laid(0, 0));
  EXPECT_EQ(press(pair, 0), ROLLCON_OK);
  EXPECT_EQ(pair.stat("nodes_rim"), 0);
}

// Nothing is measured if the gap is given, and the edges are looked for in the mesh.
TEST_F(RimAtEdges, a_gap_given_node_by_node_changes_nothing) {
  for (const VolumeType type : {VolumeType::hex8, VolumeType::hex20})
    for (const double margin : {0.0, 0.05}) {
      scenes::RollingPair pair(block(5, type), scenes::RigidBody{}, 1);
      pair.frame(laid(margin, height)).gap(std::vector<double>(36, 0.0));
      EXPECT_EQ(press(pair, height), margin == 0 ? ROLLCON_OK : ROLLCON_RIM_CONTACT);
      EXPECT_EQ(pair.stat("nodes_rim"), margin == 0 ? 0 : 20);
    }
}

TEST_F(RimAtEdges, a_frame_that_ends_before_the_edge_has_one) {
  scenes::RollingPair pair(block(5), scenes::RigidBody{}, 1);
  pair.frame(laid(0.05, height));
  EXPECT_EQ(press(pair, height), ROLLCON_RIM_CONTACT);
  EXPECT_EQ(pair.stat("nodes_rim"), 20);
}

TEST_F(RimAtEdges, one_that_ends_within_the_body_keeps_its_other_rims) {
  scenes::RollingPair pair(block(5), scenes::RigidBody{}, 1);
  const auto lines = frames::uniform_lines(0, side, 5);
  const auto half = frames::uniform_lines(0, side / 2, 5);
  pair.frame(surfaces::transform(frames::rectangle(ElementType::quad4, half, lines), [](const Vec3& x) {
    return Vec3{x[0], x[1], height};
  }));
  EXPECT_EQ(press(pair, height), ROLLCON_RIM_CONTACT);
  EXPECT_EQ(pair.stat("nodes_rim"), 6);  // its last line, at whose ends the contact is cut off, too
}

// The edge of a rigid surface moves along; the frame is not made anew.
TEST_F(RimAtEdges, follows_a_rigid_body_that_moves) {
  scenes::MeshedBody plate;
  plate.mesh = surfaces::block(surfaces::brick({2, 2, 1}, {side, side, height}), ElementType::quad4);
  scenes::RollingPair pair(block(5), plate, 1);
  pair.frame(laid(0.1, height));
  const std::array<Vec3, 3> same{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  pair.pose(2, same, {0.1, 0, height});
  EXPECT_EQ(press(pair, height), ROLLCON_RIM_CONTACT);
  EXPECT_EQ(pair.stat("nodes_rim"), 16);  // the plate ends over the first line of six, except at its corners
  pair.pose(2, same, {0, 0, height});
  EXPECT_EQ(press(pair, height), ROLLCON_RIM_CONTACT);
  EXPECT_EQ(pair.stat("nodes_rim"), 20);
}

}  // namespace
}  // namespace rollcon
