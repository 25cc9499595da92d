/* A table of creep forces for vehicle dynamics: a steel wheel on a steel rail, 5 wheel loads by 41
   longitudinal by 21 lateral creepages by 3 spins, solved by one call over the threads of the
   machine.

       creep_force_table [folder [threads]]

   Prints a piece of the table and what it cost, and leaves in the folder (the present one unless
   given) creep_force_table.csv: load, creepages and spin, forces and spin moment, their derivatives
   by longitudinal and lateral creepage, and the power lost to friction. plot_creep_force.gp draws
   it. Units: mm, N, s; so MPa and mW. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "rollcon.h"

enum { SIDE = 11, LOADS = 5, ALONG = 41, ACROSS = 21, SPINS = 3 };
enum { CASES = LOADS * ALONG * ACROSS * SPINS, PARAMETERS = 4 };
/* The results have these columns. */
enum { FORCE = 0, MOMENT = 3, ITERATIONS = 6, POWER = 7, SLOPES = 8, WIDTH = 8 + 10 * PARAMETERS };
enum { BY_LATERAL = SLOPES + 20, BY_LONGITUDINAL = SLOPES + 30 };

static const double young = 210000, poisson = 0.28, mu = 0.3, load = 100000, speed = 30000;
static const double wheel_radius = 460, rail_crown = 300;
static const double half_along = 9, half_across = 6.8; /* half sizes of the frame */

static rollcon_context* context;
static double values[CASES][PARAMETERS], result[CASES][WIDTH];
static int32_t status[CASES];

/* Ends the program with the library's own words if a status is below zero. */
static int32_t must(int32_t result) {
  if (result >= 0) return result;
  fprintf(stderr, "%s: %s\n", rollcon_status_string(result), rollcon_last_error());
  exit(1);
}

static void set_scene(rollcon_contact* contact) {
  must(rollcon_contact_frame_rectangle(contact, ROLLCON_QUAD4, SIDE, SIDE, -half_along, half_along, -half_across,
                                       half_across));
  must(rollcon_contact_set_gap_quadratic(contact, 0.5 / wheel_radius, 0.5 / rail_crown, 0));
  must(rollcon_contact_set_friction(contact, "coulomb", 1, &mu));
  must(rollcon_contact_set_rolling(contact, speed));
  must(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, load));
}

static double part(int i, int n) { /* from -1 to 1 */
  return 2.0 * i / (n - 1) - 1;
}

static void list_cases(void) {
  int l, a, b, s, k = 0;
  for (l = 0; l < LOADS; ++l)
    for (s = 0; s < SPINS; ++s)
      for (b = 0; b < ACROSS; ++b)
        for (a = 0; a < ALONG; ++a, ++k) {
          values[k][0] = load * (1 + 0.3 * part(l, LOADS));
          values[k][1] = 5e-4 * part(s, SPINS);
          values[k][2] = 5e-3 * part(b, ACROSS);
          values[k][3] = 5e-3 * part(a, ALONG);
        }
}

static void write_table(const char* folder) {
  char path[1000];
  FILE* file;
  int k;
  snprintf(path, sizeof path, "%s/creep_force_table.csv", folder);
  file = fopen(path, "w");
  if (!file) {
    fprintf(stderr, "cannot write %s\n", path);
    exit(1);
  }
  fprintf(file,
          "load,spin,lateral,longitudinal,F1,F2,M3,dF1/dlongitudinal,dF1/dlateral,"
          "dF2/dlongitudinal,dF2/dlateral,friction_power\n");
  for (k = 0; k < CASES; ++k)
    fprintf(file, "%g,%g,%g,%g,%.9g,%.9g,%.9g,%.6g,%.6g,%.6g,%.6g,%.6g\n", values[k][0], values[k][1], values[k][2],
            values[k][3], result[k][FORCE], result[k][FORCE + 1], result[k][MOMENT + 2], result[k][BY_LONGITUDINAL],
            result[k][BY_LATERAL], result[k][BY_LONGITUDINAL + 1], result[k][BY_LATERAL + 1], result[k][POWER]);
  if (fclose(file) != 0) exit(1);
}

static void print_piece(void) {
  int k;
  printf("wheel load 100 kN, no lateral creepage, no spin\n\n");
  printf("  longitudinal    F1/(mu P)   dF1/dxi / (mu P)   friction power W\n");
  for (k = 0; k < CASES; ++k) {
    if (fabs(values[k][0] - load) > 1 || values[k][1] != 0 || values[k][2] != 0) continue;
    if (fmod(fabs(values[k][3]) + 1e-12, 1e-3) > 2e-12) continue;
    printf("  %12.4f %12.6f %15.3f %17.2f\n", values[k][3], result[k][FORCE] / (mu * load),
           result[k][BY_LONGITUDINAL] / (mu * load), result[k][POWER] / 1000);
  }
}

int main(int argc, char** argv) {
  rollcon_body *wheel = NULL, *rail = NULL;
  rollcon_contact* contact = NULL;
  double iterations = 0;
  int failed = 0, k;
  must(rollcon_context_create(ROLLCON_ABI, &context));
  if (argc > 2) must(rollcon_context_set_threads(context, atoi(argv[2])));
  must(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &wheel));
  must(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &rail));
  must(rollcon_body_set_elastic(wheel, 0, young, poisson));
  must(rollcon_body_set_elastic(rail, 0, young, poisson));
  must(rollcon_contact_create(context, wheel, rail, &contact));
  set_scene(contact);
  list_cases();
  must(rollcon_contact_solve_many(contact, "normal spin lateral longitudinal", CASES, values[0],
                                  "force moment iterations friction_power derivatives", WIDTH, result[0], NULL,
                                  status));
  for (k = 0; k < CASES; ++k) {
    failed += status[k] != ROLLCON_OK;
    iterations += result[k][ITERATIONS];
  }
  print_piece();
  printf("\n%d cases, %.2f iterations each, %d without a good solution\n", (int)CASES, iterations / CASES, failed);
  write_table(argc > 1 ? argv[1] : ".");
  rollcon_contact_release(contact);
  rollcon_body_release(rail);
  rollcon_body_release(wheel);
  rollcon_context_release(context);
  return failed > 0;
}
