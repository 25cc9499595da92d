/* Shares lists among the ranks of MPI: results and statuses are those of one rank, to the bit, on all ranks; what fails
   or stops on one rank fails or stops on all of them. */
#include <math.h>
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "rollcon.h"

enum { CASES = 13, POSITIONS = 5, POINTS = 9, WIDTH = 4 };

static int rank, ranks, failures;

static void expect(int holds, const char* what) {
  if (holds) return;
  printf("rank %d of %d: %s; last error: %s\n", rank, ranks, what, rollcon_last_error());
  ++failures;
}

/* Ends all ranks where a step that is not under test fails. */
static void must(int32_t status) {
  if (status >= 0) return;
  printf("rank %d: %s: %s\n", rank, rollcon_status_string(status), rollcon_last_error());
  MPI_Abort(MPI_COMM_WORLD, 2);
}

/* Compares bits, so that NaN equals NaN. */
static int same(const void* a, const void* b, size_t bytes) {
  return memcmp(a, b, bytes) == 0;
}

typedef struct {
  rollcon_context* context;
  rollcon_body *wheel, *rail, *plain;
  rollcon_contact* contact;
  rollcon_wheelrail* position;
} scene;

static scene make_scene(int shared) {
  const double mu = 0.3, millimetre = 1;
  scene s;
  int k;
  must(rollcon_context_create(ROLLCON_ABI, &s.context));
  must(rollcon_context_set_threads(s.context, 2));
  if (shared) must(rollcon_context_set_communicator(s.context, (int32_t)MPI_Comm_c2f(MPI_COMM_WORLD)));
  must(rollcon_body_create(s.context, ROLLCON_BODY_HALFSPACE, &s.plain));
  must(rollcon_body_set_elastic(s.plain, 0, 210e3, 0.28));
  for (k = 0; k < 2; ++k) {
    rollcon_body** body = k == 0 ? &s.wheel : &s.rail;
    must(rollcon_body_create(s.context, ROLLCON_BODY_HALFSPACE, body));
    must(rollcon_body_set_elastic(*body, 0, 210e3, 0.28));
    must(rollcon_body_set_profile_shape(*body, k == 0 ? "s1002" : "60e1", 1, &millimetre));
  }
  must(rollcon_wheelrail_create(s.context, s.wheel, s.rail, ROLLCON_RIGHT, &s.position));
  must(rollcon_wheelrail_set_real(s.position, "accuracy", 0.02));
  must(rollcon_wheelrail_set_track(s.position, 1435, 14, atan(1.0 / 40)));
  must(rollcon_wheelrail_set_wheelset(s.position, 1360, -70, 460));
  must(rollcon_wheelrail_set_friction(s.position, "coulomb", 1, &mu));
  must(rollcon_wheelrail_prescribe_vertical(s.position, ROLLCON_BY_FORCE, 8e4));
  must(rollcon_contact_create(s.context, s.plain, s.plain, &s.contact));
  must(rollcon_contact_set_gap_quadratic(s.contact, 0.001, 0.001, 0));
  must(rollcon_contact_set_friction(s.contact, "coulomb", 1, &mu));
  must(rollcon_contact_frame_rectangle(s.contact, ROLLCON_QUAD4, 12, 12, -8, 8, -8, 8));
  must(rollcon_contact_prescribe(s.contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, 8e4));
  return s;
}

static void release(scene* s) {
  rollcon_contact_release(s->contact);
  rollcon_wheelrail_release(s->position);
  rollcon_body_release(s->wheel);
  rollcon_body_release(s->rail);
  rollcon_body_release(s->plain);
  rollcon_context_release(s->context);
}

/* Fills creepages; the last case is one of the others again, and the last but one has no contact. */
static void fill_cases(double (*value)[2]) {
  int k;
  for (k = 0; k < CASES; ++k) {
    value[k][0] = -0.0004 * (k % 5);
    value[k][1] = 8e4 + 1e3 * (k / 5);
  }
  value[CASES - 2][1] = 0;
  memcpy(value[CASES - 1], value[3], sizeof value[3]);
}

