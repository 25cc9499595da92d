/* Factorises a finite-element body on all ranks of MPI together: its contact is that of a body which each rank
   factorises by itself, within rounding, and the same to the bit on all ranks; what fails on one rank fails on all.
   shared_factors N makes the block N elements wide instead, and prints what each rank takes for it. */
#include <math.h>
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "rollcon.h"

enum { TOP = 2, FRAME = 6, NODES = (FRAME + 1) * (FRAME + 1) };

static int rank, ranks, failures, wide = 12;

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

static void* room(size_t count, size_t bytes) {
  void* made = malloc(count * bytes);
  if (!made) MPI_Abort(MPI_COMM_WORLD, 2);
  return made;
}

static int32_t node(int i, int j, int k) {
  return (int32_t)((k * (wide + 1) + j) * (wide + 1) + i);
}

/* Makes a cube of hex8, held at its bottom, whose middle faces of the top, 6 by 6, may come into contact. */
static void make_block(rollcon_body* body, double young) {
  const int side = wide + 1, first = wide / 2 - FRAME / 2;
  const int32_t top_tag = TOP;
  double* x = room((size_t)side * side * side, 3 * sizeof *x);
  int32_t* element = room((size_t)wide * wide * wide, 8 * sizeof *element);
  int32_t* held = room((size_t)side * side, sizeof *held);
  int32_t top[NODES];
  int i, j, k, c, n = 0;
  for (k = 0; k < side; ++k)
    for (j = 0; j < side; ++j)
      for (i = 0; i < side; ++i) {
        double* at = x + 3 * (size_t)node(i, j, k);
        at[0] = i - 0.5 * wide, at[1] = j - 0.5 * wide, at[2] = k - wide;
      }
  for (k = 0; k < wide; ++k)
    for (j = 0; j < wide; ++j)
      for (i = 0; i < wide; ++i)
        for (c = 0; c < 8; ++c) element[n++] = node(i + (c % 4 == 1 || c % 4 == 2), j + (c % 4 > 1), k + c / 4);
  for (n = 0; n < side * side; ++n) held[n] = n;
  for (n = 0; n < NODES; ++n) top[n] = node(first + n % (FRAME + 1), first + n / (FRAME + 1), wide);
  must(rollcon_body_set_nodes(body, (int64_t)side * side * side, x, 3, 1));
  must(rollcon_body_add_elements(body, ROLLCON_HEX8, (int64_t)wide * wide * wide, element, 0, 1));
  if (young > 0) must(rollcon_body_set_elastic(body, 1, young, 0.3));
  must(rollcon_body_set_support(body, side * side, held, 0, ROLLCON_DOF_XYZ, NULL));
  must(rollcon_body_tag_faces_of_nodes(body, NODES, top, 0, TOP));
  must(rollcon_body_set_contact_faces(body, 1, &top_tag));
  must(rollcon_body_set_int(body, "factor_ranks", 1));
  free(x), free(element), free(held);
}

typedef struct {
  rollcon_context* context;
  rollcon_body* block;
} scene;

static scene make_scene(int shared, double young) {
  scene s;
  must(rollcon_context_create(ROLLCON_ABI, &s.context));
  must(rollcon_context_set_threads(s.context, 1));
  if (shared) must(rollcon_context_set_communicator(s.context, (int32_t)MPI_Comm_c2f(MPI_COMM_WORLD)));
  must(rollcon_body_create(s.context, ROLLCON_BODY_FEM, &s.block));
  make_block(s.block, young);
  return s;
}

static void release(scene* s) {
  rollcon_body_release(s->block);
  rollcon_context_release(s->context);
}

static double statistic(const rollcon_body* body, const char* name) {
  double value;
  must(rollcon_body_get_stat(body, name, &value));
  return value;
}

