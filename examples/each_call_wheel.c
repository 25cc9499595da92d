/* Makes calls that other examples do not need: creep-force tables, wheels on rails. docs/api.md shows its lines. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "rollcon_layers.h"

static int32_t must(int32_t status) {
  if (status >= 0) return status;
  fprintf(stderr, "%s: %s\n", rollcon_status_string(status), rollcon_last_error());
  exit(1);
}

static int32_t count(const rollcon_event* event, void* user) {
  (void)event;
  ++*(int*)user;
  return 0;
}

/* Makes a coarse table, for ratios of half axes around 1 alone. */
static void small_table(rollcon_context* context) {
  const double poisson = 0.28;
  const double steel_on_rubber[2] = {210000, 5}, poissons[2] = {0.28, 0.49}, frictions[2] = {0.2, 0.4};
  const double inputs[9] = {82000, 0.28, 0.3, 6, 5, 1e5, 1e-3, 0, 0};
  double forces[3], derivatives[27], *samples;
  int calls = 0;
  int64_t n;
  rollcon_table *table, *copy;
  must(rollcon_table_create(context, &table));
  must(rollcon_table_set_ratios(table, 4, 0.5, 2));
  must(rollcon_table_set_resolution(table, 8, 4, 4));
  must(rollcon_table_set_frame(table, 6, 4));
  must(rollcon_table_set_poissons(table, 1, &poisson));
  must(rollcon_table_set_progress(table, count, &calls));
  must(rollcon_table_make(table, 0, 1));
  must(rollcon_table_request_cancel(table)); /* nothing runs: nothing is stopped */
  must(rollcon_table_evaluate(table, 1, inputs, forces));
  printf("a small table: %.0f N%s\n", -forces[0], calls > 0 ? ", watched" : "");
  must(rollcon_table_save(table, "each_call.rct"));
  must(rollcon_table_load(context, "each_call.rct", &copy));
  must(rollcon_table_evaluate_derivatives(copy, 1, inputs, forces, derivatives));
  printf("its copy: %.0f N, by creepage %.3g N\n", -forces[0], -derivatives[6]);
  must(rollcon_table_retain(copy));
  if (rollcon_table_from_id(rollcon_id_of(copy)) != copy) exit(1);
  rollcon_table_release(copy);
  rollcon_table_release(copy);
  /* Parts can be made by several processes: the samples of one go to another. */
  must(rollcon_table_get_samples(table, 0, NULL, &n));
  samples = malloc((size_t)n * sizeof *samples);
  if (!samples) exit(1);
  must(rollcon_table_get_samples(table, n, samples, &n));
  must(rollcon_table_create(context, &copy));
  must(rollcon_table_set_ratios(copy, 4, 0.5, 2));
  must(rollcon_table_set_resolution(copy, 8, 4, 4));
  must(rollcon_table_set_frame(copy, 6, 4));
  must(rollcon_table_set_bodies(copy, steel_on_rubber, poissons, 2, frictions)); /* would be one of unlike bodies */
  must(rollcon_table_set_poissons(copy, 1, &poisson));
  must(rollcon_table_add_samples(copy, n, samples));
  must(rollcon_table_evaluate(copy, 1, inputs, forces));
  printf("from its samples: %.0f N\n", -forces[0]);
  free(samples);
  rollcon_table_release(copy);
  must(rollcon_table_standard(context, &copy));
  must(rollcon_table_evaluate(copy, 1, inputs, forces));
  printf("the standard table: %.0f N\n", -forces[0]);
  rollcon_table_release(copy);
  rollcon_table_release(table);
  remove("each_call.rct");
}

static rollcon_body* steel(rollcon_context* context, const char* profile) {
  const double millimetre = 1;
  rollcon_body* body;
  must(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &body));
  must(rollcon_body_set_elastic(body, 0, 210000, 0.28));
  must(rollcon_body_set_profile_shape(body, profile, 1, &millimetre));
  return body;
}

static rollcon_wheelrail* wheel_on_rail(rollcon_context* context, rollcon_body* tread, rollcon_body* rail,
                                        int32_t side) {
  const double mu = 0.3;
  rollcon_wheelrail* wheel;
  must(rollcon_wheelrail_create(context, tread, rail, side, &wheel));
  must(rollcon_wheelrail_set_track(wheel, 1435, 14, atan(1.0 / 40)));
  must(rollcon_wheelrail_set_wheelset(wheel, 1360, -70, 460));
  must(rollcon_wheelrail_set_friction(wheel, "coulomb", 1, &mu));
  must(rollcon_wheelrail_prescribe_vertical(wheel, ROLLCON_BY_FORCE, 1e5));
  return wheel;
}

