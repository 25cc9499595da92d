/* One point of the creep curve of a steel wheel, by CONTACT's calls. Units of CONTACT: mm, N. */
#include <rollcon_cntc.h>
#include <stdio.h>

int main(void) {
  const int none = 0, two = 2, four = 4, five = 5, module = 3, hertz = -2, ire = 1, icp = 1, log = 10;
  const int flags[2] = {CNTC_if_units, CNTC_ic_tang}, values[2] = {CNTC_un_cntc, 3}; /* T = 3: steady rolling */
  const double grid[5] = {44, 48, 0.0008, 0.5, 1.01}; /* elements, curvature along, ratio of the axes, scale */
  const double steel[4] = {0.28, 0.28, 82000, 82000}, friction[2] = {0.33, 0.33};
  const double force = 106700, speed = 10000, creepage = 8e-4, zero = 0;
  double normal = 0, along = 0, across, moment, pressure = 0;
  int version, error = 0;

  cntc_initializefirst(&version, &error, &none, "", "", "creep_cntc", &none, &none, &log);
  cntc_initialize(&ire, &module, &version, &error, "", &none);
  cntc_setflags(&ire, &icp, &two, flags, values);
  cntc_setmaterialparameters(&ire, &icp, &none, &four, steel);
  cntc_setfrictionmethod(&ire, &icp, &none, &two, friction);
  cntc_sethertzcontact(&ire, &icp, &hertz, &five, grid);
  cntc_setreferencevelocity(&ire, &icp, &speed);
  cntc_setnormalforce(&ire, &icp, &force);
  cntc_setcreepages(&ire, &icp, &creepage, &zero, &zero);
  cntc_calculate(&ire, &icp, &error);
  cntc_getcontactforces(&ire, &icp, &normal, &along, &across, &moment);
  cntc_getmaximumpressure(&ire, &icp, &pressure);
  printf("Fx/(fstat Fn) %.4f, largest pressure %.1f\n", along / (0.33 * normal), pressure);
  cntc_finalizelast();
  return error < 0; /* above 0: elements in contact beside the border of the grid */
}
