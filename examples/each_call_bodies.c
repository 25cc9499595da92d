/* Makes calls that other examples do not need: contexts, bodies, meshes, profiles. docs/api.md shows its lines. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "rollcon_layers.h"

static const double frictionless = 0;

static int32_t must(int32_t status) {
  if (status >= 0) return status;
  fprintf(stderr, "%s: %s\n", rollcon_status_string(status), rollcon_last_error());
  exit(1);
}

static void print_line(int32_t level, const char* message, void* user) {
  ++*(int*)user;
  if (level <= ROLLCON_LOG_WARNING) printf("log: %s\n", message);
}

/* Writes two hexahedra on top of each other, in the form of Abaqus. */
static void write_mesh(const char* path) {
  FILE* file = fopen(path, "w");
  int k, corner;
  if (!file) exit(1);
  fprintf(file, "*NODE\n");
  for (k = 0; k < 12; ++k) {
    corner = k % 4;
    fprintf(file, "%d, %d, %d, %d\n", k + 1, corner == 1 || corner == 2, corner > 1, k / 4);
  }
  fprintf(file, "*ELEMENT, TYPE=C3D8, ELSET=steel\n1, 1,2,3,4,5,6,7,8\n2, 5,6,7,8,9,10,11,12\n");
  fprintf(file, "*NSET, NSET=low, GENERATE\n1, 4, 1\n*SURFACE, NAME=high\n2, S2\n");
  fprintf(file, "*ELEMENT, TYPE=S4, ELSET=patch\n3, 9,10,11,12\n");
  fclose(file);
}

static void facts(void) {
  printf("version %d (%s), interface %d\n", (int)rollcon_version(), rollcon_version_string(), (int)rollcon_abi());
  printf("%s\n", strlen(rollcon_build_info()) > 40 ? "the build tells of itself" : "no");
  if (rollcon_has_feature("fem")) printf("it has finite elements\n");
}

static void contexts(rollcon_context* context, int* lines) {
  int32_t id = rollcon_id_of(context);
  must(rollcon_context_set_log(context, ROLLCON_LOG_INFO, print_line, lines));
  must(rollcon_context_retain(context));
  if (rollcon_context_from_id(id) == context) printf("an id leads back to its handle\n");
  rollcon_context_release(context);
  if (rollcon_context_set_communicator(context, 0) < 0) printf("it has no ranks beside it\n"); /* MPI does not run */
  must(rollcon_context_set_latch(context, 1));
  rollcon_report(context, ROLLCON_ERR_ARGUMENT, "my_function: n is -1"); /* a layer's own failure */
  printf("the latch keeps %d: %s\n", (int)rollcon_context_check(context), rollcon_last_error());
  must(rollcon_context_set_latch(context, 0));
}

