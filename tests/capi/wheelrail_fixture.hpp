#pragma once
/// Puts a wheel on its rail through the public interface.

#include "fixture.hpp"

namespace capi_test {

/// Holds wheel S1002 and rail 60E1 of the benchmark, case; mm, N, s.
class Wheel : public ::testing::Test {
 protected:
  void SetUp() override {
    const double unit = 1;
    ASSERT_OK(rollcon_context_create(ROLLCON_ABI, &context));
    for (rollcon_body** body : {&wheel, &rail}) {
      ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, body));
      ASSERT_OK(rollcon_body_set_elastic(*body, 0, 2 * 82000 * 1.28, 0.28));
    }
    ASSERT_OK(rollcon_body_set_profile_shape(wheel, "s1002", 1, &unit));
    ASSERT_OK(rollcon_body_set_profile_shape(rail, "60e1", 1, &unit));
    right = made(ROLLCON_RIGHT);
  }

  void TearDown() override {
    rollcon_wheelrail_release(right);
    rollcon_body_release(rail);
    rollcon_body_release(wheel);
    rollcon_context_release(context);
  }

  rollcon_wheelrail* made(std::int32_t side) {
    rollcon_wheelrail* w = nullptr;
    EXPECT_OK(rollcon_wheelrail_create(context, wheel, rail, side, &w));
    return w;
  }

  /// Gives the row y = 2 mm; a left wheel gets its mirror image.
  static void give(rollcon_wheelrail* w, double side = 1) {
    const double position[6] = {0, side * 2, 0.1529, side * -1.128e-4, side * 4.8e-3, 0};
    const double velocity[6] = {2000, 0, 0, 0, 0, -4.3459197};
    ASSERT_OK(rollcon_wheelrail_set_track(w, 1435, 14, std::atan(1.0 / 40)));
    ASSERT_OK(rollcon_wheelrail_set_wheelset(w, 1360, -70, 460));
    ASSERT_OK(rollcon_wheelrail_set_position(w, position));
    ASSERT_OK(rollcon_wheelrail_set_velocity(w, velocity));
    const double mu = 0.3;
    ASSERT_OK(rollcon_wheelrail_set_friction(w, "coulomb", 1, &mu));
  }

  static double patch_stat(const rollcon_wheelrail* w, const char* name) {
    double value = NAN;
    EXPECT_OK(rollcon_wheelrail_get_patch_stat(w, 0, name, &value));
    return value;
  }

  static double stat(const rollcon_wheelrail* w, const char* name) {
    double value = NAN;
    EXPECT_OK(rollcon_wheelrail_get_stat(w, name, &value));
    return value;
  }

  static std::int64_t patches(const rollcon_wheelrail* w) {
    std::int64_t n = -1;
    EXPECT_OK(rollcon_wheelrail_get_patch_count(w, &n));
    return n;
  }

  static void expect_error(const char* what, double error, double bound) {
    std::printf("%s: %.3g (bound %.3g)\n", what, error, bound);
    EXPECT_LE(std::abs(error), bound) << what;
  }

  rollcon_context* context = nullptr;
  rollcon_body *wheel = nullptr, *rail = nullptr;
  rollcon_wheelrail* right = nullptr;
};

}  // namespace capi_test
