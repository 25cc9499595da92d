/* Makes meshes of bodies for the examples: a block that is divided like a grid and then bent into a ring, the rim of a
   wheel, ...: its surface alone, or filled with hexahedra. */
#ifndef BODY_MESH_H
#define BODY_MESH_H

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "rollcon.h"

enum { MOST_TAGS = 16 };

/* Elements come in the order of their tags: those of tag t are first[t] to first[t + 1] - 1. */
typedef struct {
  int32_t type;    /* ROLLCON_QUAD4, QUAD8 or QUAD9 */
  int per_element; /* nodes of an element: corners, then midside nodes, then the centre */
  int nodes, elements;
  double (*x)[3];
  int32_t* id; /* nodes of the elements, one element after the other; normals point outwards */
  int first[MOST_TAGS + 1];
  int32_t solid_type; /* type of the inside: ROLLCON_HEX8 or HEX20; 0: the surface alone */
  int per_cell, cells;
  int32_t* cell; /* nodes of the hexahedra; NULL: none */
} body_mesh;

/* Describes what is meshed. The block is [line[0][0], line[0][n[0]]] x ... in coordinates q. */
typedef struct {
  int n[3];                     /* elements along q[0], q[1], q[2] */
  const double* line[3];        /* n + 1 ascending values of each */
  int ring;                     /* nonzero: q[0] runs full circle, its last line is the first one */
  int32_t face_tag[6];          /* 1 to MOST_TAGS - 1, for q[0] least, q[0] most, q[1] least, ... */
  int zone_from[2], zone_to[2]; /* elements of the last face, q[2] most, that have a tag of */
  int32_t zone_tag;             /* their own; from 0 to 0: none */
  /* Gives the position of q; right-handed. Midside nodes lie at the middle of their corners' q. */
  void (*position)(const double q[3], const void* shape, double x[3]);
  const void* shape;
} body_grid;

static void free_body_mesh(body_mesh* m) {
  free(m->x);
  free(m->id);
  free(m->cell);
  m->x = NULL;
  m->id = m->cell = NULL;
  m->nodes = m->elements = m->cells = 0;
}

/* Returns q[axis] on half line h: on line h / 2, or between two lines. */
static double on_half_line(const body_grid* g, int axis, int h) {
  const double* line = g->line[axis];
  return 0.5 * (line[h / 2] + line[(h + 1) / 2]);
}

/* Returns the node at a point of the grid of half lines; a new one unless it is there already. */
static int32_t grid_node(body_mesh* m, const body_grid* g, int32_t* known, const int at[3]) {
  const int turn = g->ring && at[0] == 2 * g->n[0] ? 0 : at[0];
  const size_t place =
      ((size_t)turn * (size_t)(2 * g->n[1] + 1) + (size_t)at[1]) * (size_t)(2 * g->n[2] + 1) + (size_t)at[2];
  if (known[place] == 0) {
    double q[3];
    q[0] = on_half_line(g, 0, turn);
    q[1] = on_half_line(g, 1, at[1]);
    q[2] = on_half_line(g, 2, at[2]);
    g->position(q, g->shape, m->x[m->nodes]);
    known[place] = ++m->nodes;
  }
  return known[place] - 1;
}

static int32_t grid_tag(const body_grid* g, int face, int i, int j) {
  const int in_zone =
      face == 5 && i >= g->zone_from[0] && i < g->zone_to[0] && j >= g->zone_from[1] && j < g->zone_to[1];
  return in_zone ? g->zone_tag : g->face_tag[face];
}

/* Adds the element of `face` at row i, column j of the grid on it. */
static void add_grid_element(body_mesh* m, const body_grid* g, int32_t* known, int face, int i, int j) {
  static const int corner_first[9][2] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {2, 1}, {1, 2}, {0, 1}, {1, 1}};
  const int axis = face / 2, most = face % 2;
  const int p = (axis + 1) % 3, q = (axis + 2) % 3;
  int32_t* id = m->id + m->elements++ * m->per_element;
  int k, at[3];
  at[axis] = most ? 2 * g->n[axis] : 0;
  for (k = 0; k < m->per_element; ++k) {
    /* The directions p and q change places between opposite faces, seen from outside the block. */
    at[p] = 2 * i + corner_first[k][most ? 0 : 1];
    at[q] = 2 * j + corner_first[k][most ? 1 : 0];
    id[k] = grid_node(m, g, known, at);
  }
}

/* Adds the hexahedron at place i of the grid. */
static void add_grid_cell(body_mesh* m, const body_grid* g, int32_t* known, const int i[3]) {
  static const int place[20][3] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2},
                                   {0, 2, 2}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}, {1, 0, 2}, {2, 1, 2},
                                   {1, 2, 2}, {0, 1, 2}, {0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}};
  int32_t* id = m->cell + m->cells++ * m->per_cell;
  int k, c, at[3];
  for (k = 0; k < m->per_cell; ++k) {
    for (c = 0; c < 3; ++c) at[c] = 2 * i[c] + place[k][c];
    id[k] = grid_node(m, g, known, at);
  }
}

static void fill_grid(body_mesh* m, const body_grid* g, int32_t* known) {
  int i[3];
  for (i[0] = 0; i[0] < g->n[0]; ++i[0])
    for (i[1] = 0; i[1] < g->n[1]; ++i[1])
      for (i[2] = 0; i[2] < g->n[2]; ++i[2]) add_grid_cell(m, g, known, i);
}