static int32_t solve_cases(const scene* s, int n, double* result, int32_t* status) {
  double value[CASES][2];
  int64_t width;
  fill_cases(value);
  return rollcon_contact_solve_many(s->contact, "longitudinal normal", n, value[0], "force approach", WIDTH, result,
                                    &width, status);
}

static void cases_are_those_of_one_rank(const scene* alone, const scene* shared) {
  double result[2][CASES * WIDTH];
  int32_t status[2][CASES], worst[2];
  memset(result, 0, sizeof result);
  worst[0] = solve_cases(alone, CASES, result[0], status[0]);
  worst[1] = solve_cases(shared, CASES, result[1], status[1]);
  expect(worst[0] == ROLLCON_NO_CONTACT && worst[1] == worst[0], "the worst status of cases");
  expect(same(result[0], result[1], sizeof result[0]), "results of cases");
  expect(same(status[0], status[1], sizeof status[0]), "statuses of cases");
}

static void positions_are_those_of_one_rank(const scene* alone, const scene* shared) {
  double position[POSITIONS][6], velocity[POSITIONS][6], total[2][POSITIONS * 2], worn[2][2 * POINTS + 2];
  const double i = 1e-9;
  int32_t status[2][POSITIONS], worst[2];
  int k;
  memset(position, 0, sizeof position);
  memset(velocity, 0, sizeof velocity);
  for (k = 0; k < POSITIONS; ++k) {
    position[k][1] = 1.5 * k;
    velocity[k][0] = 20e3, velocity[k][5] = -43.5;
  }
  for (k = 0; k < 2; ++k) {
    const scene* s = k == 0 ? alone : shared;
    worst[k] = rollcon_wheelrail_solve_many(s->position, POSITIONS, position[0], velocity[0], "force_y force_z",
                                            total[k], status[k]);
    must(rollcon_wheelrail_find_wear(s->position, POSITIONS, position[0], velocity[0], NULL, "archard", 1, &i, POINTS,
                                     worn[k], worn[k] + POINTS, worn[k] + 2 * POINTS, NULL));
  }
  expect(worst[0] >= 0 && worst[1] == worst[0], "the worst status of positions");
  expect(same(total[0], total[1], sizeof total[0]) && fabs(total[0][1]) > 1e3, "totals of positions");
  expect(same(status[0], status[1], sizeof status[0]), "statuses of positions");
  expect(same(worn[0], worn[1], sizeof worn[0]) && worn[0][2 * POINTS] > 0, "wear");
}

static rollcon_table* coarse_table(const scene* s) {
  rollcon_table* table;
  must(rollcon_table_create(s->context, &table));
  must(rollcon_table_set_ratios(table, 4, 0.5, 2));
  must(rollcon_table_set_resolution(table, 4, 4, 4));
  must(rollcon_table_set_frame(table, 6, 6));
  return table;
}

static void tables_are_those_of_one_rank(const scene* alone, const scene* shared) {
  rollcon_table* table[2];
  double* sample[2];
  int64_t count[2];
  int k;
  for (k = 0; k < 2; ++k) {
    table[k] = coarse_table(k == 0 ? alone : shared);
    must(rollcon_table_make(table[k], 0, 2)); /* in two parts, one after the other */
    must(rollcon_table_make(table[k], 1, 2));
    must(rollcon_table_get_samples(table[k], 0, NULL, &count[k]));
    sample[k] = malloc((size_t)count[k] * sizeof *sample[k]);
    if (!sample[k]) MPI_Abort(MPI_COMM_WORLD, 2);
    must(rollcon_table_get_samples(table[k], count[k], sample[k], &count[k]));
  }
  expect(same(sample[0], sample[1], (size_t)count[0] * sizeof *sample[0]), "samples of a table");
  for (k = 0; k < 2; ++k) {
    free(sample[k]);
    rollcon_table_release(table[k]);
  }
}

