/// Tests poses of bodies, and frames made of their faces.

#include "body_fixture.hpp"

using namespace capi_test;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double identity[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, zero[3] = {0, 0, 0};

}  // namespace

class pose : public BodyApi {
 protected:
  void SetUp() override {
    BodyApi::SetUp();
    if (IsSkipped()) return;
    set_mesh(body);
    ASSERT_OK(rollcon_contact_create(context, plane, body, &pair));
  }

  void TearDown() override {
    rollcon_contact_release(pair);
    BodyApi::TearDown();
  }

  void expect_frame(std::int64_t nodes, std::int64_t elements) {
    std::int64_t n = -1, m = -1;
    ASSERT_OK(rollcon_contact_get_size(pair, &n, &m));
    EXPECT_EQ(n, nodes);
    EXPECT_EQ(m, elements);
  }

  rollcon_contact* pair = nullptr;
};

TEST_F(pose, arguments) {
  for (const std::int32_t which : {0, 3, -1})
    EXPECT_FAILS(rollcon_contact_set_pose(pair, which, identity, zero), ARGUMENT, "which is", "1, 2");
  EXPECT_FAILS(rollcon_contact_set_pose(pair, 1, nullptr, zero), ARGUMENT, "rotation is NULL");
  EXPECT_FAILS(rollcon_contact_set_pose(pair, 1, identity, nullptr), ARGUMENT, "translation is NULL");
  const double nowhere[3] = {0, not_a_number, 0};
  double bad[9] = {1, 0, 0, 0, 1, 0, 0, not_a_number, 1};
  EXPECT_FAILS(rollcon_contact_set_pose(pair, 1, bad, zero), NONFINITE, "rotation");
  EXPECT_FAILS(rollcon_contact_set_pose(pair, 1, identity, nowhere), NONFINITE, "component y of translation");
}

TEST_F(pose, rotations_only) {
  const double mirrored[9] = {1, 0, 0, 0, 1, 0, 0, 0, -1}, larger[9] = {2, 0, 0, 0, 2, 0, 0, 0, 2},
               sheared[9] = {1, 2e-6, 0, 0, 1, 0, 0, 0, 1}, nothing[9] = {};
  EXPECT_FAILS(rollcon_contact_set_pose(pair, 2, mirrored, zero), ARGUMENT, "determinant");
  for (const double* r : {larger, sheared, nothing})
    EXPECT_FAILS(rollcon_contact_set_pose(pair, 2, r, zero), ARGUMENT, "orthonormal");
  const double rounded[9] = {1, 4e-7, 0, -4e-7, 1, 0, 0, 0, 1 + 4e-7};
  EXPECT_OK(rollcon_contact_set_pose(pair, 2, rounded, zero));
  EXPECT_OK(rollcon_contact_set_pose(pair, 2, identity, zero));
}

TEST_F(pose, frames_from_bodies_are_their_tagged_faces) {
  for (const std::int32_t which : {0, 3, -7})
    EXPECT_FAILS(rollcon_contact_frame_from_body(pair, which, 6), ARGUMENT, "which is", "1, 2");
  EXPECT_FAILS(rollcon_contact_frame_from_body(pair, 2, 9), ARGUMENT, "tag is 9");
  EXPECT_FAILS(rollcon_contact_frame_from_body(pair, 1, 6), STATE);
  expect_frame(0, 0);
  ASSERT_OK(rollcon_contact_frame_from_body(pair, 2, 6));
  expect_frame(9, 4);
  EXPECT_FAILS(rollcon_contact_frame_from_body(pair, 2, 9), ARGUMENT, "tag is 9");
  expect_frame(9, 4);
  const double other[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  ASSERT_OK(rollcon_body_set_nodes(body, 3, other, 3, 1));
  expect_frame(9, 4);
  ASSERT_OK(rollcon_contact_frame_nodes(pair, 3, other, 3, 1));
  expect_frame(3, 0);
}

// The cube's upper face rolls on a plane; where the plane is said to be under the cube, somebody forgot to move one of
// them.
TEST_F(pose, forgotten_ones_are_told) {
  ASSERT_OK(hold_bottom(ROLLCON_DOF_XYZ));
  rollcon_contact* on_plane = nullptr;
  ASSERT_OK(rollcon_contact_create(context, body, plane, &on_plane));
  const double rolling[3] = {1, 0, 0}, up[3] = {0, 0, 1}, mu = 0.1;
  ASSERT_OK(rollcon_contact_frame_from_body(on_plane, 1, 6));
  ASSERT_OK(rollcon_contact_set_friction(on_plane, "coulomb", 1, &mu));
  ASSERT_OK(rollcon_contact_set_rolling(on_plane, 1));
  ASSERT_OK(rollcon_contact_prescribe(on_plane, ROLLCON_NORMAL, ROLLCON_BY_FORCE, 1));
  const double below[3] = {0.5, 0.5, -0.5}, there[3] = {0.5, 0.5, 1};
  ASSERT_OK(rollcon_contact_set_axes(on_plane, below, rolling, up));
  EXPECT_FAILS(rollcon_contact_solve(on_plane), ARGUMENT, "overlap by 1.5", "body 1 is thick (1)", "set_pose");
  ASSERT_OK(rollcon_contact_set_axes(on_plane, there, rolling, up));
  EXPECT_GE(rollcon_contact_solve(on_plane), ROLLCON_OK);
  rollcon_contact_release(on_plane);
}

TEST_F(pose, half_spaces_have_no_faces) {
  EXPECT_FAILS(rollcon_contact_frame_from_body(contact, 1, 0), STATE);
}