static void mesh(rollcon_context* context) {
  const double traction[3] = {0, 0, 3};
  const int32_t free_side = 3, side_face = 3;  /* tag of that face; nodes 2 3 7 6 of an element */
  const int32_t top_element = 1, top_face = 1; /* counting from 0: the second element, its face 5678 */
  int32_t groups, kind, ids[8];
  int64_t n, i, step;
  const double weight[3] = {0, 0, -0.01}, axis_at[3] = {0.5, 0.5, 0}, turning[3] = {0, 0, 10},
               middle[3] = {0.5, 0.5, 1};
  double u[36], force[3], moment[3], share, stress[6 * 12], moved[3], at_points[6 * 64];
  char name[64];
  rollcon_body *bar, *copy;
  must(rollcon_body_create(context, ROLLCON_BODY_FEM, &bar));
  must(rollcon_body_read_mesh(bar, "each_call.inp", "steel"));
  must(rollcon_body_tag_group(bar, "steel", 1));
  must(rollcon_body_tag_group(bar, "high", 2));
  must(rollcon_body_tag_faces(bar, 1, &top_element, &top_face, 0, 2)); /* that face by its number */
  must(rollcon_body_tag_faces(bar, 1, &top_element, &side_face, 0, free_side));
  must(rollcon_body_set_contact_faces(bar, 1, &free_side));
  must(rollcon_body_get_group_count(bar, &groups));
  for (i = 0; i < groups; ++i) {
    must(rollcon_body_get_group_name(bar, (int32_t)i, sizeof name, name, NULL));
    printf("group %s\n", name);
  }
  must(rollcon_body_get_group_nodes(bar, "low", 0, 8, ids, &n));
  must(rollcon_body_set_support(bar, n, ids, 0, ROLLCON_DOF_XYZ, NULL));
  must(rollcon_body_set_elastic(bar, 1, 1000, 0));
  must(rollcon_body_set_traction(bar, 2, traction));
  must(rollcon_body_set_pressure(bar, 2, 0.5));
  must(rollcon_body_set_body_force(bar, 1, weight));
  must(rollcon_body_set_rotation(bar, 1, 1e-6, axis_at, turning));
  must(rollcon_body_set_int(bar, "keep_factors", 1));
  must(rollcon_body_set_real(bar, "edge_angle", 35));
  must(rollcon_body_get_int(bar, "keep_factors", &step));
  must(rollcon_body_get_real(bar, "edge_angle", &share));
  must(rollcon_body_prepare(bar));
  must(rollcon_body_get_displacements(bar, 12, u));
  must(rollcon_body_get_node_stresses(bar, 12, u, stress));
  must(rollcon_body_get_point_stresses(bar, 12, u, 64, at_points, NULL, &n));
  printf("%d integration points\n", (int)n);
  must(rollcon_body_get_fields_at(bar, 12, u, 1, middle, moved, stress));
  printf("its middle moves by %.4f, pulled by %.2f\n", moved[2], stress[2]);
  must(rollcon_body_write(bar, "each_call.vtu", 12, u));
  must(rollcon_body_get_reaction(bar, force, moment));
  must(rollcon_body_get_kind(bar, &kind));
  printf("kind %d, end moves by %.4f, held with %.2f, options %d %.0f\n", (int)kind, u[35], force[2], (int)step, share);
  must(rollcon_body_save(bar, "each_call.body"));
  must(rollcon_body_load(context, "each_call.body", &copy));
  must(rollcon_body_get_displacements(copy, 12, u));
  printf("its copy's end moves by %.4f\n", u[35]);
  rollcon_body_release(copy);
  must(rollcon_body_copy(bar, &copy)); /* another load case: its end is pulled at one corner */
  must(rollcon_body_get_group_nodes(bar, "high", 0, 8, ids, &n));
  must(rollcon_body_set_node_tractions(copy, 2, 1, ids, 0, NULL, traction));
  must(rollcon_body_prepare(copy));
  must(rollcon_body_get_displacements(copy, 12, u));
  printf("pulled harder at a corner it moves by %.4f\n", u[35]);
  must(rollcon_body_retain(copy));
  if (rollcon_body_from_id(rollcon_id_of(copy)) != copy) exit(1);
  rollcon_body_release(copy);
  rollcon_body_release(copy);
  rollcon_body_release(bar);
}

/* Presses a rigid ball on the bar's side, in the middle of the upper element. */
static void pressed(rollcon_context* context) {
  const double middle[3] = {1, 0.5, 1.5}, along[3] = {0, 1, 0}, outwards[3] = {1, 0, 0};
  const double inside[3] = {0.7, 0.5, 1.5};
  double u[36], stress[6];
  rollcon_body *bar, *ball;
  rollcon_contact* contact;
  must(rollcon_body_load(context, "each_call.body", &bar));
  must(rollcon_body_create(context, ROLLCON_BODY_RIGID, &ball));
  must(rollcon_contact_create(context, bar, ball, &contact));
  must(rollcon_contact_set_axes(contact, middle, along, outwards));
  must(rollcon_contact_frame_rectangle(contact, ROLLCON_QUAD4, 8, 8, -0.4, 0.4, -0.4, 0.4));
  must(rollcon_contact_set_gap_quadratic(contact, 0.1, 0.1, 0));
  must(rollcon_contact_set_friction(contact, "coulomb", 1, &frictionless));
  must(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, 0.5));
  must(rollcon_contact_solve(contact));
  must(rollcon_contact_get_body_displacements(contact, ROLLCON_BODY1, 36, u, NULL));
  printf("its corner under a ball moves by %.4f\n", u[35]);
  must(rollcon_contact_get_fields_at(contact, ROLLCON_BODY1, 1, inside, ROLLCON_IN_BODY, NULL, stress));
  printf("below the ball it is pressed by %.2f\n", -stress[0]);
  must(rollcon_contact_write_body(contact, ROLLCON_BODY1, "each_call.vtu"));
  must(rollcon_contact_write_loads(contact, ROLLCON_BODY1, "each_call.mtx"));
  rollcon_contact_release(contact);
  rollcon_body_release(ball);
  rollcon_body_release(bar);
}

