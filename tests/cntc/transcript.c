/* A C program that speaks CONTACT's interface: steps in time of two spheres, and stresses inside. */
#include <math.h>
#include <rollcon_cntc.h>
#include <stdio.h>

int main(void) {
  const int zero = 0, one = 1, three = 3, four = 4, six = 6, five = 5, nine = 9, two = 2, ire = 2, icp = 1, name = 12;
  const double material[4] = {0.28, 0.28, 1, 1}, friction[2] = {0.4013, 0.4013}, load = 0.4705, fx = -0.657, fy = 0,
               grid[6] = {34, 33, -4.125, -4, 0.25, 0.25}, gap[6] = {0.002963, 0, 0.002963, 0, 0, 0}, speed = 1,
               origin = 0, z[5] = {0, 1, 1.68, 3, 5};
  const int flags[3] = {CNTC_if_units, CNTC_ic_tang, CNTC_ic_force}, values[3] = {CNTC_un_cntc, 1, 1}, mises = 8;
  double ksi = 0, eta = 0, phi = 0, pressure = 0, v[5];
  int version, error = 1, k;
  cntc_initializefirst(&version, &error, &zero, "", "", "transcript_c", &zero, &zero, &name);
  cntc_initialize(&ire, &three, &version, &error, "", &zero);
  if (error) return 1;
  cntc_setflags(&ire, &icp, &three, flags, values);
  cntc_setmaterialparameters(&ire, &icp, &zero, &four, material);
  cntc_setfrictionmethod(&ire, &icp, &zero, &two, friction);
  cntc_setpotcontact(&ire, &icp, &three, &six, grid);
  cntc_setundeformeddistc(&ire, &icp, &one, &six, gap);
  cntc_setreferencevelocity(&ire, &icp, &speed);
  cntc_setnormalforce(&ire, &icp, &load);
  cntc_settangentialforces(&ire, &icp, &fx, &fy);
  subs_addblock(&ire, &icp, &one, &nine, &one, &one, &five, &origin, &origin, z);
  cntc_calculate(&ire, &icp, &error);
  cntc_getcreepages(&ire, &icp, &ksi, &eta, &phi);
  cntc_getmaximumpressure(&ire, &icp, &pressure);
  printf("shift %g, largest pressure %g\n", ksi, pressure);
  if (error < 0 || fabs(pressure - 0.01834) > 0.0003) return 2;
  subs_calculate(&ire, &icp, &error);
  subs_getresults(&ire, &icp, &one, &five, &one, &mises, v);
  for (k = 0; k < 5; ++k) printf("z %g, von Mises %g\n", z[k], v[k]);
  if (error || fabs(v[2] - 0.62 * 0.01834) > 0.04 * 0.0114) return 3; /* Hertz: 0.62 p0 below the surface */
  cntc_finalizelast();
  return 0;
}
