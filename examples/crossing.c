/* A wheel passes a crossing: its wing rail leads away under it, and a nose rises and takes its load.

   The rail is made of slices in closed form, chains of arcs and lines. The wing rail moves outwards by 1:10 and is 2 mm
   high. 44 mm beside it the nose begins at x = 560 mm, 12 mm wide and 6 mm below, and rises along a parabola until
   x = 760. An S1002 wheel of radius 460 mm with 50 kN on it runs at 10 m/s and turns evenly; its height follows from
   the load, and the rate of that from the step before. Units: mm, N, s; x forward, y to the right, z down. Forces are
   those on the rail. docs/profiles.md, docs/wheelrail.md.

   crossing [FOLDER]: writes crossing.txt there, a line for each patch, for plot_crossing.gp. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "rollcon.h"

static const double young = 2.1e5, poisson = 0.28, mu = 0.3, load = 50000, speed = 10000, radius = 460;
static const double flangeway = 44, nose_begins = 560, nose_is_up = 760, nose_width = 12, nose_depth = 6,
                    wing_raised = 2;
static const double gauge_side = 725; /* the nose's, from the middle of the track; the running edge is at 717.5 */

/* Ends the program with the library's own words if a status is below zero. */
static int32_t must(int32_t status) {
  if (status >= 0) return status;
  fprintf(stderr, "%s: %s\n", rollcon_status_string(status), rollcon_last_error());
  exit(1);
}

/* Where the wing rail's running edge is at x, seen from the gauge side of the nose. */
static double wing_edge(double x) {
  return flangeway + nose_width + 0.1 * (x - nose_begins);
}

static double nose_top(double x) {
  const double left = fmax(1 - (x - nose_begins) / (nose_is_up - nose_begins), 0);
  return nose_depth * left * left;
}

/* Appends an arc or a line to a chain, and returns the length. */
static double add(double chain[], int32_t* n, double length, double curvature) {
  chain[(*n)++] = length;
  chain[(*n)++] = curvature;
  return length;
}

/* A head: its top is an arc, its corners are two, down to flanks of 75 degrees. */
struct head {
  double corner, crown, width;
};

static const double steep = 75 * 3.14159265358979323846 / 180;

/* How far the top's arc turns to either side. */
static double half_turn(const struct head* h) {
  return asin((h->width / 2 - h->corner) / (h->crown - h->corner));
}

/* How far below the top the flanks begin. */
static double drop(const struct head* h) {
  return (h->crown - h->corner) * (1 - cos(half_turn(h))) + h->corner * (1 - cos(steep));
}

/* Appends a head from flank to flank. */
static double add_head(double chain[], int32_t* n, const struct head* h) {
  const double top = half_turn(h);
  const double length =
      add(chain, n, h->corner * (steep - top), 1 / h->corner) + add(chain, n, 2 * h->crown * top, 1 / h->crown);
  return length + add(chain, n, h->corner * (steep - top), 1 / h->corner);
}

/* Gives the rail one slice. Its features: both ends of the nose and both of the wing rail's head; before the nose
   begins there are two of them. Between nose and wing rail the section goes down and up again. */
static void add_slice(rollcon_body* rail, double x) {
  const struct head wing = {13, 300, 70}, nose = {5, 60, nose_width + 0.1 * (x - nose_begins)};
  const double c = cos(steep), s = sin(steep), floor = 8;
  double chain[21], feature[4] = {-1, -1, 0, 0};
  int32_t n = 3;
  chain[2] = -steep;
  if (x < nose_begins) {
    chain[0] = wing_edge(x) + wing.corner * (1 - s);
    chain[1] = drop(&wing) - wing_raised;
    feature[3] = add_head(chain, &n, &wing);
  } else {
    /* Lengths of both flanks: their difference makes up for the heights, their sum for the flangeway. */
    const double more = (nose_top(x) + drop(&nose) - drop(&wing) + wing_raised) / s;
    const double across = flangeway + (nose.corner + wing.corner) * (1 - s) - 2 * floor * s;
    const double down = 0.5 * (across / c - more);
    chain[0] = nose.corner * (1 - s);
    chain[1] = nose_top(x) + drop(&nose);
    feature[0] = 0;
    feature[1] = add_head(chain, &n, &nose);
    feature[2] = feature[1] + add(chain, &n, down, 0);
    feature[2] += add(chain, &n, 2 * floor * steep, -1 / floor) + add(chain, &n, down + more, 0);
    feature[3] = feature[2] + add_head(chain, &n, &wing);
  }
  must(rollcon_body_set_profile_shape(rail, "arcs", n, chain));
  must(rollcon_body_add_slice(rail, x, 4, feature));
}

