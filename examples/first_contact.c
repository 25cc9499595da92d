/* A steel wheel of radius 460 rolls on a rail head of radius 300. Units: mm, N, s; so MPa. */
#include <stdio.h>
#include <stdlib.h>

#include "rollcon.h"

static void check(int32_t status) { /* below 0: the call failed; above 0: results with a caveat */
  if (status == ROLLCON_OK) return;
  fprintf(stderr, "%s\n", status < 0 ? rollcon_last_error() : rollcon_last_caveat());
  if (status < 0) exit(1);
}

int main(void) {
  const double friction = 0.3;
  double force[3], moment[3], pressure, approach, creep[3];
  rollcon_context* context;
  rollcon_body *wheel, *rail;
  rollcon_contact* contact;

  check(rollcon_context_create(ROLLCON_ABI, &context));
  check(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &wheel));
  check(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &rail));
  check(rollcon_body_set_elastic(wheel, 0, 210000, 0.28)); /* Young's modulus, Poisson's ratio */
  check(rollcon_body_set_elastic(rail, 0, 210000, 0.28));
  check(rollcon_contact_create(context, wheel, rail, &contact));
  /* The gap between the bodies: x^2 / (2 * 460) + y^2 / (2 * 300), no term in x y. */
  check(rollcon_contact_set_gap_quadratic(contact, 1 / 920.0, 1 / 600.0, 0));
  check(rollcon_contact_set_friction(contact, "coulomb", 1, &friction));
  check(rollcon_contact_set_rolling(contact, 20000));      /* speed */
  check(rollcon_contact_set_creep(contact, -0.001, 0, 0)); /* longitudinal, lateral, spin: it drives */
  check(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, 80000));
  check(rollcon_contact_solve(contact));
  check(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, force, moment));
  check(rollcon_contact_get_motion(contact, &approach, creep));
  check(rollcon_contact_get_stat(contact, "max_pressure", &pressure));
  printf("driving force %.0f N, largest pressure %.0f MPa, approach %.4f mm\n", force[0], pressure, approach);

  rollcon_contact_release(contact);
  rollcon_body_release(rail);
  rollcon_body_release(wheel);
  rollcon_context_release(context);
  return 0;
}