/* Takes as type ROLLCON_QUAD4, QUAD8 or QUAD9 for the surface alone, ROLLCON_HEX8 or HEX20 for a solid, whose surface
   is meshed by QUAD4 or QUAD8. Returns 0 when there is not enough memory. */
static int make_grid_mesh(body_mesh* m, const body_grid* g, int32_t type) {
  const int* n = g->n;
  const int solid = type == ROLLCON_HEX8 || type == ROLLCON_HEX20;
  const size_t most_elements =
      2 * ((size_t)n[0] * (size_t)n[1] + (size_t)n[1] * (size_t)n[2] + (size_t)n[2] * (size_t)n[0]);
  const size_t points = (size_t)(2 * n[0] + 1) * (size_t)(2 * n[1] + 1) * (size_t)(2 * n[2] + 1);
  const size_t most_cells = solid ? (size_t)n[0] * (size_t)n[1] * (size_t)n[2] : 0;
  int32_t* known = (int32_t*)calloc(points, sizeof *known);
  int tag, face, i, j;
  m->type = type == ROLLCON_HEX8 ? ROLLCON_QUAD4 : type == ROLLCON_HEX20 ? ROLLCON_QUAD8 : type;
  m->per_element = m->type == ROLLCON_QUAD4 ? 4 : m->type == ROLLCON_QUAD8 ? 8 : 9;
  m->solid_type = solid ? type : 0;
  m->per_cell = type == ROLLCON_HEX8 ? 8 : 20;
  m->nodes = m->elements = m->cells = 0;
  m->x = (double(*)[3])malloc((solid ? points : 4 * most_elements + 2) * sizeof *m->x);
  m->id = (int32_t*)malloc(most_elements * (size_t)m->per_element * sizeof *m->id);
  m->cell = solid ? (int32_t*)malloc(most_cells * (size_t)m->per_cell * sizeof *m->cell) : NULL;
  if (known == NULL || m->x == NULL || m->id == NULL || (solid && m->cell == NULL)) {
    free(known);
    free_body_mesh(m);
    return 0;
  }
  for (tag = 0; tag < MOST_TAGS; ++tag) {
    m->first[tag] = m->elements;
    for (face = g->ring ? 2 : 0; face < 6; ++face)
      for (i = 0; i < n[(face / 2 + 1) % 3]; ++i)
        for (j = 0; j < n[(face / 2 + 2) % 3]; ++j)
          if (grid_tag(g, face, i, j) == tag) add_grid_element(m, g, known, face, i, j);
  }
  m->first[MOST_TAGS] = m->elements;
  if (solid) fill_grid(m, g, known);
  free(known);
  return 1;
}

/* Lists the nodes of the elements of a tag, ascending; list has room for all nodes. Returns their number. */
static int nodes_of_tag(const body_mesh* m, int tag, int32_t* list) {
  const int32_t* end = m->id + m->first[tag + 1] * m->per_element;
  const int32_t* id;
  int k, count = 0;
  for (k = 0; k < m->nodes; ++k) list[k] = 0;
  for (id = m->id + m->first[tag] * m->per_element; id != end; ++id) list[*id] = 1;
  for (k = 0; k < m->nodes; ++k)
    if (list[k]) list[count++] = k;
  return count;
}

/* Sets line[0] = from, ..., line[n] = to. The first step has the size `first`, the others grow by one factor but not
   beyond `largest` (0: no bound), as far as n steps allow. */
static void graded_lines(double* line, int n, double from, double to, double first, double largest) {
  const double length = fabs(to - from), toward = to > from ? 1 : -1;
  double low = 1e-3, high = 1e3, sum = 0, step;
  int k, i;
  if (largest <= 0) largest = length;
  if (n * largest < length) largest = 2 * length / n;
  for (i = 0; i < 200; ++i) {
    const double factor = sqrt(low * high);
    for (k = 0, sum = 0, step = first; k < n; ++k, step *= factor) sum += step < largest ? step : largest;
    if (sum < length) {
      low = factor;
    } else {
      high = factor;
    }
  }
  line[0] = from;
  for (k = 0, step = first; k < n; ++k, step *= high)
    line[k + 1] = line[k] + toward * (length / sum) * (step < largest ? step : largest);
  line[n] = to;
}

static void reverse_lines(double* line, int n) {
  int k;
  for (k = 0; k < n - k; ++k) {
    const double swap = line[k];
    line[k] = line[n - k];
    line[n - k] = swap;
  }
}

/* Sets n steps from -half to half, zone_n equal ones of them from -half_zone to half_zone. */
static void lines_with_zone(double* line, int n, double half, int zone_n, double half_zone, double largest) {
  const int before = (n - zone_n) / 2, after = n - zone_n - before;
  const double step = 2 * half_zone / zone_n;
  int k;
  if (before > 0) graded_lines(line, before, -half_zone, -half, step, largest);
  reverse_lines(line, before);
  for (k = 0; k <= zone_n; ++k) line[before + k] = -half_zone + k * step;
  line[before + zone_n] = half_zone;
  if (after > 0) graded_lines(line + before + zone_n, after, half_zone, half, step, largest);
}

#endif
