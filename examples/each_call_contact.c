/* Makes calls that other examples do not need: frames, fields, options, watching, results. docs/api.md shows its lines.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "rollcon_layers.h"

enum { nx = 24, ny = 20, most_nodes = (nx + 1) * (ny + 1), most_rows = 200 };

static int32_t must(int32_t status) {
  if (status >= 0) return status;
  fprintf(stderr, "%s: %s\n", rollcon_status_string(status), rollcon_last_error());
  exit(1);
}

/* Counts iterations; stops the solve of a contact that it is given after the third. */
static int32_t watch(const rollcon_event* event, void* user) {
  rollcon_contact* stop = user;
  int64_t phase, iteration;
  double residual, seconds;
  must(rollcon_event_get_int(event, ROLLCON_EVENT_PHASE, &phase));
  must(rollcon_event_get_int(event, ROLLCON_EVENT_ITERATION, &iteration));
  must(rollcon_event_get_real(event, ROLLCON_EVENT_RESIDUAL, &residual));
  must(rollcon_event_get_real(event, ROLLCON_EVENT_SECONDS, &seconds));
  if (stop && iteration >= 3) must(rollcon_contact_request_cancel(stop));
  return 0; /* another number would stop it, too */
}

static rollcon_contact* steel_on_steel(rollcon_context* context) {
  const double mu = 0.3;
  rollcon_body *wheel, *rail;
  rollcon_contact* contact;
  must(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &wheel));
  must(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &rail));
  must(rollcon_body_set_elastic(wheel, 0, 210000, 0.3));
  must(rollcon_body_set_elastic(rail, 0, 210000, 0.3));
  must(rollcon_contact_create(context, wheel, rail, &contact));
  must(rollcon_contact_set_gap_quadratic(contact, 1.0 / 920, 1.0 / 600, 0));
  must(rollcon_contact_set_friction(contact, "coulomb", 1, &mu));
  must(rollcon_contact_set_rolling(contact, 30000));
  must(rollcon_contact_set_creep(contact, 1e-3, 0, 0));
  must(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, 80000));
  rollcon_body_release(wheel);
  rollcon_body_release(rail);
  return contact;
}

static double force_along(rollcon_contact* contact) {
  double force[3];
  must(rollcon_contact_solve(contact));
  must(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, force, NULL));
  return -force[0];
}

static void frames(rollcon_contact* contact) {
  double lines[15], gap[(nx + 1) * (ny + 1)];
  int i, j;
  must(rollcon_contact_frame_automatic(contact));
  printf("frames of the library %.0f N\n", force_along(contact));
  must(rollcon_contact_frame_ellipse(contact, 20, 16, 6.66, 5.02, 0));
  printf("frame in an ellipse %.0f N\n", force_along(contact));
  for (i = 0; i < 5; ++i) { /* y, and x from, to: a rhombus, too small */
    lines[3 * i] = i - 2;
    lines[3 * i + 2] = i == 2 ? 3 : i % 4 == 0 ? 1 : 2;
    lines[3 * i + 1] = -lines[3 * i + 2];
  }
  must(rollcon_contact_frame_strips(contact, 8, 5, lines));
  printf("frame in strips: status %d\n", (int)rollcon_contact_solve(contact));
  must(rollcon_contact_frame_rectangle(contact, ROLLCON_QUAD4, nx, ny, -9, 9, -7, 7));
  for (j = 0; j <= ny; ++j)
    for (i = 0; i <= nx; ++i) {
      const double x = -9 + 18.0 * i / nx, y = -7 + 14.0 * j / ny;
      gap[j * (nx + 1) + i] = x * x / 920 + y * y / 600;
    }
  must(rollcon_contact_set_gap(contact, most_nodes, gap));
  printf("gap by nodes %.0f N\n", force_along(contact));
  must(rollcon_contact_set_gap_grid(contact, nx + 1, -9, 9, -7, 7, most_nodes, gap));
  printf("gap by a grid %.0f N\n", force_along(contact));
}

