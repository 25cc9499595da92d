/* A wheelset on its track: the contacts of the Manchester benchmark, case, from profiles to forces.

   S1002 wheels on canted 60E1 rails, gauge 1435 mm; 10 kN on each wheel, 2 m/s, yaw of 2.4 mrad for each millimetre of
   lateral shift. Roll and speed of rotation are those at which both wheels have the same height and no moment is left
   about the axle. Units: mm, N, s; axes: x forward, y to the right, z down. Forces are those on the rails.
   docs/wheelrail.md.

   manchester [FOLDER]: writes manchester.txt there, with the wheels at three shifts and the equivalent conicity beside
   it, for plot_manchester.gp. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "rollcon.h"
#include "wheel_picture.h"

static const double shear = 82000, poisson = 0.28, mu = 0.3, load = 10000, speed = 2000;
static const double gauge = 1435, gauge_height = 14, back_to_back = 1360, flange_back = -70, radius = 460;
enum { right = 0, left = 1, sides = 2 };

/* Ends the program with the library's own words if a status is below zero. */
static int32_t must(int32_t status) {
  if (status >= 0) return status;
  fprintf(stderr, "%s: %s\n", rollcon_status_string(status), rollcon_last_error());
  exit(1);
}

static rollcon_body* with_profile(rollcon_context* context, const char* shape) {
  const double millimetre = 1;
  rollcon_body* body;
  must(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &body));
  must(rollcon_body_set_elastic(body, 0, 2 * shear * (1 + poisson), poisson));
  must(rollcon_body_set_profile_shape(body, shape, 1, &millimetre));
  return body;
}

static double stat(const rollcon_wheelrail* wheel, const char* name) {
  double value;
  must(rollcon_wheelrail_get_stat(wheel, name, &value));
  return value;
}

static double patch_stat(const rollcon_wheelrail* wheel, int32_t patch, const char* name) {
  double value;
  must(rollcon_wheelrail_get_patch_stat(wheel, patch, name, &value));
  return value;
}

/* Solves both wheels under their load. off: difference of the heights that they find, and moment about the axle over
   load times radius. The worse status of both. */
static int32_t solve(rollcon_wheelrail* wheel[sides], double y, double roll, double rate, double off[2]) {
  int32_t worst = ROLLCON_OK;
  int side;
  off[0] = off[1] = 0;
  for (side = 0; side < sides; ++side) {
    const double position[6] = {0, y, 0, roll, 2.4e-3 * y, 0};
    const double velocity[6] = {speed, 0, 0, 0, 0, rate};
    double force[3], moment[3];
    int32_t status;
    must(rollcon_wheelrail_set_position(wheel[side], position));
    must(rollcon_wheelrail_set_velocity(wheel[side], velocity));
    status = must(rollcon_wheelrail_solve(wheel[side]));
    if (status > worst) worst = status;
    must(rollcon_wheelrail_get_resultant(wheel[side], ROLLCON_IN_WHEELSET, force, moment));
    off[0] += (side == right ? 1 : -1) * stat(wheel[side], "z");
    off[1] += moment[1] / (load * radius);
  }
  return worst;
}

/* Finds the roll and rate at which nothing is off, by Newton's method with differences. */
static int32_t find_equilibrium(rollcon_wheelrail* wheel[sides], double y, double* roll, double* rate) {
  const double roll_step = 1e-6, rate_step = 1e-5;
  double off[2], rolled[2], faster[2];
  int32_t status = ROLLCON_OK;
  int i;
  for (i = 0; i < 20; ++i) {
    double a, b, c, d, determinant, more_roll, more_rate, shorter;
    status = solve(wheel, y, *roll, *rate, off);
    if (fabs(off[0]) < 1e-6 && fabs(off[1]) < 1e-7) return status;
    solve(wheel, y, *roll + roll_step, *rate, rolled);
    solve(wheel, y, *roll, *rate + rate_step, faster);
    a = (rolled[0] - off[0]) / roll_step;
    b = (faster[0] - off[0]) / rate_step;
    c = (rolled[1] - off[1]) / roll_step;
    d = (faster[1] - off[1]) / rate_step;
    determinant = a * d - b * c;
    more_roll = (b * off[1] - d * off[0]) / determinant;
    more_rate = (c * off[0] - a * off[1]) / determinant;
    shorter = fmin(1, 0.02 / fabs(more_rate)); /* beyond that friction is saturated and has no slope */
    *roll += shorter * more_roll;
    *rate += shorter * more_rate;
  }
  return ROLLCON_NOT_CONVERGED;
}

