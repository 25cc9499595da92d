#include <stdio.h>
#include <stdlib.h>

#include "rollcon.h"

int main(void) {
  const double mu = 0.3;
  const int32_t top = 2;
  double force[3] = {0, 0, 0}, moment[3], pressure = 0, approach = 0, creep[3];
  int64_t n = 0;
  int32_t* bottom;
  rollcon_context* context;
  rollcon_body *block = NULL, *ball = NULL;
  rollcon_contact* contact = NULL;

  if (rollcon_context_create(ROLLCON_ABI, &context) < 0) return 1;
  rollcon_context_set_latch(context, 1); /* the first failure is kept until the check at the end */
  rollcon_body_create(context, ROLLCON_BODY_FEM, &block);
  rollcon_body_read_mesh(block, "block.inp", "");
  rollcon_body_tag_group(block, "steel", 1);    /* volume elements: tag 1 ... */
  rollcon_body_set_elastic(block, 1, 1e4, 0.3); /* ... is this material */
  rollcon_body_get_group_nodes(block, "bottom", 0, 0, NULL, &n);
  bottom = malloc((n > 0 ? n : 1) * sizeof *bottom);
  rollcon_body_get_group_nodes(block, "bottom", 0, n, bottom, &n);
  rollcon_body_set_support(block, n, bottom, 0, ROLLCON_DOF_XYZ, NULL); /* nodes: held */
  rollcon_body_tag_group(block, "top", top);                            /* faces: tag 2 ... */
  rollcon_body_set_contact_faces(block, 1, &top);                       /* ... may come into contact */
  rollcon_body_create(context, ROLLCON_BODY_RIGID, &ball);
  rollcon_contact_create(context, block, ball, &contact);
  rollcon_contact_frame_rectangle(contact, ROLLCON_QUAD4, 12, 12, -5, 5, -5, 5); /* elements, bounds */
  rollcon_contact_set_gap_quadratic(contact, 1 / 400.0, 1 / 400.0, 0);
  rollcon_contact_set_friction(contact, "coulomb", 1, &mu);
  rollcon_contact_set_rolling(contact, 10);
  rollcon_contact_set_creep(contact, -0.002, 0, 0);
  rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, 1500);
  rollcon_contact_solve(contact);
  rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, force, moment);
  rollcon_contact_get_motion(contact, &approach, creep);
  rollcon_contact_get_stat(contact, "max_pressure", &pressure);
  if (rollcon_context_check(context) < 0) fprintf(stderr, "%s\n", rollcon_last_error());
  printf("largest pressure %.1f MPa, approach %.4f mm, friction %.0f N\n", pressure, approach, force[0]);
  free(bottom);
  rollcon_contact_release(contact);
  rollcon_body_release(ball);
  rollcon_body_release(block);
  rollcon_context_release(context);
  return 0;
}
