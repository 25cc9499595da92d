#include <math.h>
#include <stdio.h>

#include "rollcon.h"

static rollcon_body* steel(rollcon_context* context, const char* profile) {
  const double millimetre = 1;
  rollcon_body* body = NULL;
  rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &body);
  rollcon_body_set_elastic(body, 0, 210000, 0.28);
  rollcon_body_set_profile_shape(body, profile, 1, &millimetre);
  return body;
}

int main(void) {
  double position[6] = {0, 0, 0, 0, 0, 0};                        /* x, y, z, roll, yaw, pitch */
  const double velocity[6] = {20000, 0, 0, 0, 0, -20000 / 460.0}; /* 20 m/s; it turns forwards */
  const double mu = 0.3;
  double force[3] = {0, 0, 0}, moment[3];
  int64_t patches = 0;
  rollcon_context* context;
  rollcon_body *tread, *rail;
  rollcon_wheelrail* wheel = NULL;

  if (rollcon_context_create(ROLLCON_ABI, &context) < 0) return 1;
  rollcon_context_set_latch(context, 1); /* the first failure is kept until the check at the end */
  tread = steel(context, "s1002");
  rail = steel(context, "60e1");
  rollcon_wheelrail_create(context, tread, rail, ROLLCON_RIGHT, &wheel);
  rollcon_wheelrail_set_track(wheel, 1435, 14, atan(1.0 / 40)); /* gauge, 14 below the top; cant */
  rollcon_wheelrail_set_wheelset(wheel, 1360, -70, 460);        /* flange backs, their y, radius */
  rollcon_wheelrail_set_friction(wheel, "coulomb", 1, &mu);
  rollcon_wheelrail_prescribe_vertical(wheel, ROLLCON_BY_FORCE, 80000);
  rollcon_wheelrail_set_velocity(wheel, velocity);
  printf("   y  patches   Fx, kN   Fy, kN   Fz, kN\n");
  for (position[1] = 0; position[1] <= 6; position[1] += 2) {
    rollcon_wheelrail_set_position(wheel, position);
    rollcon_wheelrail_solve(wheel);
    rollcon_wheelrail_get_resultant(wheel, ROLLCON_IN_TRACK, force, moment);
    rollcon_wheelrail_get_patch_count(wheel, &patches);
    printf("%4.0f %8d %8.2f %8.2f %8.2f\n", position[1], (int)patches, force[0] / 1e3, force[1] / 1e3, force[2] / 1e3);
  }
  if (rollcon_context_check(context) < 0) fprintf(stderr, "%s\n", rollcon_last_error());
  rollcon_wheelrail_release(wheel);
  rollcon_body_release(rail);
  rollcon_body_release(tread);
  rollcon_context_release(context);
  return 0;
}
