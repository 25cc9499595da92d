/* A ring of rectangular section around the y axis, or a sector of it, with a fine zone at its top
   (x = 0, z = outer radius). Tags: 1 outer surface outside the zone, 2 zone, 3 inner surface (hub),
   4 and 5 the sides at y < 0 and y > 0, 6 and 7 the cut faces of a sector at x < 0 and x > 0. */
#ifndef RING_MESH_H
#define RING_MESH_H

#include "body_mesh.h"

typedef struct {
  double inner, outer, width; /* radii, length along the axis */
  double sector;              /* angle that is meshed, symmetric about the top; 0: full circle */
  double zone;                /* length of the zone along the circumference; full width */
  int around, zone_around;    /* elements along the circumference: in all, in the zone */
  int across, deep;           /* elements along the axis, and from the hub outwards */
  double largest;             /* element on the outer circumference; 0: no bound */
  double top_layer;           /* depth of the outermost elements of the sides; 0: all equal */
  double side_grading;        /* 0: equal elements across, 1: cosine, finer towards the sides */
} ring_shape;

/* Returns the ring of the paper's first example: 1472 nodes, 1472 quadrilaterals, 12 x 12 of them in the
   zone. (The paper counts 1474 nodes, which a sector has: sector = pi, around = 32, deep = 8.) */
static ring_shape paper_ring(void) {
  ring_shape r;
  r.inner = 25;
  r.outer = 50;
  r.width = 8;
  r.sector = 0;
  r.zone = 2.4;
  r.around = 46;
  r.zone_around = 12;
  r.across = 12;
  r.deep = 4;
  r.largest = 16;
  r.top_layer = 1.2;
  r.side_grading = 0;
  return r;
}

/* Takes as q the angle from the top, y, and the radius. */
static void ring_position(const double q[3], const void* shape, double x[3]) {
  (void)shape;
  x[0] = q[2] * sin(q[0]);
  x[1] = q[1];
  x[2] = q[2] * cos(q[0]);
}

/* Takes as type ROLLCON_QUAD4, QUAD8, QUAD9, or for a solid HEX8, HEX20; all nodes of the surface lie on the
   ring itself. Returns 0 when there is not enough memory. */
static int make_ring_mesh(body_mesh* m, const ring_shape* r, int32_t type) {
  static const int32_t tag[6] = {6, 7, 4, 5, 3, 1};
  const double pi = acos(-1.0), depth = r->outer - r->inner;
  double* line = (double*)malloc((size_t)(r->around + r->across + r->deep + 3) * sizeof *line);
  double *y, *radius;
  body_grid g;
  int k, made;
  if (line == NULL) return 0;
  y = line + r->around + 1;
  radius = y + r->across + 1;
  lines_with_zone(line, r->around, r->sector > 0 ? r->sector / 2 : pi, r->zone_around, r->zone / 2 / r->outer,
                  r->largest / r->outer);
  for (k = 0; k <= r->across; ++k) {
    const double t = 2.0 * k / r->across - 1;
    y[k] = r->width / 2 * (t + r->side_grading * (sin(pi / 2 * t) - t));
  }
  graded_lines(radius, r->deep, r->outer, r->inner, r->top_layer > 0 ? r->top_layer : depth / r->deep, 0);
  reverse_lines(radius, r->deep);
  g.n[0] = r->around;
  g.n[1] = r->across;
  g.n[2] = r->deep;
  g.line[0] = line;
  g.line[1] = y;
  g.line[2] = radius;
  g.ring = r->sector <= 0;
  for (k = 0; k < 6; ++k) g.face_tag[k] = tag[k];
  g.zone_from[0] = (r->around - r->zone_around) / 2;
  g.zone_to[0] = g.zone_from[0] + r->zone_around;
  g.zone_from[1] = 0;
  g.zone_to[1] = r->across;
  g.zone_tag = 2;
  g.position = ring_position;
  g.shape = r;
  made = make_grid_mesh(m, &g, type);
  free(line);
  return made;
}

#endif
