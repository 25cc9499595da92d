/* Reads off a line of nodes across the contact, y = const, the largest pressure and the half-width. */
#ifndef FRAME_LINE_H
#define FRAME_LINE_H

#include "contact_output.h"

typedef struct {
  double x, p;
} line_point;

static int by_x(const void* a, const void* b) {
  const double xa = ((const line_point*)a)->x, xb = ((const line_point*)b)->x;
  return (xa > xb) - (xa < xb);
}

/* Returns the number of nodes on the line at y, with the largest pressure there and the half-width, the latter by the
   second moment of the pressure: a^2 = 4 <x^2> under Hertz's ellipse. */
static int on_line(const frame_results* r, double y, double* pressure, double* half_width) {
  static line_point line[MOST_FRAME_NODES];
  double sum = 0, first = 0, second = 0;
  int k, n = 0;
  for (k = 0; k < r->nodes; ++k) {
    if (fabs(r->x[k][1] - y) > 1e-6) continue;
    line[n].x = r->x[k][0];
    line[n++].p = -r->t[k][2];
  }
  qsort(line, (size_t)n, sizeof *line, by_x);
  *pressure = 0;
  for (k = 0; k < n; ++k) {
    const double dx = 0.5 * (line[k + 1 < n ? k + 1 : k].x - line[k > 0 ? k - 1 : k].x);
    *pressure = fmax(*pressure, line[k].p);
    sum += line[k].p * dx;
    first += line[k].p * dx * line[k].x;
    second += line[k].p * dx * line[k].x * line[k].x;
  }
  *half_width = 2 * sqrt(second / sum - first * first / (sum * sum));
  return n;
}

#endif
