#include <stdio.h>

#include "rollcon.h"

int main(void) {
  const double straight[2] = {10, 0}, crown[2] = {2000, 5}; /* half width, slope; radius, half width */
  const double along[3] = {0, 1, 0}, below[3] = {0, 0, -30}, above[3] = {0, 0, 6}, nowhere[3] = {0, 0, 0}, mu = 0.05;
  double pressure = 0, approach = 0, creep[3];
  rollcon_context* context;
  rollcon_body *ring = NULL, *roller = NULL;
  rollcon_contact* contact = NULL;
  int i;

  if (rollcon_context_create(ROLLCON_ABI, &context) < 0) return 1;
  rollcon_context_set_latch(context, 1); /* the first failure is kept until the check at the end */
  rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &ring);
  rollcon_body_set_elastic(ring, 0, 208000, 0.3);
  rollcon_body_set_profile_shape(ring, "line", 2, straight);
  rollcon_body_revolve_profile(ring, below, along, 30); /* its centre, its axis, its radius */
  rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &roller);
  rollcon_body_set_elastic(roller, 0, 208000, 0.3);
  rollcon_body_set_profile_shape(roller, "arc", 2, crown);
  rollcon_body_revolve_profile(roller, above, along, 6);
  rollcon_contact_create(context, ring, roller, &contact);
  rollcon_contact_set_friction(contact, "coulomb", 1, &mu);
  rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, 1500);
  printf("tilt, mrad  pressure, MPa  approach, um\n");
  for (i = 0; i <= 2; ++i) {
    const double tilt = 1e-4 * i, rotation[9] = {1, 0, 0, 0, 1, -tilt, 0, tilt, 1};
    rollcon_contact_set_pose(contact, ROLLCON_BODY2, rotation, nowhere);
    rollcon_contact_solve(contact);
    rollcon_contact_get_stat(contact, "max_pressure", &pressure);
    rollcon_contact_get_motion(contact, &approach, creep);
    printf("%10.1f %14.0f %13.2f\n", 1e3 * tilt, pressure, 1e3 * approach);
  }
  if (rollcon_context_check(context) < 0) fprintf(stderr, "%s\n", rollcon_last_error());
  rollcon_contact_release(contact);
  rollcon_body_release(roller);
  rollcon_body_release(ring);
  rollcon_context_release(context);
  return 0;
}