static void section(rollcon_context* context) {
  /* A roller, whose section is one quadrilateral, and a strip that is drawn along x. */
  const double corner[4][3] = {{0, 0, 1}, {0, 4, 1}, {0, 4, 9}, {0, 0, 9}}, origin[3] = {0, 0, 0}, axis[3] = {0, 1, 0},
               along[3] = {1, 0, 0}, rubber[3] = {10, 10, 100};
  const int32_t quad[4] = {0, 1, 2, 3}, bore[2] = {0, 1}, tread[2] = {2, 3}, tag = 1, seat = 2;
  /* Moduli of rubber at two frequencies; the roller then rolls on a plane. */
  const double frequencies[2] = {1, 1000}, storage[2] = {4, 8}, loss[2] = {0.5, 1}, top[3] = {0, 2, 9},
               up[3] = {0, 0, 1};
  double* power;
  int64_t n;
  rollcon_body *roller, *strip, *plane;
  rollcon_contact* contact;
  must(rollcon_body_create(context, ROLLCON_BODY_SECTION, &roller));
  must(rollcon_body_set_nodes(roller, 4, &corner[0][0], 3, 1));
  must(rollcon_body_add_elements(roller, ROLLCON_QUAD4, 1, quad, 0, 0));
  must(rollcon_body_set_elastic(roller, 0, 210000, 0.3));
  must(rollcon_body_tag_faces_of_nodes(roller, 2, bore, 0, seat));
  must(rollcon_body_set_springs(roller, seat, rubber));
  must(rollcon_body_tag_faces_of_nodes(roller, 2, tread, 0, tag));
  must(rollcon_body_set_contact_faces(roller, 1, &tag));
  must(rollcon_body_copy(roller, &strip));
  must(rollcon_body_revolve(roller, origin, axis));
  must(rollcon_body_set_moduli(roller, 0, 2, frequencies, storage, loss));
  must(rollcon_body_prepare(roller));
  must(rollcon_body_create(context, ROLLCON_BODY_RIGID, &plane));
  must(rollcon_contact_create(context, roller, plane, &contact));
  must(rollcon_contact_set_axes(contact, top, along, up));
  must(rollcon_contact_frame_rectangle(contact, ROLLCON_QUAD4, 16, 8, -2, 2, -2, 2));
  must(rollcon_contact_set_gap_quadratic(contact, 0.5 / 9, 0.1, 0));
  must(rollcon_contact_set_friction(contact, "coulomb", 1, &frictionless));
  must(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, 1));
  must(rollcon_contact_set_rolling(contact, 100));
  must(rollcon_contact_solve(contact));
  must(rollcon_contact_get_body_power(contact, ROLLCON_BODY1, 0, NULL, &n));
  power = malloc((size_t)n * sizeof *power);
  if (!power) exit(1);
  must(rollcon_contact_get_body_power(contact, ROLLCON_BODY1, n, power, NULL));
  printf("a roller of rubber loses power %.2f in the first wave around it\n", power[1]);
  free(power);
  rollcon_contact_release(contact);
  rollcon_body_release(plane);
  must(rollcon_body_extrude(strip, origin, along, 100));
  must(rollcon_body_prepare(strip));
  printf("a roller and a strip by their sections\n");
  rollcon_body_release(strip);
  rollcon_body_release(roller);
}

