/* A ball bearing under a radial load: how much does each ball carry? Units: mm, N; so MPa. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "rollcon.h"

enum { balls = 11, cases = 50 };

static void must(int32_t status) {
  if (status >= 0) return;
  fprintf(stderr, "%s\n", rollcon_last_error());
  exit(1);
}

int main(void) {
  const double ball = 12, pitch = 60, conformity = 0.52, load = 8000, mu = 0.05, pi = acos(-1.0);
  double loads[cases + 1] = {0}, yields[cases + 1] = {0}, found[cases], carried[balls], low = 0, high, sum;
  rollcon_context* context;
  rollcon_body* steel;
  rollcon_contact* contact;
  int side, i, k;
  must(rollcon_context_create(ROLLCON_ABI, &context));
  must(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &steel));
  must(rollcon_body_set_elastic(steel, 0, 206e3, 0.3));
  must(rollcon_contact_create(context, steel, steel, &contact));
  must(rollcon_contact_set_friction(contact, "coulomb", 1, &mu));
  must(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, 1000));
  for (i = 1; i <= cases; ++i) loads[i] = 100.0 * i;
  for (side = -1; side <= 1; side += 2) { /* inner and outer raceway */
    must(rollcon_contact_set_gap_quadratic(contact, 1 / (ball * (1 + side * ball / pitch)),
                                           (1 - 0.5 / conformity) / ball, 0));
    must(rollcon_contact_solve_many(contact, "normal", cases, loads + 1, "approach", 1, found, NULL, NULL));
    for (i = 1; i <= cases; ++i) yields[i] += found[i - 1];
  }
  for (high = yields[cases]; high - low > 1e-9;) { /* moves the ring until the balls carry the load */
    const double shift = (low + high) / 2;
    for (k = 0, sum = 0; k < balls; ++k) {
      const double c = cos(2 * pi * k / balls), y = c > 0 ? shift * c : 0;
      for (i = 1; yields[i] < y;) ++i;
      carried[k] = loads[i - 1] + (loads[i] - loads[i - 1]) * (pow(y, 1.5) - pow(yields[i - 1], 1.5)) /
                                      (pow(yields[i], 1.5) - pow(yields[i - 1], 1.5));
      sum += carried[k] * c;
    }
    if (sum < load)
      low = shift;
    else
      high = shift;
  }
  printf("loads of the balls, N:");
  for (k = 0; k < balls; ++k) printf(" %.0f", carried[k]);
  printf("\nshift %.2f um; largest load %.3f times load/balls\n", 1e3 * low, carried[0] * balls / load);
  rollcon_contact_release(contact);
  rollcon_body_release(steel);
  rollcon_context_release(context);
  return 0;
}