static void friction(rollcon_contact* contact) {
  const double mu = 0.3, across[4] = {-2, 0.1, 2, 0.3}, falling[3] = {0.2, 0.2, 200}, centre[2] = {0, 0};
  double warm[2];
  must(rollcon_contact_set_friction_across(contact, 2, across));
  printf("friction that changes across %.0f N\n", force_along(contact));
  must(rollcon_contact_set_friction_across(contact, 0, NULL));
  must(rollcon_contact_set_layer(contact, 1e-8, 100, 0));
  printf("through a layer %.0f N\n", force_along(contact));
  must(rollcon_contact_set_layer(contact, 0, 0, 0));
  must(rollcon_contact_set_heat(contact, ROLLCON_BODY1, 50, 3.6,
                                20)); /* W/(m K) = N/(s K), MJ/(m^3 K) = N/(mm^2 K), degrees */
  must(rollcon_contact_set_heat(contact, ROLLCON_BODY2, 50, 3.6, 20));
  must(rollcon_contact_get_temperatures_at(contact, 1, centre, warm));
  printf("its middle is %s\n", warm[0] > 20 ? "warmer than the rest" : "cold");
  must(rollcon_contact_set_friction(contact, "exponential", 3, falling));
  must(rollcon_contact_set_friction_memory(contact, 0.01, 0.1));
  printf("falling friction with a memory %.0f N\n", force_along(contact));
  must(rollcon_contact_set_friction_memory(contact, 0, 0));
  must(rollcon_contact_set_friction(contact, "coulomb", 1, &mu));
}

static void fields(rollcon_contact* contact) {
  static double slip[2 * most_nodes], mu[most_nodes];
  const double rolling[3] = {-30000, 0, 0}, faster[3] = {-30030, 0, 0}, none[3] = {0, 0, 0};
  int i;
  for (i = 0; i < most_nodes; ++i) {
    slip[2 * i] = 3;
    mu[i] = 0.2;
  }
  must(rollcon_contact_set_creep_field(contact, most_nodes, slip));
  printf("more slip by a field %.0f N\n", force_along(contact));
  must(rollcon_contact_set_creep_field(contact, 0, NULL));
  must(rollcon_contact_set_friction_field(contact, most_nodes, mu));
  printf("less friction by a field %.0f N\n", force_along(contact));
  must(rollcon_contact_set_friction_field(contact, 0, NULL));
  must(rollcon_contact_set_velocity(contact, ROLLCON_BODY1, rolling, none, none));
  must(rollcon_contact_set_velocity(contact, ROLLCON_BODY2, faster, none, none));
  printf("creepage from velocities: force %s\n", fabs(force_along(contact)) > 1000 ? "there" : "missing");
  must(rollcon_contact_set_creep(contact, 1e-3, 0, 0));
}

static void options(rollcon_contact* contact) {
  int64_t most;
  int32_t type;
  double tolerance, low, high, standard;
  char text[400], doc[400];
  must(rollcon_contact_set_int(contact, "max_iterations", 80));
  must(rollcon_contact_set_real(contact, "tolerance", 1e-9));
  must(rollcon_contact_set_procedure(contact, "")); /* the library's own iteration, the standard */
  must(rollcon_contact_get_int(contact, "max_iterations", &most));
  must(rollcon_contact_get_real(contact, "tolerance", &tolerance));
  must(rollcon_contact_get_str(contact, "operators", sizeof text, text, NULL));
  printf("at most %d iterations to %.0e, operators %s\n", (int)most, tolerance, text);
  if (rollcon_option_count(ROLLCON_OF_CONTACT) < 1 || rollcon_stat_count(ROLLCON_OF_CONTACT) < 1) exit(1);
  must(rollcon_option_info(ROLLCON_OF_CONTACT, 0, sizeof text, text, NULL, NULL, &type, &low, &high, &standard));
  printf("first option %s\n", text);
  must(rollcon_stat_info(ROLLCON_OF_CONTACT, 0, sizeof text, text, doc, NULL, NULL));
  printf("first statistic %s: %s\n", text, doc);
}

