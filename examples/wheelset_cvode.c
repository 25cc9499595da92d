/* A wheelset hunts in SUNDIALS's integrator CVODE: let go 3 mm from the middle of the track, half a second.

   wheelset_cvode [ACCURACY [TOLERANCE [SPEED [own | differences]]]]: accuracy of the wheels (0.02), relative tolerance
   (1e-5), m/s (30), and where CVODE's Jacobians come from. docs/wheelrail.md. */
#include <time.h>

#include "wheelset_motion.h"

enum { points = 50 };

int main(int argc, char** argv) {
  const double accuracy = argc > 1 ? atof(argv[1]) : 0.02, tolerance = argc > 2 ? atof(argv[2]) : 1e-5;
  const double speed = argc > 3 ? atof(argv[3]) : 30;
  const int own = argc <= 4 || strcmp(argv[4], "differences") != 0;
  double q[states] = {3}, shift[points], processor;
  wheelset set;
  long steps;
  int i;
  wheelset_make(&set, accuracy, 1000 * speed, 0);
  wheelset_settle(&set, q);
  printf("at 3 mm: height %.4f mm, roll %.4f mrad\n", q[height], 1000 * q[roll]);
  set.solves = 0;
  processor = (double)clock();
  steps = wheelset_run(&set, q, tolerance, own, 0.5 / points, points, shift);
  processor = ((double)clock() - processor) / CLOCKS_PER_SEC;
  if (steps < 0) {
    fprintf(stderr, "CVODE gave up\n");
    return 1;
  }
  for (i = 4; i < points; i += 5) printf("%5.2f s %8.4f mm\n", 0.5 * (i + 1) / points, shift[i]);
  printf("%ld steps, %ld solves of a wheel (%ld with a warning, %ld without an answer), %.2f s\n", steps, set.solves,
         set.told[0], set.told[1], processor);
  wheelset_release(&set);
  return 0;
}
