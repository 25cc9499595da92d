/* Writes a wheel on its rail for a plotting program: both profiles in the track, and the pressures of each patch as
   heights over the rail. Blocks of lines "y z", two blank lines between them: wheel, rail, then each patch. */
#ifndef WHEEL_PICTURE_H
#define WHEEL_PICTURE_H

#include <rollcon.h>
#include <stdio.h>
#include <stdlib.h>

/* Writes the pressures of one patch: along the rail and back over the largest pressure of each line of nodes, `height`
   for each unit of pressure. Patches without a solution of their own (ellipses by table) are left out. */
static int32_t write_patch(FILE* out, const rollcon_wheelrail* wheel, int32_t patch, double height) {
  rollcon_contact* contact = NULL;
  double origin[3], axes[9], *value = NULL;
  int64_t n = 0, lines = 0, k;
  int32_t status = rollcon_wheelrail_get_contact(wheel, patch, &contact);
  if (status >= 0) status = rollcon_wheelrail_get_patch_axes(wheel, patch, origin, axes);
  if (status >= 0) status = rollcon_contact_get_size(contact, &n, NULL);
  if (status >= 0) {
    value = malloc((size_t)(n > 0 ? 8 * n : 1) * sizeof *value);
    status = value ? rollcon_contact_get_field(contact, ROLLCON_FIELD_POINT, ROLLCON_LOCAL, 3 * n, value, NULL)
                   : ROLLCON_ERR_MEMORY;
  }
  if (status >= 0)
    status = rollcon_contact_get_field(contact, ROLLCON_FIELD_PRESSURE, ROLLCON_LOCAL, n, value + 3 * n, NULL);
  if (status >= 0) {
    const double *point = value, *pressure = value + 3 * n, *t2 = axes + 3, *normal = axes + 6;
    double* line = value + 4 * n; /* y, z, tip y, tip z */
    for (k = 0; k < n; ++k) {     /* nodes come line by line along the rolling direction */
      const double* p = point + 3 * k;
      const double y = origin[1] + p[1] * t2[1] + p[2] * normal[1], z = origin[2] + p[1] * t2[2] + p[2] * normal[2];
      double* at = line + 4 * (lines > 0 ? lines - 1 : 0);
      double tip[2];
      if (lines == 0 || p[1] != p[-2]) {
        at = line + 4 * lines++;
        at[0] = at[2] = y;
        at[1] = at[3] = z;
      }
      tip[0] = y - height * pressure[k] * normal[1];
      tip[1] = z - height * pressure[k] * normal[2];
      if (tip[1] < at[3]) {
        at[2] = tip[0];
        at[3] = tip[1];
      }
    }
    for (k = 0; k < lines; ++k) fprintf(out, "%.6g %.6g\n", line[4 * k], line[4 * k + 1]);
    for (k = lines; k-- > 0;) fprintf(out, "%.6g %.6g\n", line[4 * k + 2], line[4 * k + 3]);
    fprintf(out, "\n\n");
  }
  free(value);
  rollcon_contact_release(contact);
  return status;
}

/* Writes the last solve of a wheel; write_patch() explains the height. */
static int32_t write_wheel_on_rail(FILE* out, const rollcon_wheelrail* wheel, double height) {
  enum { POINTS = 1500 };
  int32_t status = ROLLCON_OK, body;
  int64_t patch, patches = 0;
  int i;
  for (body = 1; body <= 2 && status >= 0; ++body) {
    for (i = 0; i <= POINTS && status >= 0; ++i) {
      double point[2];
      status = rollcon_wheelrail_get_profile_point(wheel, body, (double)i / POINTS, point);
      if (status >= 0) fprintf(out, "%.6g %.6g\n", point[0], point[1]);
    }
    fprintf(out, "\n\n");
  }
  if (status >= 0) status = rollcon_wheelrail_get_patch_count(wheel, &patches);
  for (patch = 0; patch < patches && status >= 0; ++patch) status = write_patch(out, wheel, (int32_t)patch, height);
  return status;
}

#endif
