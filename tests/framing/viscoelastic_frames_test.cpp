/// Tests frames of the library for bodies that creep: they lie where the contact has moved to.

#include <cmath>
#include <cstdio>
#include <memory>

#include "rollcon.h"
#include "support/testing.hpp"

namespace rollcon {
namespace {

/// Rolls a sphere of radius 50, E = 210, nu = 0.4, half of which relaxes in a time of 1, without friction.
struct Sphere {
  rollcon_context* context = nullptr;
  rollcon_body *body = nullptr, *plane = nullptr;
  rollcon_contact* contact = nullptr;

  Sphere() {
    const double ratio = 0.5, time = 1, frictionless = 0;
    EXPECT_EQ(rollcon_context_create(ROLLCON_ABI, &context), ROLLCON_OK);
    rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &body);
    rollcon_body_set_elastic(body, 0, 210, 0.4);
    rollcon_body_set_viscoelastic(body, 0, 1, &ratio, &time);
    rollcon_body_create(context, ROLLCON_BODY_RIGID, &plane);
    rollcon_contact_create(context, body, plane, &contact);
    rollcon_contact_set_gap_quadratic(contact, 0.01, 0.01, 0);
    rollcon_contact_set_friction(contact, "coulomb", 1, &frictionless);
    rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, 12);
  }
  Sphere(const Sphere&) = delete;
  Sphere& operator=(const Sphere&) = delete;
  ~Sphere() {
    rollcon_contact_release(contact);
    rollcon_body_release(plane);
    rollcon_body_release(body);
    rollcon_context_release(context);
  }

  struct Results {
    double approach, resistance, offset;
  };
  Results roll(double speed) {
    Results r{};
    double force[3], moment[3], creep[3];
    rollcon_contact_set_rolling(contact, speed);
    EXPECT_EQ(rollcon_contact_solve(contact), ROLLCON_OK);
    rollcon_contact_get_motion(contact, &r.approach, creep);
    rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, force, moment);
    rollcon_contact_get_stat(contact, "rolling_resistance", &r.resistance);
    r.offset = -moment[1] / force[2];
    return r;
  }
};

TEST(viscoelastic_frames, follow_the_contact_ahead) {
  Sphere follows, fine;
  rollcon_contact_frame_rectangle(fine.contact, ROLLCON_QUAD4, 160, 160, -2.4, 2.4, -2.4, 2.4);
  for (const double speed : {0.1, 1.0, 10.0, 1.0}) {
    const Sphere::Results found = follows.roll(speed), reference = fine.roll(speed);
    const double approach = found.approach / reference.approach - 1,
                 resistance = found.resistance / reference.resistance - 1, offset = found.offset / reference.offset - 1;
    std::printf("V %4.1f: pressure %.3f ahead; approach %+.1e (bound 1e-3), resistance %+.1e, offset %+.1e (1e-2)\n",
                speed, found.offset, approach, resistance, offset);
    EXPECT_GT(found.offset, 0.03);
    EXPECT_LT(std::abs(approach), 1e-3);
    EXPECT_LT(std::abs(resistance), 1e-2);
    EXPECT_LT(std::abs(offset), 1e-2);
  }
}

TEST(viscoelastic_frames, forget_the_speed_before) {
  Sphere follows, fresh;
  follows.roll(30);
  const Sphere::Results after = follows.roll(0.7), alone = fresh.roll(0.7);
  EXPECT_NEAR(after.resistance, alone.resistance, 1e-6 * alone.resistance);
  EXPECT_NEAR(after.approach, alone.approach, 1e-7 * alone.approach);
}

}  // namespace
}  // namespace rollcon