static rollcon_body* elastic(rollcon_context* context) {
  rollcon_body* body;
  must(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &body));
  must(rollcon_body_set_elastic(body, 0, young, poisson));
  return body;
}

static double stat(const rollcon_wheelrail* wheel, int32_t patch, const char* name) {
  double value;
  must(rollcon_wheelrail_get_patch_stat(wheel, patch, name, &value));
  return value;
}

static FILE* open_in(const char* folder) {
  char path[1024];
  FILE* file;
  snprintf(path, sizeof path, "%s/crossing.txt", folder);
  file = fopen(path, "w");
  if (file) return file;
  fprintf(stderr, "cannot write %s\n", path);
  exit(1);
}

int main(int argc, char** argv) {
  const double unit = 1, first = 500, last = 830, step = 10;
  rollcon_context* context;
  rollcon_body *tread, *rail;
  rollcon_wheelrail* wheel;
  double x, before = 0;
  FILE* file = argc > 1 ? open_in(argv[1]) : NULL;
  must(rollcon_context_create(ROLLCON_ABI, &context));
  tread = elastic(context);
  must(rollcon_body_set_profile_shape(tread, "s1002", 1, &unit));
  rail = elastic(context);
  for (x = 400; x <= 900; x += 20) add_slice(rail, x);
  must(rollcon_wheelrail_create(context, tread, rail, ROLLCON_RIGHT, &wheel));
  must(rollcon_wheelrail_place_rail(wheel, gauge_side, 0, 0));
  must(rollcon_wheelrail_set_wheelset(wheel, 1360, -70, radius));
  must(rollcon_wheelrail_set_friction(wheel, "coulomb", 1, &mu));
  must(rollcon_wheelrail_prescribe_vertical(wheel, ROLLCON_BY_FORCE, load));
  must(rollcon_wheelrail_set_real(wheel, "accuracy", 0.02));
  printf("   x, mm    z, mm  wing, N  nose, N  Fx, N  Fy, N  p max, MPa\n");
  for (x = first; x <= last; x += step) {
    const double position[6] = {x, 0, 0, 0, 0, 0};
    double velocity[6] = {0}, force[3], z = 0, on[2] = {0, 0}, pressure = 0;
    int64_t patches, k;
    int again, status = ROLLCON_OK;
    velocity[0] = speed;
    velocity[5] = -speed / radius;
    for (again = 0; again < 2; ++again) { /* first the height, then its rate */
      if (again && x > first) velocity[2] = speed * (z - before) / step;
      must(rollcon_wheelrail_set_position(wheel, position));
      must(rollcon_wheelrail_set_velocity(wheel, velocity));
      status = must(rollcon_wheelrail_solve(wheel));
      must(rollcon_wheelrail_get_stat(wheel, "z", &z));
    }
    before = z;
    must(rollcon_wheelrail_get_resultant(wheel, ROLLCON_IN_TRACK, force, NULL));
    must(rollcon_wheelrail_get_patch_count(wheel, &patches));
    for (k = 0; k < patches; ++k) {
      const int32_t p = (int32_t)k;
      const double y = stat(wheel, p, "y") - gauge_side, normal = stat(wheel, p, "normal_force");
      on[y < wing_edge(x) - flangeway / 2] += stat(wheel, p, "share") * normal;
      pressure = fmax(pressure, stat(wheel, p, "max_pressure"));
      if (file)
        fprintf(file, "%g %g %g %g %g %g %g %g %g\n", x, stat(wheel, p, "x"), y, stat(wheel, p, "z"), normal, z,
                -force[0], -force[1], stat(wheel, p, "max_pressure"));
    }
    if (fmod(x, 20) == 10 || status > ROLLCON_COARSE)
      printf("%8.0f %8.3f %8.0f %8.0f %6.0f %6.0f %11.0f  %s\n", x, z, on[0], on[1], -force[0], -force[1], pressure,
             rollcon_status_string(status));
  }
  if (file) fclose(file);
  rollcon_wheelrail_release(wheel);
  rollcon_body_release(rail);
  rollcon_body_release(tread);
  rollcon_context_release(context);
  return 0;
}
