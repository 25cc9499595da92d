/* A roller covered with rubber rolls on a steel table at speeds of five decades: what does it cost? Slow rubber is
   soft, fast rubber is stiff, and between both it lags behind: the pressure moves forwards, and rolling resists.

       rubber_roller [folder]

   Compares the power lost in the rubber with what the moment of the pressures takes, then leaves rubber_roller.csv in
   the folder (the present one unless given), which plot_rubber_roller.gp draws. Units: mm, N, s; so MPa and mW. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "rollcon.h"

enum { TERMS = 3, SPEEDS = 21 };
static const double young = 12, poisson = 0.48; /* what the rubber has at once */
static const double ratios[TERMS] = {0.25, 0.25, 0.2}, times[TERMS] = {1e-3, 1e-2, 1e-1};
static const double radius = 50, crown = 600, load = 300, frictionless = 0;

/* Ends the program with the library's own words if a status is below zero. */
static int32_t must(int32_t status) {
  if (status >= 0) return status;
  fprintf(stderr, "%s: %s\n", rollcon_status_string(status), rollcon_last_error());
  exit(1);
}

static double statistic(const rollcon_contact* contact, const char* name) {
  double value = 0;
  must(rollcon_contact_get_stat(contact, name, &value));
  return value;
}

int main(int argc, char** argv) {
  char path[1024];
  double worst = 0, largest = 0, at = 0;
  rollcon_context* context;
  rollcon_body *roller, *table;
  rollcon_contact* contact;
  FILE* file;
  int k;
  snprintf(path, sizeof path, "%s/rubber_roller.csv", argc > 1 ? argv[1] : ".");
  file = fopen(path, "w");
  if (!file) return 1;

  must(rollcon_context_create(ROLLCON_ABI, &context));
  must(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &roller));
  must(rollcon_body_set_elastic(roller, 0, young, poisson));
  must(rollcon_body_set_viscoelastic(roller, 0, TERMS, ratios, times));
  must(rollcon_body_create(context, ROLLCON_BODY_RIGID, &table));
  must(rollcon_contact_create(context, roller, table, &contact));
  must(rollcon_contact_set_gap_quadratic(contact, 0.5 / radius, 0.5 / crown, 0));
  must(rollcon_contact_set_friction(contact, "coulomb", 1, &frictionless));
  must(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, load));

  fprintf(file, "speed,coefficient,approach,pressure,offset\n");
  printf(
      "     speed  resistance  over load    approach  pressure   centre\n      mm/s           N                     mm "
      "      MPa       mm\n");
  for (k = 0; k < SPEEDS; ++k) {
    const double speed = pow(10, 0.25 * k);
    double force[3], moment[3], approach, creep[3], resistance, pressure;
    must(rollcon_contact_set_rolling(contact, speed));
    if (must(rollcon_contact_solve(contact)) != ROLLCON_OK) {
      fprintf(stderr, "at %g mm/s: no good solution\n", speed);
      return 1;
    }
    must(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, force, moment));
    must(rollcon_contact_get_motion(contact, &approach, creep));
    resistance = statistic(contact, "rolling_resistance");
    pressure = statistic(contact, "max_pressure");
    worst = fmax(worst, fabs(resistance * radius / moment[1] - 1));
    if (resistance > largest) largest = resistance, at = speed;
    fprintf(file, "%.6g,%.6g,%.6g,%.6g,%.6g\n", speed, resistance / load, approach, pressure, -moment[1] / force[2]);
    if (k % 2 == 0)
      printf("%10.0f %11.3f %10.4f %11.4f %9.4f %8.3f\n", speed, resistance, resistance / load, approach, pressure,
             -moment[1] / force[2]);
  }
  fclose(file);
  printf("\nlargest resistance %.2f N, %.3f of the load, at %.0f mm/s\n", largest, largest / load, at);
  printf("by the moment of the pressures over the radius it is the same within %.0f %%\n", ceil(100 * worst));
  rollcon_contact_release(contact);
  rollcon_body_release(table);
  rollcon_body_release(roller);
  rollcon_context_release(context);
  return worst < 0.02 ? 0 : 1;
}
