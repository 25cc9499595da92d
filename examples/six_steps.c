/* The six steps in C: an elastic sphere rolls on a rigid plane and transmits 75 % of the force at
   which it would slide. Units: mm, N, MPa. six_steps.f90, _77.f and .py print the same. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "rollcon.h"

static rollcon_context* context;

/* Ends the program with the library's own words if a status is below zero. */
static int32_t must(int32_t status) {
  if (status >= 0) return status;
  fprintf(stderr, "%s: %s\n", rollcon_status_string(status), rollcon_last_error());
  exit(1);
}

/* Prints six digits; what is zero up to rounding is printed as zero. */
static void print_numbers(const char* name, int n, const double* v) {
  int i;
  printf("%-14s", name);
  for (i = 0; i < n; ++i) {
    if (fabs(v[i]) < 5e-7) {
      printf("     0.000000");
    } else {
      printf("%13.5E", v[i]);
    }
  }
  printf("\n");
}

static void print_integers(const char* name, int n, const int32_t* v) {
  int i;
  printf("%-14s", name);
  for (i = 0; i < n; ++i) printf("%13d", (int)v[i]);
  printf("\n");
}

int main(void) {
  const double radius = 50, young = 1e4, poisson = 0.3, mu = 0.1;
  const double load = 298.6, traction_force = 0.75 * mu * load, speed = 10;
  rollcon_body *sphere, *plane;
  rollcon_contact* contact;
  double *t, force[3], moment[3], approach, creep[3], most = 0;
  int32_t *state, count[4] = {0, 0, 0, 0}, status;
  int64_t nodes, i;

  /* Step 1 makes the bodies. */
  must(rollcon_context_create(ROLLCON_ABI, &context));
  must(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &sphere));
  must(rollcon_body_create(context, ROLLCON_BODY_RIGID, &plane));

  /* Step 2 gives the gap between them; the library makes the mesh of the contact, its frame, to fit. */
  must(rollcon_contact_create(context, sphere, plane, &contact));
  must(rollcon_contact_set_gap_quadratic(contact, 1 / (2 * radius), 1 / (2 * radius), 0));

  /* Step 3 sets the materials. */
  must(rollcon_body_set_elastic(sphere, 0, young, poisson));
  must(rollcon_contact_set_friction(contact, "coulomb", 1, &mu));

  /* Step 4 sets creepages and loads. */
  must(rollcon_contact_set_rolling(contact, speed));
  must(rollcon_contact_set_creep(contact, 0, 0, 0));
  must(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, load));
  must(rollcon_contact_prescribe(contact, ROLLCON_LONGITUDINAL, ROLLCON_BY_FORCE, traction_force));

  /* Step 5 solves. */
  status = must(rollcon_contact_solve(contact));

  /* Step 6 reads the results. */
  must(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, force, moment));
  must(rollcon_contact_get_motion(contact, &approach, creep));
  must(rollcon_contact_get_size(contact, &nodes, NULL));
  t = malloc(3 * (size_t)nodes * sizeof *t);
  state = malloc((size_t)nodes * sizeof *state);
  if (t == NULL || state == NULL) return 1;
  must(rollcon_contact_get_tractions(contact, ROLLCON_LOCAL, nodes, t));
  must(rollcon_contact_get_node_states(contact, nodes, state));
  for (i = 0; i < nodes; ++i) {
    if (-t[3 * i + 2] > most) most = -t[3 * i + 2];
    ++count[state[i]];
  }
  print_integers("status", 1, &status);
  print_numbers("force", 3, force);
  print_numbers("moment", 3, moment);
  print_numbers("approach", 1, &approach);
  print_numbers("creepages", 3, creep);
  print_numbers("max pressure", 1, &most);
  print_integers("stick slip rim", 3, count + ROLLCON_STICK);
  print_numbers("centre", 3, t + 3 * (nodes / 2));

  free(state);
  free(t);
  rollcon_contact_release(contact);
  rollcon_body_release(plane);
  rollcon_body_release(sphere);
  rollcon_context_release(context);
  return 0;
}
