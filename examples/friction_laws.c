/* Two steel spheres roll on each other under three laws of friction: force over creepage, the lateral force of
   orthotropic friction, and the two creepages that belong to one force where friction falls with the slip.
   Units: mm, N, MPa, s. Formulas: docs/friction.md. */
#include <rollcon.h>
#include <stdio.h>
#include <stdlib.h>

static void must(rollcon_status status) {
  if (status < 0) {
    fprintf(stderr, "%s\n", rollcon_last_error());
    exit(1);
  }
}

static void solve_at(rollcon_contact* contact, double creepage, double force[3]) {
  must(rollcon_contact_set_creep(contact, creepage, 0, 0));
  must(rollcon_contact_solve(contact));
  must(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, force, NULL));
}

/* Returns the creepage that a solve finds for a given longitudinal force. */
static double creepage_of(rollcon_contact* contact, double force) {
  double creep[3];
  must(rollcon_contact_prescribe(contact, ROLLCON_LONGITUDINAL, ROLLCON_BY_FORCE, force));
  must(rollcon_contact_solve(contact));
  must(rollcon_contact_get_motion(contact, NULL, creep));
  return creep[0];
}

int main(void) {
  const double load = 100000, speed = 10000;
  static const double coulomb[] = {0.3};
  static const double falling[] = {0.15, 0.15, 150};             /* muk, mu1, s1: 0.3 at rest, 0.225 at 150 mm/s */
  static const double orthotropic[] = {0.3, 0.15, 0.7853981634}; /* mu1, mu2, angle of 45 degrees */
  const char* const name[] = {"coulomb", "exponential", "orthotropic"};
  static const double* const parameters[] = {coulomb, falling, orthotropic};
  const int32_t count[] = {1, 3, 3};
  rollcon_context* context;
  rollcon_body* body;
  rollcon_contact* contact;
  double force[3], steep = 0;
  int i, law;

  must(rollcon_context_create(ROLLCON_ABI, &context));
  must(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &body));
  must(rollcon_body_set_elastic(body, 0, 210000, 0.28));
  must(rollcon_contact_create(context, body, body, &contact));
  must(rollcon_contact_set_gap_quadratic(contact, 0.001, 0.001, 0));
  must(rollcon_contact_set_rolling(contact, speed));
  must(rollcon_contact_frame_rectangle(contact, ROLLCON_QUAD4, 40, 40, -8, 8, -8, 8));
  must(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, load));

  printf("creepage  coulomb Fx/Fn  exponential Fx/Fn  orthotropic Fx/Fn  Fy/Fn\n");
  for (i = 1; i <= 10; ++i) {
    const double creepage = 0.002 * i;
    printf("%8.3f", creepage);
    for (law = 0; law < 3; ++law) {
      must(rollcon_contact_set_friction(contact, name[law], count[law], parameters[law]));
      solve_at(contact, -creepage, force);
      printf("  %8.4f", force[0] / load);
      if (law == 1 && i == 10) steep = force[0];
    }
    printf("  %8.4f\n", force[1] / load);
  }

  must(rollcon_contact_set_friction(contact, name[1], count[1], parameters[1]));
  solve_at(contact, -0.02, force);
  printf("force %.4f Fn: creepage %.5f, continued from sliding;", steep / load, -creepage_of(contact, steep));
  must(rollcon_contact_reset(contact));
  printf(" %.5f, from stick\n", -creepage_of(contact, steep));

  rollcon_contact_release(contact);
  rollcon_body_release(body);
  rollcon_context_release(context);
  return 0;
}