static void wheels(rollcon_context* context) {
  const double position[6] = {0, 3, 0, 0, 0, 0}, velocity[6] = {30000, 0, 0, 0, 0, -65.2};
  const double lower[3] = {0, 0.5, 0}, still[3] = {0, 0, 0}, shift[2] = {0, 3}, amplitude[2] = {2, 4};
  double force[3], moment[3], point[2], origin[3], axes[9], force_rate[3], moment_rate[3], z_rate, pressure, total,
      differences[2], conicity[2], wavelength[2];
  const double by_angle[4] = {-1, 0.1, -0.2, 0.3};
  const double bent[6] = {0, 0.1, 0.05, 1e-4, 0, 0}, at_rest[6] = {0, 0, 0, 0, 0, 0};
  const double stiffness[2] = {2e4, 6e4}, no_force[2] = {0, 0};
  const double falling_by_angle[8] = {-1, 0.05, 0.05, 500, -0.2, 0.2, 0.15, 1000}; /* angle, muk, mu1, s1 */
  const char* law = "archard";
  const double i = 1e-9; /* mm^2/N */
  double w[9];
  char text[64];
  int32_t status;
  int64_t outside, numbers;
  double* past;
  rollcon_body *tread = steel(context, "s1002"), *rail = steel(context, "60e1");
  rollcon_wheelrail *left = wheel_on_rail(context, tread, rail, ROLLCON_LEFT), *copy;
  rollcon_wheelrail* right = wheel_on_rail(context, tread, rail, ROLLCON_RIGHT);
  rollcon_table* table;
  double ellipse[9], center[2], of_table[3], looked_up, accuracy;
  rollcon_contact* contact;
  must(rollcon_wheelrail_set_real(right, "accuracy", 0.02));
  must(rollcon_wheelrail_get_real(right, "accuracy", &accuracy));
  must(rollcon_wheelrail_set_int(right, "roll_outside", 1)); /* positions in CONTACT's order */
  must(rollcon_wheelrail_get_int(right, "roll_outside", &outside));
  printf("accuracy %.2f, roll outside the yaw: %d\n", accuracy, (int)outside);
  must(rollcon_wheelrail_set_position(right, position));
  must(rollcon_wheelrail_set_velocity(right, velocity));
  must(rollcon_wheelrail_solve(right));
  must(rollcon_wheelrail_get_resultant(right, ROLLCON_IN_TRACK, force, moment));
  must(rollcon_wheelrail_get_patch_axes(right, 0, origin, axes));
  must(rollcon_wheelrail_get_profile_point(right, ROLLCON_WHEEL, 0, point)); /* the flange's end, in the track */
  must(rollcon_wheelrail_get_derivative(right, 1, force_rate, moment_rate, &z_rate)); /* by the lateral shift */
  printf("lateral force: %.0f N, %.0f N more per millimetre of shift\n", force[1], force_rate[1]);
  printf("on the rail %.0f N\n", fabs(force[2]));
  must(rollcon_wheelrail_get_contact(right, 0, &contact));
  must(rollcon_contact_get_stat(contact, "max_pressure", &pressure));
  printf("its first patch: %s\n", pressure > 500 ? "pressed" : "missing");
  must(rollcon_contact_get_equivalent_ellipse(contact, ellipse, center));
  printf("like an ellipse of %.1f by %.1f mm\n", ellipse[3], ellipse[4]);
  rollcon_contact_release(contact);
  must(rollcon_wheelrail_snapshot(right, 0)); /* before a step that may be tried again */
  must(rollcon_wheelrail_set_rail_deviation(right, lower, still));
  must(rollcon_wheelrail_solve(right));
  must(rollcon_wheelrail_rollback(right, 0));
  must(rollcon_wheelrail_copy(right, &copy));
  must(rollcon_wheelrail_request_cancel(copy));
  must(rollcon_wheelrail_reset(copy));
  must(rollcon_wheelrail_solve_many(copy, 1, position, velocity, "vertical_force", &total, &status));
  printf("a list of positions: status %d, %.0f kN\n", (int)status, total / 1000);
  must(rollcon_wheelrail_find_wear(copy, 1, position, velocity, NULL, law, 1, &i, 9, w, NULL, NULL, NULL));
  must(rollcon_wheelrail_retain(copy));
  if (rollcon_wheelrail_from_id(rollcon_id_of(copy)) != copy) exit(1);
  rollcon_wheelrail_release(copy);
  rollcon_wheelrail_release(copy);
  must(rollcon_table_standard(context, &table));
  must(rollcon_wheelrail_get_contact(right, 0, &contact));
  must(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, force, moment));
  must(rollcon_table_evaluate_contact(table, contact, -1, of_table)); /* with the contact's own friction */
  printf("the table has its lateral force to %.0f N\n", ceil(fabs(of_table[1] - force[1]) / 100) * 100);
  rollcon_contact_release(contact);
  must(rollcon_wheelrail_set_table(right, table));
  rollcon_table_release(table); /* the wheel has a reference of its own */
  must(rollcon_wheelrail_solve(right));
  must(rollcon_wheelrail_get_patch_stat(right, 0, "by_table", &looked_up));
  printf("by the table: %s\n", looked_up == 1 ? "yes" : "no");
  must(rollcon_wheelrail_set_int(right, "hertzian", 1));
  must(rollcon_wheelrail_solve(right));
  must(rollcon_wheelrail_get_patch_stat(right, 0, "hertzian", &looked_up));
  printf("without solving for pressures: %s\n", looked_up == 1 ? "yes" : "no");
  must(rollcon_wheelrail_set_int(right, "hertzian", 0));
  must(rollcon_wheelrail_set_table(right, NULL));
  must(rollcon_wheelrail_set_int(right, "conformal", 1)); /* frames along the profiles */
  must(rollcon_wheelrail_solve(right));
  must(rollcon_wheelrail_get_resultant(right, ROLLCON_IN_TRACK, force, moment));
  printf("conformal: %.1f kN on the rail\n", -force[2] / 1000);
  must(rollcon_wheelrail_set_int(right, "conformal", 0));
  must(rollcon_wheelrail_place_rail(right, 753.2, 0.1, atan(1.0 / 40))); /* the profile's origin */
  must(rollcon_wheelrail_set_tape_circle(right, 0));
  must(rollcon_wheelrail_set_flexibility(right, bent, at_rest));
  must(rollcon_wheelrail_set_rail_springs(right, stiffness, no_force));
  must(rollcon_wheelrail_prescribe_longitudinal(right, ROLLCON_BY_FORCE, 2000));
  must(rollcon_wheelrail_solve(right));
  must(rollcon_wheelrail_get_stat(right, "pitch_rate", &total));
  printf("a force of 2 kN along: pitch rate %.4f\n", total);
  must(rollcon_wheelrail_prescribe_longitudinal(right, ROLLCON_BY_MOTION, 0));
  must(rollcon_wheelrail_set_track(right, 1435, 14, 0));
  must(rollcon_wheelrail_set_roller(right, 500, 0.1)); /* a rig: the roller turns, beside the forward speed */
  must(rollcon_wheelrail_solve(right));
  must(rollcon_wheelrail_get_patch_stat(right, 0, "longitudinal_creepage", &total));
  printf("on a roller: creepage %.4f\n", total);
  must(rollcon_wheelrail_set_roller(right, 0, 0));
  must(rollcon_wheelrail_set_step(right, ROLLCON_ROLLING_STEP, 5e-5)); /* in time, 1.5 mm each */
  must(rollcon_wheelrail_solve(right));
  must(rollcon_wheelrail_solve(right));
  must(rollcon_wheelrail_repeat_step(right));
  must(rollcon_wheelrail_past_get(right, 0, NULL, &numbers));
  past = malloc((size_t)numbers * sizeof *past);
  must(rollcon_wheelrail_past_get(right, numbers, past, &numbers));
  must(rollcon_wheelrail_past_set(right, numbers, past)); /* continues this run, or another one */
  free(past);
  must(rollcon_wheelrail_solve(right));
  must(rollcon_wheelrail_get_stat(right, "steps", &total));
  printf("after %.0f steps in time\n", total);
  must(rollcon_wheelrail_set_step(right, ROLLCON_STEADY, 0));
  must(rollcon_wheelrail_set_track(right, 1435, 14, atan(1.0 / 40)));
  must(rollcon_wheelrail_set_friction(right, "by_angle", 4, by_angle));                   /* a lubricated gauge face */
  must(rollcon_wheelrail_set_law_by_angle(right, "exponential", 2, 8, falling_by_angle)); /* friction that falls */
  must(rollcon_wheelrail_set_friction_memory(right, 0.01, 0.1));                          /* after 10 um of slip */
  must(rollcon_wheelrail_set_layer(right, 1e-7, 0, 0));                /* 10 um of dirt with G = 100 MPa */
  must(rollcon_wheelrail_set_heat(right, ROLLCON_WHEEL, 50, 3.7, 20)); /* mm, N, s, K: steel */
  must(rollcon_wheelrail_set_heat(right, ROLLCON_RAIL, 50, 3.7, 20));
  must(rollcon_wheelrail_solve(right));
  must(rollcon_wheelrail_get_resultant(right, ROLLCON_IN_TRACK, force, moment));
  printf("friction that falls: %.2f kN along\n", force[0] / 1000);
  must(rollcon_wheelrail_find_contact_points(left, right, 2, shift, "radius_difference", differences));
  must(rollcon_wheelrail_find_conicity(left, right, 2, amplitude, conicity, wavelength));
  printf("conicity %.3f at 2 mm, %.3f at 4 mm\n", conicity[0], conicity[1]);
  if (rollcon_stat_count(ROLLCON_OF_WHEELRAIL) < 1 || rollcon_stat_count(ROLLCON_OF_PATCH) < 1) exit(1);
  must(rollcon_stat_info(ROLLCON_OF_WHEELRAIL, 0, sizeof text, text, NULL, NULL, NULL));
  printf("first statistic %s\n", text);
  must(rollcon_stat_info(ROLLCON_OF_PATCH, 0, sizeof text, text, NULL, NULL, NULL));
  printf("first statistic of a patch %s\n", text);
  rollcon_wheelrail_release(left);
  rollcon_wheelrail_release(right);
  rollcon_body_release(tread);
  rollcon_body_release(rail);
}

int main(void) {
  rollcon_context* context;
  must(rollcon_context_create(ROLLCON_ABI, &context));
  small_table(context);
  wheels(context);
  rollcon_context_release(context);
  return 0;
}
