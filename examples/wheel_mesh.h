/* Part of a railway wheel around the y axis: a sector of its rim below a tread of any profile, with
   a fine zone at the top (x = 0, z > 0). Tags: 1 tread outside the zone, 2 zone, 3 inner face of
   the rim, 4 and 5 the sides at small and large y, 6 and 7 the cut faces at x < 0 and x > 0. The
   rest of the wheel is stiff against this part: hold 3, 6 and 7. */
#ifndef WHEEL_MESH_H
#define WHEEL_MESH_H

#include "body_mesh.h"

enum { MOST_PROFILE_POINTS = 64 };

typedef struct {
  int points;                             /* points of the tread's profile, 3 to MOST_PROFILE_POINTS */
  double profile[MOST_PROFILE_POINTS][2]; /* y (ascending; the tread reaches from the first to
                                             the last) and radius; a smooth curve between them */
  double inner;                           /* radius of the rim's inner face */
  double sector;                          /* angle that is meshed, symmetric about the top */
  double zone_y, zone_along, zone_across; /* the zone: y of its centre, length, width */
  int along, zone_along_n;                /* elements along the tread: in all, in the zone */
  int across, zone_across_n;              /* elements across the tread: in all, in the zone */
  int deep;                               /* elements from the rim's inner face to the tread */
  double top_layer;                       /* depth of the outermost elements; 0: all equal */
  double bend[MOST_PROFILE_POINTS];       /* set by make_wheel_mesh: second derivatives */
} wheel_shape;

/* Returns a wheel for the paper's fourth example, whose profile is not in its text: a 28-inch wheel (radius 355.6),
   cone 1:20, tread crowned with the radius `crown` (0: none), width 130, rim 60 thick. 1954 nodes,
   1952 quadrilaterals, 14 x 15 of them in the zone of 5.49 x 7. */
static wheel_shape paper_wheel(double crown) {
  wheel_shape w;
  const double radius = 355.6, cone = 0.05, half_width = 65;
  int k;
  w.points = 27;
  for (k = 0; k < w.points; ++k) {
    const double y = half_width * (2.0 * k / (w.points - 1) - 1);
    w.profile[k][0] = y;
    w.profile[k][1] = radius - cone * y - (crown > 0 ? y * y / (2 * crown) : 0);
  }
  w.inner = radius - 60;
  w.sector = 120.0 / radius;
  w.zone_y = 0;
  w.zone_along = 5.49;
  w.zone_across = 7;
  w.along = 28;
  w.zone_along_n = 14;
  w.across = 27;
  w.zone_across_n = 15;
  w.deep = 4;
  w.top_layer = 4;
  return w;
}

/* Computes the second derivatives of a cubic spline whose end pieces are parabolas:
cones and parabolas come out exact, and curvature is continuous everywhere, which contact needs. */
static void bend_profile(wheel_shape* w) {
  double(*p)[2] = w->profile;
  double pivot[MOST_PROFILE_POINTS];
  const int last = w->points - 1;
  int k;
  for (k = 1; k < last; ++k) {
    const double h0 = p[k][0] - p[k - 1][0], h1 = p[k + 1][0] - p[k][0];
    pivot[k] = 2 * (h0 + h1) + (k == 1 ? h0 : 0) + (k == last - 1 ? h1 : 0);
    w->bend[k] = 6 * ((p[k + 1][1] - p[k][1]) / h1 - (p[k][1] - p[k - 1][1]) / h0);
    if (k > 1) {
      pivot[k] -= h0 * h0 / pivot[k - 1];
      w->bend[k] -= h0 / pivot[k - 1] * w->bend[k - 1];
    }
  }
  for (k = last - 1; k >= 1; --k) {
    if (k < last - 1) w->bend[k] -= (p[k + 1][0] - p[k][0]) * w->bend[k + 1];
    w->bend[k] /= pivot[k];
  }
  w->bend[0] = w->bend[1];
  w->bend[last] = w->bend[last - 1];
}

/* Returns the radius of the tread at y; beyond the profile's ends its end pieces go on. Call bend_profile first. */
static double tread_radius(const wheel_shape* w, double y) {
  const double(*p)[2] = w->profile;
  double h, a, b;
  int k = 0;
  while (k < w->points - 2 && y > p[k + 1][0]) ++k;
  h = p[k + 1][0] - p[k][0];
  a = (p[k + 1][0] - y) / h;
  b = 1 - a;
  return a * p[k][1] + b * p[k + 1][1] + h * h / 6 * ((a * a * a - a) * w->bend[k] + (b * b * b - b) * w->bend[k + 1]);
}

/* Takes as q the angle from the top, y, and the height in the rim from 0 to 1. */
static void wheel_position(const double q[3], const void* shape, double x[3]) {
  const wheel_shape* w = (const wheel_shape*)shape;
  const double radius = w->inner + q[2] * (tread_radius(w, q[1]) - w->inner);
  x[0] = radius * sin(q[0]);
  x[1] = q[1];
  x[2] = radius * cos(q[0]);
}

/* Takes as type ROLLCON_QUAD4, QUAD8 or QUAD9; all nodes lie on the wheel itself. Returns 0 when there is
   not enough memory. */
static int make_wheel_mesh(body_mesh* m, wheel_shape* w, int32_t type) {
  static const int32_t tag[6] = {6, 7, 4, 5, 3, 1};
  double* line = (double*)malloc((size_t)(w->along + w->across + w->deep + 3) * sizeof *line);
  double *y, *height;
  const double left = w->profile[0][0], right = w->profile[w->points - 1][0];
  const double y0 = w->zone_y - w->zone_across / 2, y1 = w->zone_y + w->zone_across / 2;
  const int before = (w->across - w->zone_across_n) / 2;
  const double step = w->zone_across / w->zone_across_n;
  double top, radius;
  body_grid g;
  int k, made;
  if (line == NULL) return 0;
  y = line + w->along + 1;
  height = y + w->across + 1;
  bend_profile(w);
  radius = tread_radius(w, w->zone_y);
  top = w->top_layer / (radius - w->inner);
  lines_with_zone(line, w->along, w->sector / 2, w->zone_along_n, w->zone_along / 2 / radius, 0);
  /* The zone need not be in the middle of the tread. */
  graded_lines(y, before, y0, left, step, 0);
  reverse_lines(y, before);
  for (k = 0; k <= w->zone_across_n; ++k) y[before + k] = y0 + k * step;
  graded_lines(y + before + w->zone_across_n, w->across - before - w->zone_across_n, y1, right, step, 0);
  graded_lines(height, w->deep, 1, 0, top > 0 ? top : 1.0 / w->deep, 0);
  reverse_lines(height, w->deep);
  g.n[0] = w->along;
  g.n[1] = w->across;
  g.n[2] = w->deep;
  g.line[0] = line;
  g.line[1] = y;
  g.line[2] = height;
  g.ring = 0;
  for (k = 0; k < 6; ++k) g.face_tag[k] = tag[k];
  g.zone_from[0] = (w->along - w->zone_along_n) / 2;
  g.zone_to[0] = g.zone_from[0] + w->zone_along_n;
  g.zone_from[1] = before;
  g.zone_to[1] = before + w->zone_across_n;
  g.zone_tag = 2;
  g.position = wheel_position;
  g.shape = w;
  made = make_grid_mesh(m, &g, type);
  free(line);
  return made;
}

#endif
