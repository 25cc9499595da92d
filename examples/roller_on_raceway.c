/* A crowned roller on the raceway of a bearing's inner ring, both from their profiles: how far may it tilt?

   The roller's profile is a chain of arcs: a long crown, and a shorter radius towards either end. Load 1500 N; gap,
   frame and contact are found from surfaces and poses. Beside it Hertz's line contact without crown.
   Units: mm, N; so MPa. docs/profiles.md. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "rollcon.h"

static const double radius = 6, ring = 30, young = 2.08e5, poisson = 0.3, load = 1500;
static const double crown = 2000, relief = 100, flat_half = 4, half = 5;

/* Ends the program with the library's own words if a status is below zero. */
static int32_t must(int32_t status) {
  if (status >= 0) return status;
  fprintf(stderr, "%s: %s\n", rollcon_status_string(status), rollcon_last_error());
  exit(1);
}

static rollcon_body* elastic(rollcon_context* context) {
  rollcon_body* body;
  must(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &body));
  must(rollcon_body_set_elastic(body, 0, young, poisson));
  return body;
}

/* Gives the profile from the left end to the right one: relief, crown, relief; z = 0 in the middle. */
static void give_roller_profile(rollcon_body* roller) {
  const double turn = asin(flat_half / crown);
  const double rest = asin(sin(turn) + (half - flat_half) / relief) - turn;
  const double y = -crown * sin(turn) - relief * (sin(turn + rest) - sin(turn));
  const double z = crown * (cos(turn) - 1) + relief * (cos(turn + rest) - cos(turn));
  double chain[9];
  chain[0] = y;
  chain[1] = z;
  chain[2] = turn + rest;
  chain[3] = chain[7] = relief * rest;
  chain[4] = chain[8] = -1 / relief;
  chain[5] = 2 * crown * turn;
  chain[6] = -1 / crown;
  must(rollcon_body_set_profile_shape(roller, "arcs", 9, chain));
}

int main(void) {
  const double axis[3] = {0, 1, 0}, below[3] = {0, 0, -30}, above[3] = {0, 0, 6}, zero[3] = {0, 0, 0};
  const double straight[2] = {10, 0}, mu = 0.05, modulus = young / (2 * (1 - poisson * poisson));
  const double pi = acos(-1.0), curvature = 1 / radius + 1 / ring;
  rollcon_context* context;
  rollcon_body *inner, *roller;
  rollcon_contact* contact;
  int k;
  must(rollcon_context_create(ROLLCON_ABI, &context));
  inner = elastic(context);
  must(rollcon_body_set_profile_shape(inner, "line", 2, straight));
  must(rollcon_body_revolve_profile(inner, below, axis, ring));
  roller = elastic(context);
  give_roller_profile(roller);
  must(rollcon_body_revolve_profile(roller, above, axis, radius));

  must(rollcon_contact_create(context, inner, roller, &contact));
  must(rollcon_contact_set_friction(contact, "coulomb", 1, &mu));
  must(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, load));

  printf("Hertz, a roller without crown of %g mm: %.1f MPa\n", 2 * half,
         sqrt(load / (2 * half) * modulus * curvature / pi));
  printf("%12s %14s %14s %12s\n", "tilt, mrad", "pressure, MPa", "approach, um", "area, mm2");
  for (k = 0; k <= 3; ++k) {
    const double tilt = 0.25e-3 * k;
    double rotation[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, pressure, area, approach, creep[3];
    rotation[4] = rotation[8] = cos(tilt);
    rotation[7] = sin(tilt);
    rotation[5] = -rotation[7];
    must(rollcon_contact_set_pose(contact, ROLLCON_BODY2, rotation, zero));
    must(rollcon_contact_solve(contact));
    must(rollcon_contact_get_stat(contact, "max_pressure", &pressure));
    must(rollcon_contact_get_stat(contact, "contact_area", &area));
    must(rollcon_contact_get_motion(contact, &approach, creep));
    printf("%12.2f %14.1f %14.3f %12.4f\n", 1e3 * tilt, pressure, 1e3 * approach, area);
  }
  rollcon_contact_release(contact);
  rollcon_body_release(roller);
  rollcon_body_release(inner);
  rollcon_context_release(context);
  return 0;
}