/* Presses a rigid ball on the block, with friction and creepage. */
static void press(const scene* s, double traction[NODES][3]) {
  const double mu = 0.3;
  rollcon_body* ball;
  rollcon_contact* contact;
  must(rollcon_body_create(s->context, ROLLCON_BODY_RIGID, &ball));
  must(rollcon_contact_create(s->context, s->block, ball, &contact));
  must(rollcon_contact_frame_rectangle(contact, ROLLCON_QUAD4, FRAME, FRAME, -2.5, 2.5, -2.5, 2.5));
  must(rollcon_contact_set_gap_quadratic(contact, 1 / 400.0, 1 / 400.0, 0));
  must(rollcon_contact_set_friction(contact, "coulomb", 1, &mu));
  must(rollcon_contact_set_rolling(contact, 10));
  must(rollcon_contact_set_creep(contact, 1e-3, 5e-4, 0));
  must(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, 500));
  must(rollcon_contact_solve(contact));
  must(rollcon_contact_get_tractions(contact, ROLLCON_LOCAL, NODES, traction[0]));
  rollcon_contact_release(contact);
  rollcon_body_release(ball);
}

static void contacts_are_those_of_one_rank(void) {
  double t[2][NODES][3], first[NODES][3], error = 0, size = 0;
  scene alone = make_scene(0, 1e4), shared = make_scene(1, 1e4);
  int k, c;
  must(rollcon_body_prepare(alone.block));
  must(rollcon_body_prepare(shared.block));
  press(&alone, t[0]);
  press(&shared, t[1]);
  memcpy(first, t[1], sizeof first);
  MPI_Bcast(first, NODES * 3, MPI_DOUBLE, 0, MPI_COMM_WORLD);
  expect(memcmp(first, t[1], sizeof first) == 0, "the bits of rank 0");
  for (k = 0; k < NODES; ++k)
    for (c = 0; c < 3; ++c) {
      error = fmax(error, fabs(t[1][k][c] - t[0][k][c]));
      size = fmax(size, fabs(t[0][k][c]));
    }
  printf("rank %d of %d: tractions beside those of one rank: %.1e, bound 1e-12\n", rank, ranks, error / size);
  expect(size > 1 && error <= 1e-12 * size, "tractions");
  expect(statistic(shared.block, "factorizations") == 1, "one factorisation");
  expect(fabs(log(statistic(shared.block, "condition") / statistic(alone.block, "condition"))) < 1, "condition");
  release(&alone);
  release(&shared);
}

/* The last rank has no material; it and all others fail, and all succeed once it has one. */
static void what_fails_on_one_rank_fails_on_all(void) {
  char number[24];
  const int last = rank == ranks - 1;
  scene shared = make_scene(1, last ? 0 : 1e4);
  snprintf(number, sizeof number, "rank %d: ", ranks - 1);
  expect(rollcon_body_prepare(shared.block) == ROLLCON_ERR_STATE, "a rank that fails");
  if (!last) expect(strstr(rollcon_last_error(), number) != NULL, "the number of the rank that fails");
  must(rollcon_body_set_elastic(shared.block, 1, 1e4, 0.3));
  expect(rollcon_body_prepare(shared.block) == ROLLCON_OK, "all ranks go on");
  release(&shared);
}

static void tell_cost(void) {
  scene shared = make_scene(1, 1e4);
  double began;
  MPI_Barrier(MPI_COMM_WORLD);
  began = MPI_Wtime();
  must(rollcon_body_prepare(shared.block));
  printf("rank %d of %d: %.0f unknowns, %.2f s, most bytes %.3f GB\n", rank, ranks, statistic(shared.block, "unknowns"),
         MPI_Wtime() - began, 1e-9 * statistic(shared.block, "peak_bytes"));
  release(&shared);
}

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  if (argc > 1) {
    wide = atoi(argv[1]);
    tell_cost();
  } else {
    contacts_are_those_of_one_rank();
    what_fails_on_one_rank_fails_on_all();
  }
  MPI_Allreduce(MPI_IN_PLACE, &failures, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
  MPI_Finalize();
  return failures > 0;
}