/* The last rank gives no room for results; it and all others fail. */
static void what_fails_on_one_rank_fails_on_all(const scene* shared) {
  double result[CASES * WIDTH], value[CASES][2];
  char number[24];
  int32_t status;
  int64_t width;
  fill_cases(value);
  snprintf(number, sizeof number, "rank %d: ", ranks - 1);
  status =
      rollcon_contact_solve_many(shared->contact, "longitudinal normal", CASES, rank == ranks - 1 ? NULL : value[0],
                                 "force approach", WIDTH, result, &width, NULL);
  expect(status == ROLLCON_ERR_ARGUMENT && strstr(rollcon_last_error(), "values"), "a rank that fails");
  if (rank != ranks - 1) expect(strstr(rollcon_last_error(), number) != NULL, "the number of the rank that fails");
}

static void unlike_calls_are_refused(const scene* shared) {
  double result[CASES * WIDTH];
  const int32_t status = solve_cases(shared, rank == 0 ? CASES - 1 : CASES, result, NULL);
  if (ranks > 1) expect(status == ROLLCON_ERR_STATE && strstr(rollcon_last_error(), "unlike"), "unlike calls");
}

static int32_t stop(const rollcon_event* event, void* user) {
  (void)event;
  (void)user;
  return 1;
}

/* Rank 0 stops at its first case; the others solve theirs. */
static void cases_of_a_rank_that_stops_are_cancelled(const scene* shared) {
  double result[CASES * WIDTH];
  int32_t status[CASES];
  int k, solved = 0, cancelled = 0;
  if (rank == 0) must(rollcon_contact_set_progress(shared->contact, stop, NULL));
  expect(solve_cases(shared, CASES, result, status) == ROLLCON_CANCELLED, "a rank that stops");
  if (rank == 0) must(rollcon_contact_set_progress(shared->contact, NULL, NULL));
  for (k = 0; k < CASES; ++k) {
    solved += status[k] == ROLLCON_OK && result[k * WIDTH + 2] < 0;
    cancelled += status[k] == ROLLCON_CANCELLED && isnan(result[k * WIDTH + 2]);
  }
  expect(cancelled > 0 && (ranks == 1 || solved > 0), "cases solved and cancelled");
}

static void tables_stop_on_all_ranks_and_go_on(const scene* shared) {
  rollcon_table* table = coarse_table(shared);
  must(rollcon_table_set_progress(table, rank == 0 ? stop : NULL, NULL));
  expect(rollcon_table_make(table, 0, 1) == ROLLCON_CANCELLED, "a table that stops");
  must(rollcon_table_set_progress(table, NULL, NULL));
  expect(rollcon_table_make(table, 0, 1) == ROLLCON_OK, "a table that goes on");
  rollcon_table_release(table);
}

int main(int argc, char** argv) {
  scene alone, shared;
  MPI_Init(&argc, &argv);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  alone = make_scene(0);
  shared = make_scene(1);
  expect(rollcon_context_set_communicator(alone.context, (int32_t)MPI_Comm_c2f(MPI_COMM_NULL)) == ROLLCON_ERR_ARGUMENT,
         "no communicator");
  cases_are_those_of_one_rank(&alone, &shared);
  positions_are_those_of_one_rank(&alone, &shared);
  tables_are_those_of_one_rank(&alone, &shared);
  what_fails_on_one_rank_fails_on_all(&shared);
  unlike_calls_are_refused(&shared);
  cases_of_a_rank_that_stops_are_cancelled(&shared);
  tables_stop_on_all_ranks_and_go_on(&shared);
  cases_are_those_of_one_rank(&alone, &shared);
  release(&alone);
  release(&shared);
  MPI_Allreduce(MPI_IN_PLACE, &failures, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
  MPI_Finalize();
  return failures > 0;
}