static void condensed(rollcon_context* context) {
  /* Four nodes on springs, as another program might have condensed them; then their flexibility from a file. */
  const double corner[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const int32_t quad[4] = {0, 1, 2, 3};
  double stiffness[144] = {0};
  rollcon_body* pad[2];
  int k;
  for (k = 0; k < 12; ++k) stiffness[13 * k] = 5;
  for (k = 0; k < 2; ++k) {
    must(rollcon_body_create(context, ROLLCON_BODY_CONDENSED, &pad[k]));
    must(rollcon_body_set_nodes(pad[k], 4, &corner[0][0], 3, 1));
    must(rollcon_body_add_elements(pad[k], ROLLCON_QUAD4, 1, quad, 0, 0));
    must(rollcon_body_set_elastic(pad[k], 0, 10, 0.3));
  }
  must(rollcon_body_set_condensed(pad[0], ROLLCON_STIFFNESS, 144, stiffness));
  must(rollcon_body_prepare(pad[0]));
  must(rollcon_body_write_condensed(pad[0], ROLLCON_FLEXIBILITY, "each_call.mtx"));
  must(rollcon_body_read_condensed(pad[1], ROLLCON_FLEXIBILITY, "each_call.mtx"));
  must(rollcon_body_prepare(pad[1]));
  printf("a pad by its stiffness, and by its flexibility\n");
  rollcon_body_release(pad[0]);
  rollcon_body_release(pad[1]);
}

static void tables_of_bodies(void) {
  int32_t type;
  double low, high, usual;
  char text[400];
  if (rollcon_option_count(ROLLCON_OF_BODY) < 1 || rollcon_stat_count(ROLLCON_OF_BODY) < 1) exit(1);
  must(rollcon_option_info(ROLLCON_OF_BODY, 0, sizeof text, text, NULL, NULL, &type, &low, &high, &usual));
  printf("first option %s, %g to %g, standard %g\n", text, low, high, usual);
  must(rollcon_stat_info(ROLLCON_OF_BODY, 0, sizeof text, text, NULL, NULL, NULL));
  printf("first statistic %s\n", text);
}

static void profiles(rollcon_context* context) {
  const double points[8] = {-1, 0, 0, 0, 1, 0, 2, 0}; /* y, z */
  const double origin[3] = {0, 0, 0}, along[3] = {1, 0, 0}, up[3] = {0, 0, 1};
  double length, point[2], tangent[2], curvature;
  FILE* list;
  rollcon_body* rail;
  must(rollcon_body_create(context, ROLLCON_BODY_RIGID, &rail));
  must(rollcon_body_set_profile(rail, 4, points, 0));
  must(rollcon_body_write_profile(rail, "each_call.txt", 1));
  must(rollcon_body_read_profile(rail, "each_call.txt", 1, 1, 0)); /* mirrored in y */
  list = fopen("each_call.slcs", "w"); /* lists the profile at 0 and 10: offset, scale, counts, interpolation, places */
  if (!list) exit(1);
  fprintf(list, "0 1\n2\n0 0 0\n1\n0 'each_call.txt'\n10 'each_call.txt'\n");
  fclose(list);
  must(rollcon_body_read_slices(rail, "each_call.slcs", 1, 1, 0, 0));
  must(rollcon_body_add_slice(rail, 20, 0, NULL)); /* is there once more 20 ahead */
  must(rollcon_body_add_wave(rail, 0.01, 5, 0));
  must(rollcon_body_extrude_profile(rail, origin, along, up));
  must(rollcon_body_get_profile_length(rail, &length));
  must(rollcon_body_get_profile_point(rail, length / 2, point, tangent, &curvature));
  printf("a profile of length %.1f, its middle at y = %.1f\n", length, point[0]);
  rollcon_body_release(rail);
}

static void frame(rollcon_context* context) {
  rollcon_body *a, *b;
  rollcon_contact* contact;
  int64_t nodes, elements;
  must(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &a));
  must(rollcon_body_create(context, ROLLCON_BODY_RIGID, &b));
  must(rollcon_contact_create(context, a, b, &contact));
  must(rollcon_contact_frame_from_file(contact, "each_call.inp", "patch"));
  must(rollcon_contact_get_size(contact, &nodes, &elements));
  printf("a frame of %d nodes, %d element\n", (int)nodes, (int)elements);
  rollcon_contact_release(contact);
  rollcon_body_release(a);
  rollcon_body_release(b);
}

int main(void) {
  rollcon_context* context;
  int lines = 0;
  facts();
  must(rollcon_context_create(ROLLCON_ABI, &context));
  contexts(context, &lines);
  write_mesh("each_call.inp");
  mesh(context);
  pressed(context);
  if (rollcon_has_feature("fem")) section(context);
  if (rollcon_has_feature("fem")) condensed(context);
  tables_of_bodies();
  profiles(context);
  frame(context);
  rollcon_context_release(context);
  remove("each_call.inp");
  remove("each_call.mtx");
  remove("each_call.body");
  remove("each_call.txt");
  remove("each_call.vtu");
  return 0;
}
