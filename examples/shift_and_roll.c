/* Two equal spheres are shifted against each other by a force, and then roll under it (Kalker's transient, from
   Cattaneo's tractions to those of steady rolling): the creepage begins at half of what it becomes. It goes step by
step, like a vehicle code; the state in the middle is saved and gone back to. shift_and_roll.py and _77.f print the
same. docs/time.md. */
#include <stdio.h>
#include <stdlib.h>

#include "rollcon.h"

static const double shear = 1, poisson = 0.28, curvature = 0.002963, load = 0.4705, mu = 0.4013;

static int32_t must(int32_t status) {
  if (status >= 0) return status;
  fprintf(stderr, "%s: %s\n", rollcon_status_string(status), rollcon_last_error());
  exit(1);
}

/* Solves a step and prints what moved. */
static void step(rollcon_contact* contact, const char* name, double rolled) {
  double motion[3], slipping = 0;
  const int status = must(rollcon_contact_solve(contact));
  must(rollcon_contact_get_motion(contact, NULL, motion));
  must(rollcon_contact_get_stat(contact, "nodes_slip", &slipping));
  printf("%-8s%4d%9.2f%13.5E%6d\n", name, status, rolled, motion[0], (int)slipping);
}

int main(void) {
  rollcon_context* context;
  rollcon_body* sphere;
  rollcon_contact* contact;
  double* past;
  int64_t n = 0;
  int k;
  must(rollcon_context_create(ROLLCON_ABI, &context));
  must(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &sphere));
  must(rollcon_body_set_elastic(sphere, 0, 2 * shear * (1 + poisson), poisson));
  must(rollcon_contact_create(context, sphere, sphere, &contact));
  must(rollcon_contact_frame_rectangle(contact, ROLLCON_QUAD4, 30, 30, -4.2, 4.2, -4.2, 4.2));
  must(rollcon_contact_set_gap_quadratic(contact, curvature, curvature, 0));
  must(rollcon_contact_set_friction(contact, "coulomb", 1, &mu));
  must(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, load));
  must(rollcon_contact_prescribe(contact, ROLLCON_LONGITUDINAL, ROLLCON_BY_FORCE, -0.657 * mu * load));

  /* The bodies are shifted by a distance. */
  must(rollcon_contact_set_step(contact, ROLLCON_SHIFT_STEP, 1));
  step(contact, "shift", 0);

  /* The bodies roll with a creepage. */
  must(rollcon_contact_set_rolling(contact, 1));
  must(rollcon_contact_set_step(contact, ROLLCON_ROLLING_STEP, 0.25));
  for (k = 1; k <= 8; ++k) step(contact, "roll", 0.25 * k);

  must(rollcon_contact_past_get(contact, 0, NULL, &n));
  past = malloc((size_t)n * sizeof *past);
  if (!past) return 1;
  must(rollcon_contact_past_get(contact, n, past, NULL));
  for (k = 9; k <= 40; ++k) {
    if (k % 8 == 0)
      step(contact, "roll", 0.25 * k);
    else
      must(rollcon_contact_solve(contact));
  }
  must(rollcon_contact_past_set(contact, n, past));
  step(contact, "again", 2.25);

  free(past);
  rollcon_contact_release(contact);
  rollcon_body_release(sphere);
  rollcon_context_release(context);
  return 0;
}
