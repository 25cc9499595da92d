/* Makes contact frames on a disc around the origin, for the examples: triangles on rings of nodes, or quadrilaterals on
   a square core with rings around it; linear or quadratic. */
#ifndef DISC_FRAMES_H
#define DISC_FRAMES_H

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "rollcon.h"

enum { MOST_NODES = 2745, MOST_ELEMENTS = 1340 };

typedef struct {
  int32_t type;    /* ROLLCON_TRI3, TRI6, QUAD4 or QUAD8 */
  int corners;     /* corners of an element */
  int per_element; /* nodes of an element: corners, then midside nodes */
  int nodes, elements;
  double x[MOST_NODES][3];
  int32_t id[MOST_ELEMENTS * 8]; /* nodes of the elements, one element after the other */
} disc_frame;

static void add_node(disc_frame* f, double x, double y) {
  f->x[f->nodes][0] = x;
  f->x[f->nodes][1] = y;
  f->x[f->nodes++][2] = 0;
}

static void add_corners(disc_frame* f, int a, int b, int c, int d) {
  int32_t* id = f->id + f->elements++ * f->corners;
  id[0] = a;
  id[1] = b;
  id[2] = c;
  if (f->corners == 4) id[3] = d;
}

/* Makes 703 nodes, 1340 triangles, 64 of their edges on the rim. Neighbouring rings are out of step, so no line of
   nodes follows the rolling direction. */
static void triangle_disc(disc_frame* f, double radius) {
  static const int count[] = {1, 6, 12, 18, 24, 30, 36, 42, 48, 48, 54, 64, 64, 64, 64, 64, 64};
  const int rings = (int)(sizeof count / sizeof count[0]) - 1;
  const double turn = 2 * acos(-1.0);
  double inner_phase = 0;
  int inner = 0, ring, i, j;
  add_node(f, 0, 0);
  for (ring = 1; ring <= rings; ++ring) {
    const int ni = count[ring - 1], no = count[ring], outer = f->nodes;
    const double r = radius * ring / rings;
    const double phase = fmod(inner_phase + 0.5 / no, 1.0 / no);
    for (i = 0; i < no; ++i)
      add_node(f, r * cos(turn * (phase + (double)i / no)), r * sin(turn * (phase + (double)i / no)));
    /* Walk round both rings; each step takes the next node of the ring that lags behind. */
    for (i = j = 0; i < no || (ni > 1 && j < ni);) {
      const int a = inner + j % ni, b = outer + i % no;
      const double next_inner = inner_phase + (j + 1.0) / ni, next_outer = phase + (i + 1.0) / no;
      if (ni == 1 || j == ni || (i < no && next_outer < next_inner)) {
        add_corners(f, a, b, outer + ++i % no, 0);
      } else {
        add_corners(f, a, b, inner + ++j % ni, 0);
      }
    }
    inner = outer;
    inner_phase = phase;
  }
}

/* Makes 673 nodes, 640 quadrilaterals: 16 x 16 in the core, 6 rings of 64 around it. */
static void quad_disc(disc_frame* f, double radius) {
  enum { SIDE = 16, RIM = 4 * SIDE, RINGS = 6 };
  int rim[RIM], i, j, k, n = 0;
  for (j = 0; j <= SIDE; ++j)
    for (i = 0; i <= SIDE; ++i) {
      const double u = 2.0 * i / SIDE - 1, v = 2.0 * j / SIDE - 1;
      add_node(f, 0.6 * radius * u * sqrt(1 - v * v / 4), 0.6 * radius * v * sqrt(1 - u * u / 4));
      if (i < SIDE && j < SIDE) {
        k = j * (SIDE + 1) + i;
        add_corners(f, k, k + 1, k + SIDE + 2, k + SIDE + 1);
      }
    }
  for (i = 0; i < SIDE; ++i) rim[n++] = i;
  for (i = 0; i < SIDE; ++i) rim[n++] = i * (SIDE + 1) + SIDE;
  for (i = SIDE; i > 0; --i) rim[n++] = SIDE * (SIDE + 1) + i;
  for (i = SIDE; i > 0; --i) rim[n++] = i * (SIDE + 1);
  for (k = 1; k <= RINGS; ++k) {
    const int first = f->nodes;
    for (i = 0; i < RIM; ++i) {
      const double *core = f->x[rim[i]], angle = 0.5 * acos(-1.0) * ((double)i / SIDE - 0.5);
      const double t = (double)k / RINGS;
      const int a = k == 1 ? rim[i] : first - RIM + i, m = (i + 1) % RIM;
      add_node(f, core[0] + t * (radius * sin(angle) - core[0]), core[1] + t * (-radius * cos(angle) - core[1]));
      add_corners(f, a, first + i, first + m, k == 1 ? rim[m] : first - RIM + m);
    }
  }
}

/* Adds a node in the middle of every edge. */
static void add_midside_nodes(disc_frame* f) {
  static int32_t old[MOST_ELEMENTS * 4], edge[MOST_NODES][2];
  const int corners = f->corners, linear_nodes = f->nodes;
  int e, i, k;
  memcpy(old, f->id, sizeof old[0] * (size_t)(f->elements * corners));
  f->per_element = 2 * corners;
  for (e = 0; e < f->elements; ++e) {
    int32_t* id = f->id + e * f->per_element;
    for (i = 0; i < corners; ++i) {
      const int32_t a = old[e * corners + i], b = old[e * corners + (i + 1) % corners];
      id[i] = a;
      for (k = linear_nodes; k < f->nodes; ++k)
        if (edge[k][0] == b && edge[k][1] == a) break;
      if (k == f->nodes) {
        edge[k][0] = a;
        edge[k][1] = b;
        add_node(f, 0.5 * (f->x[a][0] + f->x[b][0]), 0.5 * (f->x[a][1] + f->x[b][1]));
      }
      id[corners + i] = k;
    }
  }
}

/* Takes as name tri3, tri6, quad4 or quad8. Returns 0 for another one. */
static int make_disc_frame(disc_frame* f, const char* name, double radius) {
  static const struct {
    const char* name;
    int32_t type;
  } types[] = {{"tri3", ROLLCON_TRI3}, {"tri6", ROLLCON_TRI6}, {"quad4", ROLLCON_QUAD4}, {"quad8", ROLLCON_QUAD8}};
  int i;
  for (i = 0; i < 4; ++i) {
    if (strcmp(name, types[i].name) != 0) continue;
    f->type = types[i].type;
    f->corners = f->per_element = i < 2 ? 3 : 4;
    f->nodes = f->elements = 0;
    if (f->corners == 3) {
      triangle_disc(f, radius);
    } else {
      quad_disc(f, radius);
    }
    if (i % 2 == 1) add_midside_nodes(f);
    return 1;
  }
  return 0;
}

#endif