static void watching(rollcon_contact* contact) {
  must(rollcon_contact_set_progress(contact, watch, NULL));
  printf("watched %.0f N\n", force_along(contact));
  must(rollcon_contact_reset(contact));
  must(rollcon_contact_set_progress(contact, watch, contact));
  if (must(rollcon_contact_solve(contact)) > 0) printf("stopped: %s\n", rollcon_last_caveat());
  must(rollcon_contact_set_progress(contact, NULL, NULL));
}

static void results(rollcon_contact* contact) {
  const double xy[2] = {0, 0}, xyz[3] = {0, 0, -3};
  double rows[2 * most_rows];
  double force[3], moment[3], creep[3], tilt[2], approach, u[3], stress[6], principal[3], von_mises, shear, index;
  const double archard = 1e-9, across[5] = {-20, -10, 0, 10, 20}; /* mm^2/N; mm */
  const double flat[10] = {-20, 0, -10, 0, 0, 0, 10, 0, 20, 0};
  double depth[5], worn[10], place[3];
  char* plan;
  int64_t n;
  printf("again %.0f N\n", force_along(contact));
  must(rollcon_contact_get_tilt(contact, tilt));
  must(rollcon_contact_get_sensitivity(contact, ROLLCON_LONGITUDINAL, force, moment, &approach, creep));
  printf("slope of the force by creepage %.3g N\n", -force[0]);
  must(rollcon_contact_get_displacements_at(contact, ROLLCON_BODY1, 1, xy, u));
  must(rollcon_contact_get_fields_at(contact, ROLLCON_BODY1, 1, xyz, ROLLCON_IN_CONTACT, u, stress));
  must(rollcon_stress_invariants(1, stress, principal, &von_mises, &shear));
  printf("3 mm deep: von Mises %.0f MPa, shear %.0f MPa\n", von_mises, shear);
  must(rollcon_contact_find_stress(contact, ROLLCON_BODY1, "shear", 0, NULL, &shear, place));
  printf("the largest shear, %.0f MPa, is %.1f mm deep\n", shear, -place[2]);
  must(rollcon_contact_get_fatigue_index(contact, 300, &index));
  printf("index of surface fatigue %.2f\n", index);
  must(rollcon_contact_get_wear(contact, "archard", 1, &archard, 5, across, depth, NULL));
  must(rollcon_wear_profile(5, flat, depth, ROLLCON_BODY_BELOW, 1e4, 0.01, 0, worn, NULL));
  printf("ten thousand passes wear the middle %s\n", worn[5] > 0 ? "most" : "not at all");
  must(rollcon_contact_get_history(contact, "seconds error_function", most_rows, rows, &n));
  must(rollcon_contact_get_plan(contact, 0, NULL, &n));
  plan = malloc((size_t)n);
  if (!plan) exit(1);
  must(rollcon_contact_get_plan(contact, n, plan, NULL));
  printf("%s\n", n > 100 ? "the plan tells how it was solved" : plan);
  free(plan);
}

static void cases(rollcon_contact* contact) {
  const double loads[3] = {40000, 80000, 120000};
  double forces[9];
  int32_t status[3];
  must(rollcon_contact_solve_many(contact, "normal", 3, loads, "force", 3, forces, NULL, status));
  printf("a list: %.0f, %.0f, %.0f N\n", -forces[0], -forces[3], -forces[6]);
}

static void steps(rollcon_contact* contact) {
  double first, again;
  must(rollcon_contact_set_step(contact, ROLLCON_ROLLING_STEP, 1e-4));
  first = force_along(contact);
  must(rollcon_contact_repeat_step(contact));
  again = force_along(contact);
  printf("a step in time %.0f N, repeated %.0f N\n", first, again);
}

int main(void) {
  rollcon_context* context;
  rollcon_contact* contact;
  must(rollcon_context_create(ROLLCON_ABI, &context));
  contact = steel_on_steel(context);
  must(rollcon_contact_retain(contact));
  if (rollcon_contact_from_id(rollcon_id_of(contact)) != contact) return 1;
  rollcon_contact_release(contact);
  frames(contact);
  fields(contact);
  options(contact);
  watching(contact);
  friction(contact);
  results(contact);
  cases(contact);
  steps(contact);
  rollcon_contact_release(contact);
  rollcon_context_release(context);
  return 0;
}
