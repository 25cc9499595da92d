/// Tests friction by the inclination of the rail: one coefficient changes nothing, patches have those of their surface,
/// and left wheels those of their mirror image.

#include <array>
#include <cmath>
#include <cstdio>

#include "wheelrail/wheel_rail_fixture.hpp"

namespace rollcon {
namespace {

using friction_by_angle = wheels;

TEST_F(friction_by_angle, one_coefficient_is_as_before) {
  const double level[] = {-1.5, mu, 1.5, mu};
  for (const double y : {0.0, 2.0, 6.0}) {
    const auto plain = make(), varied = make();
    varied->set_friction(0.9);
    varied->set_friction("by_angle", 4, level);
    for (const auto* w : {&plain, &varied}) {
      (*w)->prescribe_vertical(2, 10000);
      place(**w, y);
      ASSERT_GE((*w)->solve(), Status::ok);
    }
    std::array<double, 3> force[2], moment[2];
    plain->resultant(true, force[0].data(), moment[0].data());
    varied->resultant(true, force[1].data(), moment[1].data());
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(force[1][c], force[0][c], 1e-9 * 10000);
    varied->set_friction(mu);
    ASSERT_GE(varied->solve(), Status::ok);
    varied->resultant(true, force[1].data(), moment[1].data());
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(force[1][c], force[0][c], 1e-7 * 10000);
  }
}

// The force of a sliding patch is its coefficient times its load: dry on the head, lubricated on the gauge face.
TEST_F(friction_by_angle, each_patch_has_that_of_its_surface) {
  const double by_angle[] = {-1.1, 0.1, -0.9, 0.4};
  int seen = 0;
  for (const std::int32_t side : {1, -1})
    for (const double y : {0.0, 4.0, 6.5, 7.0}) {
      const auto w = make(side);
      w->set_friction("by_angle", 4, by_angle);
      w->prescribe_vertical(2, 10000);
      const double position[6] = {0, side * y, 0, 0, side * 2.4e-3 * y, 0}, fast[6] = {2000, 0, 0, 0, 0, -8};
      w->set_position(position);
      w->set_velocity(fast);
      if (w->solve() < Status::ok) continue;
      for (std::int64_t i = 0; i < w->patches(); ++i) {
        const double inclination = w->patch_stat(i, "angle") * side;
        const double found = std::hypot(w->patch_stat(i, "longitudinal_force"), w->patch_stat(i, "lateral_force")) /
                             std::abs(w->patch_stat(i, "normal_force"));
        const double wanted = inclination < -1.1   ? 0.1
                              : inclination > -0.9 ? 0.4
                                                   : 0.4 + 0.3 * (inclination + 0.9) / 0.2;
        std::printf("side %d, y %.1f, patch at %.3f rad: tangential over normal force %.4f, of its inclination %.4f\n",
                    side, y, inclination, found, wanted);
        EXPECT_NEAR(found, wanted, 0.01 * wanted);
        ++seen;
      }
    }
  EXPECT_GE(seen, 8);
}

TEST_F(friction_by_angle, refusals) {
  const auto w = make();
  const double falling[] = {0.1, 0.1, 0, 0.2}, much[] = {0, 0.1, 0.1, 11};
  refused([&] { w->set_friction("by_angle", 4, falling); }, Status::err_argument, {"angle of point 1"});
  refused([&] { w->set_friction("by_angle", 4, much); }, Status::err_argument, {"point 1 (counting from 0): mu"});
  refused([&] { w->set_friction("by_angle", 4, nullptr); }, Status::err_argument, {"parameters"});
}

}  // namespace
}  // namespace rollcon
