/* A first body of finite elements in C: a rigid ball rolls over a soft layer on a stiffer base and
   transmits 60 % of the force at which it would slide. The frame of the contact is a mesh of its
   own that does not match the block's. Units: mm, N, MPa. fem_block.f90 and fem_block.py print the
   same. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "rollcon.h"

/* The block has nodes i, j, k along x, y, z, 1 mm apart; its top is z = 0. */
enum { NX = 17, NY = 17, NZ = 9, NODES = NX * NY * NZ, LAYER = (NX - 1) * (NY - 1) };
/* The frame is a square in the middle of the top. */
enum { ALONG = 12, FRAME_NODES = (ALONG + 1) * (ALONG + 1) }; /* elements along each side */
enum { BASE = 1, TREAD = 2 };                                 /* tags of elements: materials */
enum { TOP = 1 };                                             /* tag of faces */

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

static int32_t node(int i, int j, int k) {
  return (int32_t)((k * NY + j) * NX + i);
}

/* Lists layer k of the block: bottom face counter-clockwise seen from above, then the top face. */
static void hexahedra(int k, int32_t id[LAYER][8]) {
  static const int corner[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  int i, j, c;
  for (j = 0; j + 1 < NY; ++j)
    for (i = 0; i + 1 < NX; ++i)
      for (c = 0; c < 8; ++c) id[j * (NX - 1) + i][c] = node(i + corner[c % 4][0], j + corner[c % 4][1], k + c / 4);
}

int main(void) {
  const double radius = 200, load = 1500, mu = 0.3, speed = 10, half = 5;
  static double x[NODES][3], t[FRAME_NODES][3];
  static int32_t element[LAYER][8], top[NX * NY], bottom[NX * NY];
  double force[3], approach, creep[3], unknowns, most = 0;
  int32_t state[FRAME_NODES], count[3] = {0, 0, 0}, status;
  int64_t sizes[2];
  int32_t size[2];
  rollcon_body *block, *ball;
  rollcon_contact* contact;
  int i, j, k, n;

  /* Step 1 makes the block: nodes; six layers of elements are the base, two the tread. */
  must(rollcon_context_create(ROLLCON_ABI, &context));
  must(rollcon_body_create(context, ROLLCON_BODY_FEM, &block));
  for (k = 0; k < NZ; ++k)
    for (j = 0; j < NY; ++j)
      for (i = 0; i < NX; ++i) {
        double* at = x[node(i, j, k)];
        at[0] = i - 8;
        at[1] = j - 8;
        at[2] = k - 8;
      }
  must(rollcon_body_set_nodes(block, NODES, &x[0][0], 3, 1));
  for (k = 0; k + 1 < NZ; ++k) {
    hexahedra(k, element);
    must(rollcon_body_add_elements(block, ROLLCON_HEX8, LAYER, &element[0][0], 0, k < 6 ? BASE : TREAD));
  }

  /* Step 2 gives materials by tag, holds the bottom's nodes, and names the faces of contact by the top's nodes. */
  must(rollcon_body_set_elastic(block, BASE, 1e4, 0.3));
  must(rollcon_body_set_elastic(block, TREAD, 2e3, 0.45));
  for (n = 0; n < NX * NY; ++n) {
    bottom[n] = node(n % NX, n / NX, 0);
    top[n] = node(n % NX, n / NX, NZ - 1);
  }
  must(rollcon_body_set_support(block, NX * NY, bottom, 0, ROLLCON_DOF_XYZ, NULL));
  must(rollcon_body_tag_faces_of_nodes(block, NX * NY, top, 0, TOP));
  i = TOP;
  must(rollcon_body_set_contact_faces(block, 1, &i));

  /* Step 3 makes the ball, which is rigid, its shape given as a gap, and the frame: 12 x 12 elements laid on the block,
     about as large as its faces. */
  must(rollcon_body_create(context, ROLLCON_BODY_RIGID, &ball));
  must(rollcon_contact_create(context, block, ball, &contact));
  must(rollcon_contact_frame_rectangle(contact, ROLLCON_QUAD4, ALONG, ALONG, -half, half, -half, half));
  must(rollcon_contact_set_gap_quadratic(contact, 1 / (2 * radius), 1 / (2 * radius), 0));

  /* Step 4 sets friction, speed and loads: the ball is pressed and driven by forces. */
  must(rollcon_contact_set_friction(contact, "coulomb", 1, &mu));
  must(rollcon_contact_set_rolling(contact, speed));
  must(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, load));
  must(rollcon_contact_prescribe(contact, ROLLCON_LONGITUDINAL, ROLLCON_BY_FORCE, 0.6 * mu * load));

  /* Step 5 solves: assembles and factorises the block, condenses it to the frame, then iterates. */
  status = must(rollcon_contact_solve(contact));

  /* Step 6 reads the results. */
  must(rollcon_body_get_size(block, &sizes[0], &sizes[1]));
  must(rollcon_body_get_stat(block, "unknowns", &unknowns));
  must(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, force, NULL));
  must(rollcon_contact_get_motion(contact, &approach, creep));
  must(rollcon_contact_get_tractions(contact, ROLLCON_LOCAL, FRAME_NODES, &t[0][0]));
  must(rollcon_contact_get_node_states(contact, FRAME_NODES, state));
  for (k = 0; k < FRAME_NODES; ++k) {
    if (-t[k][2] > most) most = -t[k][2];
    ++count[state[k]];
  }
  size[0] = (int32_t)sizes[0];
  size[1] = (int32_t)sizes[1];
  print_integers("status", 1, &status);
  print_integers("block", 2, size);
  print_numbers("unknowns", 1, &unknowns);
  print_numbers("force", 3, force);
  print_numbers("approach", 1, &approach);
  print_numbers("creepages", 3, creep);
  print_numbers("max pressure", 1, &most);
  print_integers("open stk slip", 3, count);
  print_numbers("centre", 3, t[FRAME_NODES / 2]);

  rollcon_contact_release(contact);
  rollcon_body_release(ball);
  rollcon_body_release(block);
  rollcon_context_release(context);
  return 0;
}
