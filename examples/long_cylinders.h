/* Computes what the middle of two long cylinders does: plane strain, for comparison with bodies of finite length. Both
   are half-spaces, of any materials. */
#ifndef LONG_CYLINDERS_H
#define LONG_CYLINDERS_H

#include <math.h>

#include "contact_output.h"

typedef struct {
  double young[2], poisson[2]; /* elastic constants of body 1 and body 2 */
  double curvature;            /* 1 / R1 + 1 / R2 */
  double load;                 /* load per length */
  double mu, speed;
} cylinder_pair;

typedef struct {
  double half_width, pressure; /* Hertz */
  double creepage, fastest;    /* slip in contact */
} cylinder_results;

enum { LINES_ALONG = 81, LINES_ACROSS = 3 };

static cylinder_results hertz_line(const cylinder_pair* c) {
  const double pi = acos(-1.0);
  cylinder_results h = {0, 0, 0, 0};
  double soft = 0; /* 1 / E* */
  int i;
  for (i = 0; i < 2; ++i) soft += (1 - c->poisson[i] * c->poisson[i]) / c->young[i];
  h.half_width = sqrt(4 * c->load * soft / (pi * c->curvature));
  h.pressure = 2 * c->load / (pi * h.half_width);
  return h;
}

/* Returns Hertz's gap beside the contact, at the distance x > half_width from its middle. */
static double hertz_gap(const cylinder_pair* c, double half_width, double x) {
  const double t = x / half_width;
  return c->curvature / 2 * half_width * half_width * (t * sqrt(t * t - 1) - acosh(t));
}

/* Rolls under the tangential force `ratio` mu times the load; `file`, if not NULL, gets the
   columns of STEM_section.txt. The frame lies between three lines along the rolling direction. The
   outer two are its outline, which carries nothing, and lie far off: all load is on the middle
   line, from where it falls linearly, so slowly that nothing near the line tells it from a uniform
   one. */
static cylinder_results roll_long_cylinders(const cylinder_pair* c, double ratio, FILE* file) {
  cylinder_results found = hertz_line(c);
  const double a = found.half_width, far = 1e4 * a, most = 1.15 * a;
  static double x[LINES_ALONG * LINES_ACROSS][3], t[LINES_ALONG * LINES_ACROSS][3];
  static double slip[LINES_ALONG * LINES_ACROSS][2], gap[LINES_ALONG * LINES_ACROSS];
  const double line[LINES_ACROSS][3] = {{-far, -most, most}, {0, -most, most}, {far, -most, most}};
  double creep[3];
  rollcon_body* body[2];
  rollcon_contact* pair;
  int i;
  for (i = 0; i < 2; ++i) {
    must(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &body[i]));
    must(rollcon_body_set_elastic(body[i], 0, c->young[i], c->poisson[i]));
  }
  must(rollcon_contact_create(context, body[0], body[1], &pair));
  must(rollcon_contact_frame_strips(pair, LINES_ALONG - 1, LINES_ACROSS, line[0]));
  must(rollcon_contact_set_gap_quadratic(pair, c->curvature / 2, 1, 0));
  must(rollcon_contact_set_friction(pair, "coulomb", 1, &c->mu));
  must(rollcon_contact_set_rolling(pair, c->speed));
  must(rollcon_contact_prescribe(pair, ROLLCON_NORMAL, ROLLCON_BY_FORCE, c->load * far));
  must(rollcon_contact_prescribe(pair, ROLLCON_LONGITUDINAL, ROLLCON_BY_FORCE, ratio * c->mu * c->load * far));
  if (must(rollcon_contact_solve(pair)) != ROLLCON_OK) {
    fprintf(stderr, "the long cylinders touch elsewhere than on their middle line\n");
    exit(1);
  }
  must(rollcon_contact_get_motion(pair, NULL, creep));
  found.creepage = creep[0];
  must(rollcon_contact_get_field(pair, ROLLCON_FIELD_POINT, ROLLCON_LOCAL, 3 * LINES_ALONG * LINES_ACROSS, &x[0][0],
                                 NULL));
  must(rollcon_contact_get_tractions(pair, ROLLCON_LOCAL, LINES_ALONG * LINES_ACROSS, &t[0][0]));
  must(rollcon_contact_get_field(pair, ROLLCON_FIELD_SLIP, ROLLCON_LOCAL, 2 * LINES_ALONG * LINES_ACROSS, &slip[0][0],
                                 NULL));
  must(rollcon_contact_get_field(pair, ROLLCON_FIELD_GAP, ROLLCON_LOCAL, LINES_ALONG * LINES_ACROSS, gap, NULL));
  for (i = LINES_ALONG + 1; i + 1 < 2 * LINES_ALONG; ++i) {
    if (t[i][2] < 0) found.fastest = fmax(found.fastest, fabs(slip[i][0]));
    if (file != NULL)
      fprintf(file, "%.6f 0 %.5e %.5e %.5e %.5e %.5e %.5e\n", x[i][0], -t[i][2], t[i][0], t[i][1], slip[i][0],
              slip[i][1], gap[i]);
  }
  rollcon_contact_release(pair);
  for (i = 0; i < 2; ++i) rollcon_body_release(body[i]);
  return found;
}

#endif
