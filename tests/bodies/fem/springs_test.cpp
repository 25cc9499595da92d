// Tests elastic supports of finite elements.

#include "support/static_solution.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

// A block, nu = 0, stands on springs under a pressure: u = p / k + p d / E at its top.
TEST(Springs, carry_a_block) {
  for (const VolumeType type : {VolumeType::hex8, VolumeType::hex20, VolumeType::tet10, VolumeType::wedge15}) {
    statics::StaticBody body(surfaces::brick({2, 2, 2}, {1, 1, 2}), type, 1000, 0);
    const double stiffness[] = {3, 3, 40};
    body.body().set_springs(5, stiffness);
    body.pressure(6, 7).solve();
    for (const Vec3& x : {Vec3{1, 1, 2}, Vec3{0, 0.5, 2}})
      expect_error(volumes::name_of(type) + ": top", body.displacement(x)[2] / (-7.0 / 40 - 7 * 2 / 1000.0) - 1, 1e-10);
    expect_error(volumes::name_of(type) + ": bottom", body.displacement(Vec3{1, 0, 0})[2] / (-7.0 / 40) - 1, 1e-10);
  }
}

TEST(Springs, do_not_hold_what_they_leave_free) {
  statics::StaticBody body(surfaces::brick({1, 1, 1}, {1, 1, 1}), VolumeType::hex8, 1000, 0.3);
  const double stiffness[] = {0, 0, 40}, down[] = {0, 0, -1};
  body.body().set_springs(5, stiffness);
  EXPECT_THROW(body.solve(), Error);
  EXPECT_THROW(body.body().set_springs(5, down), Error);
  EXPECT_THROW(body.body().set_springs(77, stiffness), Error);
}

}  // namespace
}  // namespace rollcon