static void print_patches(FILE* out, const rollcon_wheelrail* wheel, double y, int side) {
  int64_t n, k;
  must(rollcon_wheelrail_get_patch_count(wheel, &n));
  for (k = 0; k < n; ++k) {
    const int32_t p = (int32_t)k;
    fprintf(out, "%5.1f %-5s %3.0f%% %9.3f %8.4f %8.4f %10.3e %10.3e %10.3e %8.0f %8.1f %8.1f %9.1f %7.1f %6.1f\n", y,
            side == right ? "right" : "left", 100 * patch_stat(wheel, p, "share"), patch_stat(wheel, p, "y"),
            patch_stat(wheel, p, "z"), patch_stat(wheel, p, "angle"), patch_stat(wheel, p, "longitudinal_creepage"),
            patch_stat(wheel, p, "lateral_creepage"), patch_stat(wheel, p, "spin"),
            patch_stat(wheel, p, "normal_force"), -patch_stat(wheel, p, "longitudinal_force"),
            -patch_stat(wheel, p, "lateral_force"), -patch_stat(wheel, p, "spin_moment"),
            patch_stat(wheel, p, "max_pressure"), patch_stat(wheel, p, "area"));
  }
}

static FILE* open_in(const char* folder, const char* name) {
  char path[1024];
  FILE* file;
  snprintf(path, sizeof path, "%s/%s", folder, name);
  file = fopen(path, "w");
  if (file) return file;
  fprintf(stderr, "cannot write %s\n", path);
  exit(1);
}

/* Draws the right wheel on its rail, pressures 4 mm high for each 1000 MPa. */
static void draw(const char* folder, const rollcon_wheelrail* wheel, double y) {
  const double height = 0.004;
  char name[64];
  FILE* file;
  snprintf(name, sizeof name, "manchester_%.1f.txt", y);
  file = open_in(folder, name);
  must(write_wheel_on_rail(file, wheel, height));
  fclose(file);
}

static void write_conicity(const char* folder, rollcon_wheelrail* wheel[sides]) {
  enum { STEPS = 32 };
  double amplitude[STEPS], conicity[STEPS], wavelength[STEPS];
  FILE* file = open_in(folder, "manchester_conicity.txt");
  int i;
  for (i = 0; i < STEPS; ++i) amplitude[i] = 0.25 * (i + 1);
  must(rollcon_wheelrail_find_conicity(wheel[left], wheel[right], STEPS, amplitude, conicity, wavelength));
  for (i = 0; i < STEPS; ++i) fprintf(file, "%.2f %.6f\n", amplitude[i], conicity[i]);
  fclose(file);
}

int main(int argc, char** argv) {
  const double cant = atan(1.0 / 40), last = 10, step = 0.5;
  rollcon_context* context;
  rollcon_body *tread, *rail;
  rollcon_wheelrail* wheel[sides];
  double y, roll = 0, rate = -speed / radius;
  FILE* file = NULL;
  int side;
  const char* folder = argc > 1 ? argv[1] : NULL;
  if (folder) file = open_in(folder, "manchester.txt");
  must(rollcon_context_create(ROLLCON_ABI, &context));
  tread = with_profile(context, "s1002");
  rail = with_profile(context, "60e1");
  for (side = 0; side < sides; ++side) {
    must(rollcon_wheelrail_create(context, tread, rail, side == right ? ROLLCON_RIGHT : ROLLCON_LEFT, &wheel[side]));
    must(rollcon_wheelrail_set_track(wheel[side], gauge, gauge_height, cant));
    must(rollcon_wheelrail_set_wheelset(wheel[side], back_to_back, flange_back, radius));
    must(rollcon_wheelrail_set_friction(wheel[side], "coulomb", 1, &mu));
    must(rollcon_wheelrail_prescribe_vertical(wheel[side], ROLLCON_BY_FORCE, load));
  }
  printf(
      "    y wheel share       y        z    angle       xi        eta        phi         Fn       Fx       Fs"
      "        Mn   p max   area\n");
  for (y = 0; y <= last; y += step) {
    const int32_t status = find_equilibrium(wheel, y, &roll, &rate);
    double radius_of[sides] = {0, 0};
    printf("y %.1f mm: z %.4f mm, roll %.3e, rate %.7f 1/s: %s\n", y, stat(wheel[right], "z"), roll, rate,
           rollcon_status_string(status));
    for (side = 0; side < sides; ++side) {
      print_patches(stdout, wheel[side], y, side);
      if (file) print_patches(file, wheel[side], y, side);
      radius_of[side] = patch_stat(wheel[side], 0, "rolling_radius");
    }
    if (folder && (y == 0 || y == 5 || y == 6.5)) draw(folder, wheel[right], y);
    if (file)
      fprintf(file, "%5.1f set %.6f %.6e %.8f %.5f\n", y, stat(wheel[right], "z"), roll, rate,
              radius_of[right] - radius_of[left]);
  }
  if (file) fclose(file);
  if (folder) write_conicity(folder, wheel);
  for (side = 0; side < sides; ++side) rollcon_wheelrail_release(wheel[side]);
  rollcon_body_release(rail);
  rollcon_body_release(tread);
  rollcon_context_release(context);
  return 0;
}
