/* Generated from bindings/api.toml by bindings/generate.py; do not edit. */
#include "gateway.h"

/* clang-format off */
static const enumerator no_names[] = {{NULL, 0}};
static const enumerator names_of_axes[] = {
  {"local", 0},
  {"global", 1},
  {NULL, 0}};
static const enumerator names_of_axes_of_points[] = {
  {"contact", 0},
  {"body", 1},
  {"in_contact", 0},
  {"in_body", 1},
  {NULL, 0}};
static const enumerator names_of_axes_of_the_track[] = {
  {"track", 0},
  {"wheelset", 1},
  {"in_track", 0},
  {"in_wheelset", 1},
  {NULL, 0}};
static const enumerator names_of_body_kind[] = {
  {"fem", 1},
  {"bem", 2},
  {"halfspace", 3},
  {"rigid", 4},
  {"section", 5},
  {"body_fem", 1},
  {"body_bem", 2},
  {"body_halfspace", 3},
  {"body_rigid", 4},
  {"body_section", 5},
  {NULL, 0}};
static const enumerator names_of_body_of_a_contact[] = {
  {"body1", 1},
  {"body2", 2},
  {NULL, 0}};
static const enumerator names_of_body_of_a_contact_or_moving_contact[] = {
  {"body1", 1},
  {"body2", 2},
  {"itself", 0},
  {"contact_itself", 0},
  {NULL, 0}};
static const enumerator names_of_direction[] = {
  {"longitudinal", 1},
  {"lateral", 2},
  {"normal", 3},
  {"spin", 4},
  {"tilt_1", 6},
  {"tilt_2", 7},
  {NULL, 0}};
static const enumerator names_of_direction_or_parameter[] = {
  {"longitudinal", 1},
  {"lateral", 2},
  {"normal", 3},
  {"spin", 4},
  {"tilt_1", 6},
  {"tilt_2", 7},
  {"friction", 5},
  {NULL, 0}};
static const enumerator names_of_dof[] = {
  {"x", 1},
  {"y", 2},
  {"z", 4},
  {"xyz", 7},
  {"dof_x", 1},
  {"dof_y", 2},
  {"dof_z", 4},
  {"dof_xyz", 7},
  {NULL, 0}};
static const enumerator names_of_element_type[] = {
  {"tri3", 203},
  {"tri6", 206},
  {"quad4", 214},
  {"quad8", 218},
  {"quad9", 219},
  {"tet4", 304},
  {"tet10", 310},
  {"wedge6", 326},
  {"wedge15", 335},
  {"hex8", 338},
  {"hex20", 350},
  {NULL, 0}};
static const enumerator names_of_field[] = {
  {"point", 1},
  {"traction", 2},
  {"gap", 3},
  {"slip", 4},
  {"displacement1", 5},
  {"displacement2", 6},
  {"area", 7},
  {"friction", 8},
  {"pressure", 9},
  {"rigid_slip", 10},
  {"friction_power", 11},
  {"weight", 12},
  {"temperature", 13},
  {"field_point", 1},
  {"field_traction", 2},
  {"field_gap", 3},
  {"field_slip", 4},
  {"field_displacement1", 5},
  {"field_displacement2", 6},
  {"field_area", 7},
  {"field_friction", 8},
  {"field_pressure", 9},
  {"field_rigid_slip", 10},
  {"field_friction_power", 11},
  {"field_weight", 12},
  {"field_temperature", 13},
  {NULL, 0}};
static const enumerator names_of_how[] = {
  {"motion", 1},
  {"force", 2},
  {"by_motion", 1},
  {"by_force", 2},
  {NULL, 0}};
static const enumerator names_of_inside_of_a_profile[] = {
  {"below", 1},
  {"above", -1},
  {"body_below", 1},
  {"body_above", -1},
  {NULL, 0}};
static const enumerator names_of_kind_of_object[] = {
  {"body", 2},
  {"contact", 3},
  {"wheelrail", 4},
  {"patch", 6},
  {"procedure", 7},
  {"of_body", 2},
  {"of_contact", 3},
  {"of_wheelrail", 4},
  {"of_patch", 6},
  {"of_procedure", 7},
  {NULL, 0}};
static const enumerator names_of_profile_of_a_wheel_on_its_rail[] = {
  {"wheel", 1},
  {"rail", 2},
  {NULL, 0}};
static const enumerator names_of_side[] = {
  {"left", -1},
  {"right", 1},
  {NULL, 0}};
static const enumerator names_of_step[] = {
  {"steady", 0},
  {"rolling_step", 1},
  {"shift_step", 2},
  {NULL, 0}};

static void call_version(call *self) {
  no_more(self);
  give_real(self, rollcon_version());
}

static void call_version_string(call *self) {
  no_more(self);
  give_text(self, rollcon_version_string());
}

static void call_build_info(call *self) {
  no_more(self);
  give_text(self, rollcon_build_info());
}

static void call_has_feature(call *self) {
  const char *name = take_text(self, "name");
  no_more(self);
  give_real(self, rollcon_has_feature(name));
}

static void call_status_string(call *self) {
  const int32_t status = take_enumerator(self, "status", no_names, 0);
  no_more(self);
  give_text(self, rollcon_status_string(status));
}

static void call_last_error(call *self) {
  no_more(self);
  give_text(self, rollcon_last_error());
}

static void call_last_caveat(call *self) {
  no_more(self);
  give_text(self, rollcon_last_caveat());
}

static void call_context_create(call *self) {
  int32_t rc = 0;
  rollcon_context *context = NULL;
  no_more(self);
  rc = rollcon_context_create(ROLLCON_ABI, &context);
  if (rc < 0) finish(self, rc);
  give_real(self, rollcon_id_of(context));
  finish(self, rc);
}

static void call_context_release(call *self) {
  rollcon_context *context = rollcon_context_from_id(take_handle(self, "context"));
  no_more(self);
  rollcon_context_release(context);
}

static void call_context_set_threads(call *self) {
  int32_t rc = 0;
  rollcon_context *context = rollcon_context_from_id(take_handle(self, "context"));
  const int32_t n = take_enumerator(self, "n", no_names, 0);
  no_more(self);
  rc = rollcon_context_set_threads(context, n);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_context_set_latch(call *self) {
  int32_t rc = 0;
  rollcon_context *context = rollcon_context_from_id(take_handle(self, "context"));
  const int32_t on = has_more(self) ? take_enumerator(self, "on", no_names, 0) : 1;
  no_more(self);
  rc = rollcon_context_set_latch(context, on);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_context_check(call *self) {
  int32_t rc = 0;
  rollcon_context *context = rollcon_context_from_id(take_handle(self, "context"));
  no_more(self);
  rc = rollcon_context_check(context);
  if (rc < 0) finish(self, rc);
  give_real(self, rc);
  finish(self, rc);
}

static void call_body_create(call *self) {
  int32_t rc = 0;
  rollcon_context *context = rollcon_context_from_id(take_handle(self, "context"));
  const int32_t kind = take_enumerator(self, "kind", names_of_body_kind, 0);
  rollcon_body *body = NULL;
  no_more(self);
  rc = rollcon_body_create(context, kind, &body);
  if (rc < 0) finish(self, rc);
  give_real(self, rollcon_id_of(body));
  finish(self, rc);
}

static void call_body_release(call *self) {
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  no_more(self);
  rollcon_body_release(body);
}

static void call_body_set_elastic(call *self) {
  int32_t rc = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const int32_t tag = has_more(self) ? take_enumerator(self, "tag", no_names, 0) : 0;
  const double young = take_real(self, "young");
  const double poisson = take_real(self, "poisson");
  no_more(self);
  rc = rollcon_body_set_elastic(body, tag, young, poisson);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_body_set_viscoelastic(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const int32_t tag = has_more(self) ? take_enumerator(self, "tag", no_names, 0) : 0;
  const double *ratios = take_reals(self, "ratios", &n, 0, 0);
  const double *times = take_reals(self, "times", &n, 0, 0);
  no_more(self);
  rc = rollcon_body_set_viscoelastic(body, tag, n, ratios, times);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_body_prepare(call *self) {
  int32_t rc = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  no_more(self);
  rc = rollcon_body_prepare(body);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_body_get_kind(call *self) {
  int32_t rc = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  int32_t kind = 0;
  no_more(self);
  rc = rollcon_body_get_kind(body, &kind);
  if (rc < 0) finish(self, rc);
  give_real(self, (double)kind);
  finish(self, rc);
}

static void call_body_save(call *self) {
  int32_t rc = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const char *path = take_text(self, "path");
  no_more(self);
  rc = rollcon_body_save(body, path);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_body_load(call *self) {
  int32_t rc = 0;
  rollcon_context *context = rollcon_context_from_id(take_handle(self, "context"));
  const char *path = take_text(self, "path");
  rollcon_body *body = NULL;
  no_more(self);
  rc = rollcon_body_load(context, path, &body);
  if (rc < 0) finish(self, rc);
  give_real(self, rollcon_id_of(body));
  finish(self, rc);
}

static void call_body_copy(call *self) {
  int32_t rc = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  rollcon_body *copy = NULL;
  no_more(self);
  rc = rollcon_body_copy(body, &copy);
  if (rc < 0) finish(self, rc);
  give_real(self, rollcon_id_of(copy));
  finish(self, rc);
}

static void call_body_set_nodes(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const double *x = take_columns(self, "x", &n);
  no_more(self);
  rc = rollcon_body_set_nodes(body, n, x, 1, n);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_body_add_elements(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const int32_t type = take_enumerator(self, "type", names_of_element_type, 0);
  const int32_t *connectivity = take_integers(self, "connectivity", &n, nodes_of_type(type));
  const int32_t tag = take_enumerator(self, "tag", no_names, 0);
  no_more(self);
  rc = rollcon_body_add_elements(body, type, n, connectivity, 1, tag);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_body_tag_faces(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const int32_t *elements = take_integers(self, "elements", &n, 0);
  const int32_t *faces = take_integers(self, "faces", &n, 0);
  const int32_t tag = take_enumerator(self, "tag", no_names, 0);
  no_more(self);
  rc = rollcon_body_tag_faces(body, n, elements, faces, 1, tag);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_body_tag_faces_of_nodes(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const int32_t *nodes = take_integers(self, "nodes", &n, 0);
  const int32_t tag = take_enumerator(self, "tag", no_names, 0);
  no_more(self);
  rc = rollcon_body_tag_faces_of_nodes(body, n, nodes, 1, tag);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_body_set_support(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const int32_t *nodes = take_integers(self, "nodes", &n, 0);
  const int32_t dof_mask = take_enumerator(self, "dof_mask", names_of_dof, 1);
  const double *values = take_reals(self, "values", &n, 3, 1);
  no_more(self);
  rc = rollcon_body_set_support(body, n, nodes, 1, dof_mask, values);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_body_set_traction(call *self) {
  int32_t rc = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const int32_t tag = take_enumerator(self, "tag", no_names, 0);
  int64_t traction_rows = 3;
  const double *traction = take_reals(self, "traction", &traction_rows, 0, 0);
  no_more(self);
  rc = rollcon_body_set_traction(body, tag, traction);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_body_set_body_force(call *self) {
  int32_t rc = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const int32_t tag = take_enumerator(self, "tag", no_names, 0);
  int64_t force_rows = 3;
  const double *force = take_reals(self, "force", &force_rows, 0, 0);
  no_more(self);
  rc = rollcon_body_set_body_force(body, tag, force);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_body_set_rotation(call *self) {
  int32_t rc = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const int32_t tag = take_enumerator(self, "tag", no_names, 0);
  const double density = take_real(self, "density");
  int64_t origin_rows = 3;
  const double *origin = take_reals(self, "origin", &origin_rows, 0, 0);
  int64_t rate_rows = 3;
  const double *rate = take_reals(self, "rate", &rate_rows, 0, 0);
  no_more(self);
  rc = rollcon_body_set_rotation(body, tag, density, origin, rate);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_body_set_pressure(call *self) {
  int32_t rc = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const int32_t tag = take_enumerator(self, "tag", no_names, 0);
  const double pressure = take_real(self, "pressure");
  no_more(self);
  rc = rollcon_body_set_pressure(body, tag, pressure);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_body_set_springs(call *self) {
  int32_t rc = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const int32_t tag = take_enumerator(self, "tag", no_names, 0);
  int64_t stiffness_rows = 3;
  const double *stiffness = take_reals(self, "stiffness", &stiffness_rows, 0, 0);
  no_more(self);
  rc = rollcon_body_set_springs(body, tag, stiffness);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_body_set_node_tractions(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const int32_t tag = take_enumerator(self, "tag", no_names, 0);
  const int32_t *nodes = take_integers(self, "nodes", &n, 0);
  int64_t along_rows = 3;
  const double *along = take_reals(self, "along", &along_rows, 0, 1);
  const double *tractions = take_reals(self, "tractions", &n, 3, 0);
  no_more(self);
  rc = rollcon_body_set_node_tractions(body, tag, n, nodes, 1, along, tractions);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_body_set_contact_faces(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const int32_t *tags = take_integers(self, "tags", &n, 0);
  no_more(self);
  rc = rollcon_body_set_contact_faces(body, n < 0 ? 0 : n, tags);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_body_revolve(call *self) {
  int32_t rc = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  int64_t origin_rows = 3;
  const double *origin = take_reals(self, "origin", &origin_rows, 0, 0);
  int64_t axis_rows = 3;
  const double *axis = take_reals(self, "axis", &axis_rows, 0, 0);
  no_more(self);
  rc = rollcon_body_revolve(body, origin, axis);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_body_extrude(call *self) {
  int32_t rc = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  int64_t origin_rows = 3;
  const double *origin = take_reals(self, "origin", &origin_rows, 0, 0);
  int64_t direction_rows = 3;
  const double *direction = take_reals(self, "direction", &direction_rows, 0, 0);
  const double period = take_real(self, "period");
  no_more(self);
  rc = rollcon_body_extrude(body, origin, direction, period);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_body_read_mesh(call *self) {
  int32_t rc = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const char *path = take_text(self, "path");
  const char *part = has_more(self) ? take_text(self, "part") : "";
  no_more(self);
  rc = rollcon_body_read_mesh(body, path, part);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_body_tag_group(call *self) {
  int32_t rc = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const char *group = take_text(self, "group");
  const int32_t tag = take_enumerator(self, "tag", no_names, 0);
  no_more(self);
  rc = rollcon_body_tag_group(body, group, tag);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_body_get_group_count(call *self) {
  int32_t rc = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  int32_t n = 0;
  no_more(self);
  rc = rollcon_body_get_group_count(body, &n);
  if (rc < 0) finish(self, rc);
  give_real(self, (double)n);
  finish(self, rc);
}

static void call_body_get_group_name(call *self) {
  int32_t rc = 0;
  int64_t capacity = 0;
  int64_t need = 0;
  char *text_buffer = NULL;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const int32_t i = (int32_t)take_integer(self, "i") - 1;
  no_more(self);
  rc = rollcon_body_get_group_name(body, i, capacity, text_buffer, &need);
  if (rc < 0) finish(self, rc);
  capacity = need;
  text_buffer = room(capacity, 1);
  rc = rollcon_body_get_group_name(body, i, capacity, text_buffer, &need);
  if (rc < 0) finish(self, rc);
  give_text(self, text_buffer);
  finish(self, rc);
}

static void call_body_get_group_nodes(call *self) {
  int32_t rc = 0;
  int64_t capacity = 0;
  int64_t need = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const char *group = take_text(self, "group");
  int32_t *nodes = NULL;
  no_more(self);
  rc = rollcon_body_get_group_nodes(body, group, 1, capacity, nodes, &need);
  if (rc < 0) finish(self, rc);
  capacity = need;
  nodes = room(capacity * (1), sizeof *nodes);
  rc = rollcon_body_get_group_nodes(body, group, 1, capacity, nodes, &need);
  if (rc < 0) finish(self, rc);
  give_integers(self, nodes, capacity, 0);
  finish(self, rc);
}

static void call_body_set_int(call *self) {
  int32_t rc = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const char *name = take_text(self, "name");
  const int64_t value = take_integer(self, "value");
  no_more(self);
  rc = rollcon_body_set_int(body, name, value);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_body_set_real(call *self) {
  int32_t rc = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const char *name = take_text(self, "name");
  const double value = take_real(self, "value");
  no_more(self);
  rc = rollcon_body_set_real(body, name, value);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_body_get_int(call *self) {
  int32_t rc = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const char *name = take_text(self, "name");
  int64_t value = 0;
  no_more(self);
  rc = rollcon_body_get_int(body, name, &value);
  if (rc < 0) finish(self, rc);
  give_real(self, (double)value);
  finish(self, rc);
}

static void call_body_get_real(call *self) {
  int32_t rc = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const char *name = take_text(self, "name");
  double value = 0;
  no_more(self);
  rc = rollcon_body_get_real(body, name, &value);
  if (rc < 0) finish(self, rc);
  give_real(self, (double)value);
  finish(self, rc);
}

static void call_body_set_profile(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const double *points = take_reals(self, "points", &n, 2, 0);
  const double filter_length = has_more(self) ? take_real(self, "filter_length") : 0;
  no_more(self);
  rc = rollcon_body_set_profile(body, n, points, filter_length);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_body_set_profile_shape(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const char *shape = take_text(self, "shape");
  const double *parameters = take_reals(self, "parameters", &n, 0, 0);
  no_more(self);
  rc = rollcon_body_set_profile_shape(body, shape, n, parameters);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_body_read_profile(call *self) {
  int32_t rc = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const char *path = take_text(self, "path");
  const double unit = take_real(self, "unit");
  const int32_t mirror = has_more(self) ? take_enumerator(self, "mirror", no_names, 0) : 0;
  const double filter_length = has_more(self) ? take_real(self, "filter_length") : 0;
  no_more(self);
  rc = rollcon_body_read_profile(body, path, unit, mirror, filter_length);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_body_write_profile(call *self) {
  int32_t rc = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const char *path = take_text(self, "path");
  const double unit = take_real(self, "unit");
  no_more(self);
  rc = rollcon_body_write_profile(body, path, unit);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_body_extrude_profile(call *self) {
  int32_t rc = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  int64_t origin_rows = 3;
  const double *origin = take_reals(self, "origin", &origin_rows, 0, 0);
  int64_t along_rows = 3;
  const double *along = take_reals(self, "along", &along_rows, 0, 0);
  int64_t z_axis_rows = 3;
  const double *z_axis = take_reals(self, "z_axis", &z_axis_rows, 0, 0);
  no_more(self);
  rc = rollcon_body_extrude_profile(body, origin, along, z_axis);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_body_revolve_profile(call *self) {
  int32_t rc = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  int64_t origin_rows = 3;
  const double *origin = take_reals(self, "origin", &origin_rows, 0, 0);
  int64_t axis_rows = 3;
  const double *axis = take_reals(self, "axis", &axis_rows, 0, 0);
  const double radius = take_real(self, "radius");
  no_more(self);
  rc = rollcon_body_revolve_profile(body, origin, axis, radius);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_body_get_profile_length(call *self) {
  int32_t rc = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  double length = 0;
  no_more(self);
  rc = rollcon_body_get_profile_length(body, &length);
  if (rc < 0) finish(self, rc);
  give_real(self, (double)length);
  finish(self, rc);
}

static void call_body_get_profile_point(call *self) {
  int32_t rc = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const double s = take_real(self, "s");
  double *point = NULL;
  double *tangent = NULL;
  double curvature = 0;
  no_more(self);
  point = room(1 * (2), sizeof *point);
  tangent = room(1 * (2), sizeof *tangent);
  rc = rollcon_body_get_profile_point(body, s, point, tangent, &curvature);
  if (rc < 0) finish(self, rc);
  give_reals(self, point, 1, 2);
  give_reals(self, tangent, 1, 2);
  give_real(self, (double)curvature);
  finish(self, rc);
}

static void call_body_get_size(call *self) {
  int32_t rc = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  int64_t nodes = 0;
  int64_t elements = 0;
  no_more(self);
  rc = rollcon_body_get_size(body, &nodes, &elements);
  if (rc < 0) finish(self, rc);
  give_real(self, (double)nodes);
  give_real(self, (double)elements);
  finish(self, rc);
}

static void call_body_get_displacements(call *self) {
  int32_t rc = 0;
  int64_t capacity = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  double *u = NULL;
  no_more(self);
  rollcon_body_get_size(body, &capacity, NULL);
  u = room(capacity * (3), sizeof *u);
  rc = rollcon_body_get_displacements(body, capacity, u);
  if (rc < 0) finish(self, rc);
  give_reals(self, u, capacity, 3);
  finish(self, rc);
}

static void call_body_get_node_stresses(call *self) {
  int32_t rc = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const int64_t nodes = take_integer(self, "nodes");
  int64_t u_rows = nodes;
  const double *u = take_reals(self, "u", &u_rows, 3, 1);
  double *stress = NULL;
  no_more(self);
  stress = room(1 * (nodes * 6), sizeof *stress);
  rc = rollcon_body_get_node_stresses(body, nodes, u, stress);
  if (rc < 0) finish(self, rc);
  give_reals(self, stress, 1, nodes * 6);
  finish(self, rc);
}

static void call_body_get_point_stresses(call *self) {
  int32_t rc = 0;
  int64_t capacity = 0;
  int64_t need = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const int64_t nodes = take_integer(self, "nodes");
  int64_t u_rows = nodes;
  const double *u = take_reals(self, "u", &u_rows, 3, 1);
  double *stress = NULL;
  double *xyz = NULL;
  no_more(self);
  rc = rollcon_body_get_point_stresses(body, nodes, u, capacity, stress, xyz, &need);
  if (rc < 0) finish(self, rc);
  capacity = need;
  stress = room(capacity * (6), sizeof *stress);
  xyz = room(capacity * (3), sizeof *xyz);
  rc = rollcon_body_get_point_stresses(body, nodes, u, capacity, stress, xyz, &need);
  if (rc < 0) finish(self, rc);
  give_reals(self, stress, capacity, 6);
  give_reals(self, xyz, capacity, 3);
  finish(self, rc);
}

static void call_body_get_fields_at(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const int64_t nodes = take_integer(self, "nodes");
  int64_t u_rows = nodes;
  const double *u = take_reals(self, "u", &u_rows, 3, 1);
  const double *xyz = take_reals(self, "xyz", &n, 3, 0);
  double *displacement = NULL;
  double *stress = NULL;
  no_more(self);
  displacement = room(n * (3), sizeof *displacement);
  stress = room(n * (6), sizeof *stress);
  rc = rollcon_body_get_fields_at(body, nodes, u, n, xyz, displacement, stress);
  if (rc < 0) finish(self, rc);
  give_reals(self, displacement, n, 3);
  give_reals(self, stress, n, 6);
  finish(self, rc);
}

static void call_body_write(call *self) {
  int32_t rc = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const char *path = take_text(self, "path");
  const int64_t nodes = take_integer(self, "nodes");
  int64_t u_rows = nodes;
  const double *u = take_reals(self, "u", &u_rows, 3, 1);
  no_more(self);
  rc = rollcon_body_write(body, path, nodes, u);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_body_get_reaction(call *self) {
  int32_t rc = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  double *force = NULL;
  double *moment = NULL;
  no_more(self);
  force = room(1 * (3), sizeof *force);
  moment = room(1 * (3), sizeof *moment);
  rc = rollcon_body_get_reaction(body, force, moment);
  if (rc < 0) finish(self, rc);
  give_reals(self, force, 1, 3);
  give_reals(self, moment, 1, 3);
  finish(self, rc);
}

static void call_body_get_stat(call *self) {
  int32_t rc = 0;
  rollcon_body *body = rollcon_body_from_id(take_handle(self, "body"));
  const char *name = take_text(self, "name");
  double value = 0;
  no_more(self);
  rc = rollcon_body_get_stat(body, name, &value);
  if (rc < 0) finish(self, rc);
  give_real(self, (double)value);
  finish(self, rc);
}

static void call_contact_create(call *self) {
  int32_t rc = 0;
  rollcon_context *context = rollcon_context_from_id(take_handle(self, "context"));
  rollcon_body *body1 = rollcon_body_from_id(take_handle(self, "body1"));
  rollcon_body *body2 = rollcon_body_from_id(take_handle(self, "body2"));
  rollcon_contact *contact = NULL;
  no_more(self);
  rc = rollcon_contact_create(context, body1, body2, &contact);
  if (rc < 0) finish(self, rc);
  give_real(self, rollcon_id_of(contact));
  finish(self, rc);
}

static void call_contact_release(call *self) {
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  no_more(self);
  rollcon_contact_release(contact);
}

static void call_contact_frame_nodes(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const double *x = take_columns(self, "x", &n);
  no_more(self);
  rc = rollcon_contact_frame_nodes(contact, n, x, 1, n);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_frame_add_elements(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const int32_t type = take_enumerator(self, "type", names_of_element_type, 0);
  const int32_t *connectivity = take_integers(self, "connectivity", &n, nodes_of_type(type));
  const int32_t tag = take_enumerator(self, "tag", no_names, 0);
  no_more(self);
  rc = rollcon_contact_frame_add_elements(contact, type, n, connectivity, 1, tag);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_frame_from_file(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const char *path = take_text(self, "path");
  const char *part = has_more(self) ? take_text(self, "part") : "";
  no_more(self);
  rc = rollcon_contact_frame_from_file(contact, path, part);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_frame_from_body(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const int32_t which = take_enumerator(self, "which", names_of_body_of_a_contact, 0);
  const int32_t tag = take_enumerator(self, "tag", no_names, 0);
  no_more(self);
  rc = rollcon_contact_frame_from_body(contact, which, tag);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_frame_rectangle(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const int32_t type = take_enumerator(self, "type", names_of_element_type, 0);
  const int32_t nx = take_enumerator(self, "nx", no_names, 0);
  const int32_t ny = take_enumerator(self, "ny", no_names, 0);
  const double x_least = take_real(self, "x_least");
  const double x_greatest = take_real(self, "x_greatest");
  const double y_least = take_real(self, "y_least");
  const double y_greatest = take_real(self, "y_greatest");
  no_more(self);
  rc = rollcon_contact_frame_rectangle(contact, type, nx, ny, x_least, x_greatest, y_least, y_greatest);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_frame_ellipse(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const int32_t along = take_enumerator(self, "along", no_names, 0);
  const int32_t across = take_enumerator(self, "across", no_names, 0);
  const double a = take_real(self, "a");
  const double b = take_real(self, "b");
  const double angle = has_more(self) ? take_real(self, "angle") : 0;
  no_more(self);
  rc = rollcon_contact_frame_ellipse(contact, along, across, a, b, angle);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_frame_strips(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const int32_t along = take_enumerator(self, "along", no_names, 0);
  const double *lines = take_reals(self, "lines", &n, 3, 0);
  no_more(self);
  rc = rollcon_contact_frame_strips(contact, along, n, lines);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_frame_automatic(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  no_more(self);
  rc = rollcon_contact_frame_automatic(contact);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_set_pose(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const int32_t which = take_enumerator(self, "which", names_of_body_of_a_contact, 0);
  int64_t rotation_rows = 3;
  const double *rotation = take_reals(self, "rotation", &rotation_rows, 3, 0);
  int64_t translation_rows = 3;
  const double *translation = take_reals(self, "translation", &translation_rows, 0, 0);
  no_more(self);
  rc = rollcon_contact_set_pose(contact, which, rotation, translation);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_set_axes(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  int64_t origin_rows = 3;
  const double *origin = take_reals(self, "origin", &origin_rows, 0, 0);
  int64_t rolling_rows = 3;
  const double *rolling = take_reals(self, "rolling", &rolling_rows, 0, 0);
  int64_t normal_rows = 3;
  const double *normal = take_reals(self, "normal", &normal_rows, 0, 0);
  no_more(self);
  rc = rollcon_contact_set_axes(contact, origin, rolling, normal);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_set_gap(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const double *gap = take_reals(self, "gap", &n, 0, 0);
  no_more(self);
  rc = rollcon_contact_set_gap(contact, n, gap);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_set_gap_quadratic(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const double a = take_real(self, "a");
  const double b = take_real(self, "b");
  const double c = has_more(self) ? take_real(self, "c") : 0.0;
  no_more(self);
  rc = rollcon_contact_set_gap_quadratic(contact, a, b, c);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_set_gap_grid(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const int32_t nx = take_enumerator(self, "nx", no_names, 0);
  const double x_least = take_real(self, "x_least");
  const double x_greatest = take_real(self, "x_greatest");
  const double y_least = take_real(self, "y_least");
  const double y_greatest = take_real(self, "y_greatest");
  const double *gap = take_reals(self, "gap", &n, 0, 0);
  no_more(self);
  rc = rollcon_contact_set_gap_grid(contact, nx, x_least, x_greatest, y_least, y_greatest, n, gap);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_set_rolling(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const double speed = take_real(self, "speed");
  no_more(self);
  rc = rollcon_contact_set_rolling(contact, speed);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_set_creep(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const double longitudinal = has_more(self) ? take_real(self, "longitudinal") : 0.0;
  const double lateral = has_more(self) ? take_real(self, "lateral") : 0.0;
  const double spin = has_more(self) ? take_real(self, "spin") : 0.0;
  no_more(self);
  rc = rollcon_contact_set_creep(contact, longitudinal, lateral, spin);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_set_step(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const int32_t kind = take_enumerator(self, "kind", names_of_step, 0);
  const double dt = has_more(self) ? take_real(self, "dt") : 0.0;
  no_more(self);
  rc = rollcon_contact_set_step(contact, kind, dt);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_set_velocity(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const int32_t which = take_enumerator(self, "which", names_of_body_of_a_contact_or_moving_contact, 0);
  int64_t velocity_rows = 3;
  const double *velocity = take_reals(self, "velocity", &velocity_rows, 0, 0);
  int64_t angular_velocity_rows = 3;
  const double *angular_velocity = take_reals(self, "angular_velocity", &angular_velocity_rows, 0, 0);
  int64_t point_rows = 3;
  const double *point = take_reals(self, "point", &point_rows, 0, 0);
  no_more(self);
  rc = rollcon_contact_set_velocity(contact, which, velocity, angular_velocity, point);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_set_creep_field(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const double *slip = take_reals(self, "slip", &n, 2, 1);
  no_more(self);
  rc = rollcon_contact_set_creep_field(contact, n < 0 ? 0 : n, slip);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_prescribe(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const int32_t direction = take_enumerator(self, "direction", names_of_direction, 0);
  const int32_t how = take_enumerator(self, "how", names_of_how, 0);
  const double value = take_real(self, "value");
  no_more(self);
  rc = rollcon_contact_prescribe(contact, direction, how, value);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_set_friction(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const char *law = take_text(self, "law");
  const double *parameters = take_reals(self, "parameters", &n, 0, 0);
  no_more(self);
  rc = rollcon_contact_set_friction(contact, law, n, parameters);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_set_friction_memory(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const double length = take_real(self, "length");
  const double least_speed = take_real(self, "least_speed");
  no_more(self);
  rc = rollcon_contact_set_friction_memory(contact, length, least_speed);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_set_layer(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const double flexibility = take_real(self, "flexibility");
  const double stress = has_more(self) ? take_real(self, "stress") : 0;
  const double hardening = has_more(self) ? take_real(self, "hardening") : 0;
  no_more(self);
  rc = rollcon_contact_set_layer(contact, flexibility, stress, hardening);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_set_friction_across(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const double *points = take_reals(self, "points", &n, 2, 1);
  no_more(self);
  rc = rollcon_contact_set_friction_across(contact, n < 0 ? 0 : n, points);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_set_heat(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const int32_t which = take_enumerator(self, "which", names_of_body_of_a_contact, 0);
  const double conductivity = take_real(self, "conductivity");
  const double heat_capacity = take_real(self, "heat_capacity");
  const double temperature = take_real(self, "temperature");
  no_more(self);
  rc = rollcon_contact_set_heat(contact, which, conductivity, heat_capacity, temperature);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_set_friction_field(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const double *mu = take_reals(self, "mu", &n, 0, 1);
  no_more(self);
  rc = rollcon_contact_set_friction_field(contact, n < 0 ? 0 : n, mu);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_set_int(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const char *name = take_text(self, "name");
  const int64_t value = take_integer(self, "value");
  no_more(self);
  rc = rollcon_contact_set_int(contact, name, value);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_set_real(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const char *name = take_text(self, "name");
  const double value = take_real(self, "value");
  no_more(self);
  rc = rollcon_contact_set_real(contact, name, value);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_set_str(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const char *name = take_text(self, "name");
  const char *value = take_text(self, "value");
  no_more(self);
  rc = rollcon_contact_set_str(contact, name, value);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_get_int(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const char *name = take_text(self, "name");
  int64_t value = 0;
  no_more(self);
  rc = rollcon_contact_get_int(contact, name, &value);
  if (rc < 0) finish(self, rc);
  give_real(self, (double)value);
  finish(self, rc);
}

static void call_contact_get_real(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const char *name = take_text(self, "name");
  double value = 0;
  no_more(self);
  rc = rollcon_contact_get_real(contact, name, &value);
  if (rc < 0) finish(self, rc);
  give_real(self, (double)value);
  finish(self, rc);
}

static void call_contact_get_str(call *self) {
  int32_t rc = 0;
  int64_t capacity = 0;
  int64_t need = 0;
  char *text_buffer = NULL;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const char *name = take_text(self, "name");
  no_more(self);
  rc = rollcon_contact_get_str(contact, name, capacity, text_buffer, &need);
  if (rc < 0) finish(self, rc);
  capacity = need;
  text_buffer = room(capacity, 1);
  rc = rollcon_contact_get_str(contact, name, capacity, text_buffer, &need);
  if (rc < 0) finish(self, rc);
  give_text(self, text_buffer);
  finish(self, rc);
}

static void call_contact_set_procedure(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const char *procedure = take_text(self, "procedure");
  no_more(self);
  rc = rollcon_contact_set_procedure(contact, procedure);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_request_cancel(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  no_more(self);
  rc = rollcon_contact_request_cancel(contact);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_solve(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  no_more(self);
  rc = rollcon_contact_solve(contact);
  if (rc < 0) finish(self, rc);
  give_real(self, rc);
  finish(self, rc);
}

static void call_contact_repeat_step(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  no_more(self);
  rc = rollcon_contact_repeat_step(contact);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_past_get(call *self) {
  int32_t rc = 0;
  int64_t capacity = 0;
  int64_t need = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  double *past = NULL;
  no_more(self);
  rc = rollcon_contact_past_get(contact, capacity, past, &need);
  if (rc < 0) finish(self, rc);
  capacity = need;
  past = room(capacity * (1), sizeof *past);
  rc = rollcon_contact_past_get(contact, capacity, past, &need);
  if (rc < 0) finish(self, rc);
  give_reals(self, past, capacity, 1);
  finish(self, rc);
}

static void call_contact_past_set(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const double *past = take_reals(self, "past", &n, 0, 0);
  no_more(self);
  rc = rollcon_contact_past_set(contact, n, past);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_reset(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  no_more(self);
  rc = rollcon_contact_reset(contact);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_get_size(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  int64_t nodes = 0;
  int64_t elements = 0;
  no_more(self);
  rc = rollcon_contact_get_size(contact, &nodes, &elements);
  if (rc < 0) finish(self, rc);
  give_real(self, (double)nodes);
  give_real(self, (double)elements);
  finish(self, rc);
}

static void call_contact_get_tractions(call *self) {
  int32_t rc = 0;
  int64_t capacity = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const int32_t axes = take_enumerator(self, "axes", names_of_axes, 0);
  double *t = NULL;
  no_more(self);
  rollcon_contact_get_size(contact, &capacity, NULL);
  t = room(capacity * (3), sizeof *t);
  rc = rollcon_contact_get_tractions(contact, axes, capacity, t);
  if (rc < 0) finish(self, rc);
  give_reals(self, t, capacity, 3);
  finish(self, rc);
}

static void call_contact_get_field(call *self) {
  int32_t rc = 0;
  int64_t capacity = 0;
  int64_t need = 0;
  int64_t nodes = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const int32_t field = take_enumerator(self, "field", names_of_field, 0);
  const int32_t axes = take_enumerator(self, "axes", names_of_axes, 0);
  double *v = NULL;
  no_more(self);
  rc = rollcon_contact_get_field(contact, field, axes, capacity, v, &need);
  if (rc < 0) finish(self, rc);
  capacity = need;
  rollcon_contact_get_size(contact, &nodes, NULL);
  v = room(capacity * (1), sizeof *v);
  rc = rollcon_contact_get_field(contact, field, axes, capacity, v, &need);
  if (rc < 0) finish(self, rc);
  give_reals(self, v, nodes > 0 ? nodes : 0, nodes > 0 ? capacity / nodes : 0);
  finish(self, rc);
}

static void call_contact_get_node_states(call *self) {
  int32_t rc = 0;
  int64_t capacity = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  int32_t *status = NULL;
  no_more(self);
  rollcon_contact_get_size(contact, &capacity, NULL);
  status = room(capacity * (1), sizeof *status);
  rc = rollcon_contact_get_node_states(contact, capacity, status);
  if (rc < 0) finish(self, rc);
  give_integers(self, status, capacity, 0);
  finish(self, rc);
}

static void call_contact_get_resultant(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const int32_t axes = has_more(self) ? take_enumerator(self, "axes", names_of_axes, 0) : ROLLCON_LOCAL;
  double *force = NULL;
  double *moment = NULL;
  no_more(self);
  force = room(1 * (3), sizeof *force);
  moment = room(1 * (3), sizeof *moment);
  rc = rollcon_contact_get_resultant(contact, axes, force, moment);
  if (rc < 0) finish(self, rc);
  give_reals(self, force, 1, 3);
  give_reals(self, moment, 1, 3);
  finish(self, rc);
}

static void call_contact_get_motion(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  double approach = 0;
  double *creep = NULL;
  no_more(self);
  creep = room(1 * (3), sizeof *creep);
  rc = rollcon_contact_get_motion(contact, &approach, creep);
  if (rc < 0) finish(self, rc);
  give_real(self, (double)approach);
  give_reals(self, creep, 1, 3);
  finish(self, rc);
}

static void call_contact_get_tilt(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  double *tilt = NULL;
  no_more(self);
  tilt = room(1 * (2), sizeof *tilt);
  rc = rollcon_contact_get_tilt(contact, tilt);
  if (rc < 0) finish(self, rc);
  give_reals(self, tilt, 1, 2);
  finish(self, rc);
}

static void call_contact_get_sensitivity(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const int32_t parameter = take_enumerator(self, "parameter", names_of_direction_or_parameter, 0);
  double *force = NULL;
  double *moment = NULL;
  double approach = 0;
  double *creep = NULL;
  no_more(self);
  force = room(1 * (3), sizeof *force);
  moment = room(1 * (3), sizeof *moment);
  creep = room(1 * (3), sizeof *creep);
  rc = rollcon_contact_get_sensitivity(contact, parameter, force, moment, &approach, creep);
  if (rc < 0) finish(self, rc);
  give_reals(self, force, 1, 3);
  give_reals(self, moment, 1, 3);
  give_real(self, (double)approach);
  give_reals(self, creep, 1, 3);
  finish(self, rc);
}

static void call_contact_get_displacements_at(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const int32_t which = take_enumerator(self, "which", names_of_body_of_a_contact, 0);
  const double *xy = take_reals(self, "xy", &n, 2, 0);
  double *u = NULL;
  no_more(self);
  u = room(n * (3), sizeof *u);
  rc = rollcon_contact_get_displacements_at(contact, which, n, xy, u);
  if (rc < 0) finish(self, rc);
  give_reals(self, u, n, 3);
  finish(self, rc);
}

static void call_contact_get_fields_at(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const int32_t which = take_enumerator(self, "which", names_of_body_of_a_contact, 0);
  const double *xyz = take_reals(self, "xyz", &n, 3, 0);
  const int32_t in_axes = take_enumerator(self, "in_axes", names_of_axes_of_points, 0);
  double *u = NULL;
  double *stress = NULL;
  no_more(self);
  u = room(n * (3), sizeof *u);
  stress = room(n * (6), sizeof *stress);
  rc = rollcon_contact_get_fields_at(contact, which, n, xyz, in_axes, u, stress);
  if (rc < 0) finish(self, rc);
  give_reals(self, u, n, 3);
  give_reals(self, stress, n, 6);
  finish(self, rc);
}

static void call_contact_get_body_displacements(call *self) {
  int32_t rc = 0;
  int64_t capacity = 0;
  int64_t need = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const int32_t which = take_enumerator(self, "which", names_of_body_of_a_contact, 0);
  double *u = NULL;
  no_more(self);
  rc = rollcon_contact_get_body_displacements(contact, which, capacity, u, &need);
  if (rc < 0) finish(self, rc);
  capacity = need;
  u = room(capacity * (1), sizeof *u);
  rc = rollcon_contact_get_body_displacements(contact, which, capacity, u, &need);
  if (rc < 0) finish(self, rc);
  give_reals(self, u, capacity, 1);
  finish(self, rc);
}

static void call_contact_write_body(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const int32_t which = take_enumerator(self, "which", names_of_body_of_a_contact, 0);
  const char *path = take_text(self, "path");
  no_more(self);
  rc = rollcon_contact_write_body(contact, which, path);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_contact_get_temperatures_at(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const double *xy = take_reals(self, "xy", &n, 2, 0);
  double *temperature = NULL;
  no_more(self);
  temperature = room(n * (2), sizeof *temperature);
  rc = rollcon_contact_get_temperatures_at(contact, n, xy, temperature);
  if (rc < 0) finish(self, rc);
  give_reals(self, temperature, n, 2);
  finish(self, rc);
}

static void call_contact_get_fatigue_index(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const double shear_yield = take_real(self, "shear_yield");
  double index = 0;
  no_more(self);
  rc = rollcon_contact_get_fatigue_index(contact, shear_yield, &index);
  if (rc < 0) finish(self, rc);
  give_real(self, (double)index);
  finish(self, rc);
}

static void call_contact_get_equivalent_ellipse(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  double *inputs = NULL;
  double *center = NULL;
  no_more(self);
  inputs = room(1 * (9), sizeof *inputs);
  center = room(1 * (2), sizeof *center);
  rc = rollcon_contact_get_equivalent_ellipse(contact, inputs, center);
  if (rc < 0) finish(self, rc);
  give_reals(self, inputs, 1, 9);
  give_reals(self, center, 1, 2);
  finish(self, rc);
}

static void call_contact_get_wear(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const char *law = take_text(self, "law");
  const double *parameters = take_reals(self, "parameters", &n, 0, 0);
  const int64_t points = take_integer(self, "points");
  int64_t y_rows = points;
  const double *y = take_reals(self, "y", &y_rows, 0, 0);
  double *depth = NULL;
  double volume = 0;
  no_more(self);
  depth = room(1 * (points), sizeof *depth);
  rc = rollcon_contact_get_wear(contact, law, n, parameters, points, y, depth, &volume);
  if (rc < 0) finish(self, rc);
  give_reals(self, depth, 1, points);
  give_real(self, (double)volume);
  finish(self, rc);
}

static void call_wear_profile(call *self) {
  int32_t rc = 0;
  const int64_t points = take_integer(self, "points");
  int64_t yz_rows = points;
  const double *yz = take_reals(self, "yz", &yz_rows, 2, 0);
  int64_t rate_rows = points;
  const double *rate = take_reals(self, "rate", &rate_rows, 0, 0);
  const int32_t side = take_enumerator(self, "side", names_of_inside_of_a_profile, 0);
  const double distance = take_real(self, "distance");
  const double most_depth = take_real(self, "most_depth");
  const double smoothing = take_real(self, "smoothing");
  double *worn = NULL;
  double taken = 0;
  no_more(self);
  worn = room(1 * (points * 2), sizeof *worn);
  rc = rollcon_wear_profile(points, yz, rate, side, distance, most_depth, smoothing, worn, &taken);
  if (rc < 0) finish(self, rc);
  give_reals(self, worn, 1, points * 2);
  give_real(self, (double)taken);
  finish(self, rc);
}

static void call_stress_invariants(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  const double *stress = take_reals(self, "stress", &n, 6, 0);
  double *principal = NULL;
  double *von_mises = NULL;
  double *shear = NULL;
  no_more(self);
  principal = room(n * (3), sizeof *principal);
  von_mises = room(n * (1), sizeof *von_mises);
  shear = room(n * (1), sizeof *shear);
  rc = rollcon_stress_invariants(n, stress, principal, von_mises, shear);
  if (rc < 0) finish(self, rc);
  give_reals(self, principal, n, 3);
  give_reals(self, von_mises, n, 1);
  give_reals(self, shear, n, 1);
  finish(self, rc);
}

static void call_contact_get_stat(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const char *name = take_text(self, "name");
  double value = 0;
  no_more(self);
  rc = rollcon_contact_get_stat(contact, name, &value);
  if (rc < 0) finish(self, rc);
  give_real(self, (double)value);
  finish(self, rc);
}

static void call_contact_get_history(call *self) {
  int32_t rc = 0;
  int64_t capacity = 0;
  int64_t need = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const char *columns = take_text(self, "columns");
  double *rows = NULL;
  no_more(self);
  rc = rollcon_contact_get_history(contact, columns, capacity, rows, &need);
  if (rc < 0) finish(self, rc);
  capacity = need;
  rows = room(capacity * (count_words(columns)), sizeof *rows);
  rc = rollcon_contact_get_history(contact, columns, capacity, rows, &need);
  if (rc < 0) finish(self, rc);
  give_reals(self, rows, capacity, count_words(columns));
  finish(self, rc);
}

static void call_contact_get_plan(call *self) {
  int32_t rc = 0;
  int64_t capacity = 0;
  int64_t need = 0;
  char *text_buffer = NULL;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  no_more(self);
  rc = rollcon_contact_get_plan(contact, capacity, text_buffer, &need);
  if (rc < 0) finish(self, rc);
  capacity = need;
  text_buffer = room(capacity, 1);
  rc = rollcon_contact_get_plan(contact, capacity, text_buffer, &need);
  if (rc < 0) finish(self, rc);
  give_text(self, text_buffer);
  finish(self, rc);
}

static void call_contact_write(call *self) {
  int32_t rc = 0;
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const char *path = take_text(self, "path");
  no_more(self);
  rc = rollcon_contact_write(contact, path);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_wheelrail_create(call *self) {
  int32_t rc = 0;
  rollcon_context *context = rollcon_context_from_id(take_handle(self, "context"));
  rollcon_body *wheel = rollcon_body_from_id(take_handle(self, "wheel"));
  rollcon_body *rail = rollcon_body_from_id(take_handle(self, "rail"));
  const int32_t side = take_enumerator(self, "side", names_of_side, 0);
  rollcon_wheelrail *wheelrail = NULL;
  no_more(self);
  rc = rollcon_wheelrail_create(context, wheel, rail, side, &wheelrail);
  if (rc < 0) finish(self, rc);
  give_real(self, rollcon_id_of(wheelrail));
  finish(self, rc);
}

static void call_wheelrail_release(call *self) {
  rollcon_wheelrail *wheelrail = rollcon_wheelrail_from_id(take_handle(self, "wheelrail"));
  no_more(self);
  rollcon_wheelrail_release(wheelrail);
}

static void call_wheelrail_set_track(call *self) {
  int32_t rc = 0;
  rollcon_wheelrail *wheelrail = rollcon_wheelrail_from_id(take_handle(self, "wheelrail"));
  const double gauge = take_real(self, "gauge");
  const double gauge_height = take_real(self, "gauge_height");
  const double cant = take_real(self, "cant");
  no_more(self);
  rc = rollcon_wheelrail_set_track(wheelrail, gauge, gauge_height, cant);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_wheelrail_set_wheelset(call *self) {
  int32_t rc = 0;
  rollcon_wheelrail *wheelrail = rollcon_wheelrail_from_id(take_handle(self, "wheelrail"));
  const double back_to_back = take_real(self, "back_to_back");
  const double flange_back = take_real(self, "flange_back");
  const double radius = take_real(self, "radius");
  no_more(self);
  rc = rollcon_wheelrail_set_wheelset(wheelrail, back_to_back, flange_back, radius);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_wheelrail_set_rail_deviation(call *self) {
  int32_t rc = 0;
  rollcon_wheelrail *wheelrail = rollcon_wheelrail_from_id(take_handle(self, "wheelrail"));
  int64_t deviation_rows = 3;
  const double *deviation = take_reals(self, "deviation", &deviation_rows, 0, 0);
  int64_t rate_rows = 3;
  const double *rate = take_reals(self, "rate", &rate_rows, 0, 0);
  no_more(self);
  rc = rollcon_wheelrail_set_rail_deviation(wheelrail, deviation, rate);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_wheelrail_set_position(call *self) {
  int32_t rc = 0;
  rollcon_wheelrail *wheelrail = rollcon_wheelrail_from_id(take_handle(self, "wheelrail"));
  int64_t position_rows = 6;
  const double *position = take_reals(self, "position", &position_rows, 0, 0);
  no_more(self);
  rc = rollcon_wheelrail_set_position(wheelrail, position);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_wheelrail_set_velocity(call *self) {
  int32_t rc = 0;
  rollcon_wheelrail *wheelrail = rollcon_wheelrail_from_id(take_handle(self, "wheelrail"));
  int64_t velocity_rows = 6;
  const double *velocity = take_reals(self, "velocity", &velocity_rows, 0, 0);
  no_more(self);
  rc = rollcon_wheelrail_set_velocity(wheelrail, velocity);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_wheelrail_prescribe_vertical(call *self) {
  int32_t rc = 0;
  rollcon_wheelrail *wheelrail = rollcon_wheelrail_from_id(take_handle(self, "wheelrail"));
  const int32_t how = take_enumerator(self, "how", names_of_how, 0);
  const double force = has_more(self) ? take_real(self, "force") : 0;
  no_more(self);
  rc = rollcon_wheelrail_prescribe_vertical(wheelrail, how, force);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_wheelrail_set_friction(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_wheelrail *wheelrail = rollcon_wheelrail_from_id(take_handle(self, "wheelrail"));
  const char *law = take_text(self, "law");
  const double *parameters = take_reals(self, "parameters", &n, 0, 0);
  no_more(self);
  rc = rollcon_wheelrail_set_friction(wheelrail, law, n, parameters);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_wheelrail_set_table(call *self) {
  int32_t rc = 0;
  rollcon_wheelrail *wheelrail = rollcon_wheelrail_from_id(take_handle(self, "wheelrail"));
  rollcon_table *table = rollcon_table_from_id(take_handle(self, "table"));
  no_more(self);
  rc = rollcon_wheelrail_set_table(wheelrail, table);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_wheelrail_solve(call *self) {
  int32_t rc = 0;
  rollcon_wheelrail *wheelrail = rollcon_wheelrail_from_id(take_handle(self, "wheelrail"));
  no_more(self);
  rc = rollcon_wheelrail_solve(wheelrail);
  if (rc < 0) finish(self, rc);
  give_real(self, rc);
  finish(self, rc);
}

static void call_wheelrail_request_cancel(call *self) {
  int32_t rc = 0;
  rollcon_wheelrail *wheelrail = rollcon_wheelrail_from_id(take_handle(self, "wheelrail"));
  no_more(self);
  rc = rollcon_wheelrail_request_cancel(wheelrail);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_wheelrail_solve_many(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_wheelrail *wheelrail = rollcon_wheelrail_from_id(take_handle(self, "wheelrail"));
  const double *positions = take_reals(self, "positions", &n, 6, 1);
  const double *velocities = take_reals(self, "velocities", &n, 6, 1);
  const char *columns = take_text(self, "columns");
  double *totals = NULL;
  int32_t *status = NULL;
  no_more(self);
  totals = room(n * (count_words(columns)), sizeof *totals);
  status = room(n * (1), sizeof *status);
  rc = rollcon_wheelrail_solve_many(wheelrail, n < 0 ? 0 : n, positions, velocities, columns, totals, status);
  if (rc < 0) finish(self, rc);
  give_reals(self, totals, n, count_words(columns));
  give_integers(self, status, n, 0);
  finish(self, rc);
}

static void call_wheelrail_find_wear(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_wheelrail *wheelrail = rollcon_wheelrail_from_id(take_handle(self, "wheelrail"));
  const int64_t n_cases = take_integer(self, "n_cases");
  int64_t positions_rows = n_cases;
  const double *positions = take_reals(self, "positions", &positions_rows, 6, 0);
  int64_t velocities_rows = n_cases;
  const double *velocities = take_reals(self, "velocities", &velocities_rows, 6, 0);
  int64_t weights_rows = n_cases;
  const double *weights = take_reals(self, "weights", &weights_rows, 0, 1);
  const char *law = take_text(self, "law");
  const double *parameters = take_reals(self, "parameters", &n, 0, 0);
  const int64_t points = take_integer(self, "points");
  double *wheel = NULL;
  double *rail = NULL;
  double *volumes = NULL;
  int32_t *status = NULL;
  no_more(self);
  wheel = room(1 * (points), sizeof *wheel);
  rail = room(1 * (points), sizeof *rail);
  volumes = room(1 * (2), sizeof *volumes);
  status = room(1 * (n_cases), sizeof *status);
  rc = rollcon_wheelrail_find_wear(wheelrail, n_cases, positions, velocities, weights, law, n, parameters, points, wheel, rail, volumes, status);
  if (rc < 0) finish(self, rc);
  give_reals(self, wheel, 1, points);
  give_reals(self, rail, 1, points);
  give_reals(self, volumes, 1, 2);
  give_integers(self, status, 1, 0);
  finish(self, rc);
}

static void call_wheelrail_snapshot(call *self) {
  int32_t rc = 0;
  rollcon_wheelrail *wheelrail = rollcon_wheelrail_from_id(take_handle(self, "wheelrail"));
  const int32_t place = take_enumerator(self, "place", no_names, 0);
  no_more(self);
  rc = rollcon_wheelrail_snapshot(wheelrail, place);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_wheelrail_rollback(call *self) {
  int32_t rc = 0;
  rollcon_wheelrail *wheelrail = rollcon_wheelrail_from_id(take_handle(self, "wheelrail"));
  const int32_t place = take_enumerator(self, "place", no_names, 0);
  no_more(self);
  rc = rollcon_wheelrail_rollback(wheelrail, place);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_wheelrail_copy(call *self) {
  int32_t rc = 0;
  rollcon_wheelrail *wheelrail = rollcon_wheelrail_from_id(take_handle(self, "wheelrail"));
  rollcon_wheelrail *copy = NULL;
  no_more(self);
  rc = rollcon_wheelrail_copy(wheelrail, &copy);
  if (rc < 0) finish(self, rc);
  give_real(self, rollcon_id_of(copy));
  finish(self, rc);
}

static void call_wheelrail_reset(call *self) {
  int32_t rc = 0;
  rollcon_wheelrail *wheelrail = rollcon_wheelrail_from_id(take_handle(self, "wheelrail"));
  no_more(self);
  rc = rollcon_wheelrail_reset(wheelrail);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_wheelrail_set_int(call *self) {
  int32_t rc = 0;
  rollcon_wheelrail *wheelrail = rollcon_wheelrail_from_id(take_handle(self, "wheelrail"));
  const char *name = take_text(self, "name");
  const int64_t value = take_integer(self, "value");
  no_more(self);
  rc = rollcon_wheelrail_set_int(wheelrail, name, value);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_wheelrail_set_real(call *self) {
  int32_t rc = 0;
  rollcon_wheelrail *wheelrail = rollcon_wheelrail_from_id(take_handle(self, "wheelrail"));
  const char *name = take_text(self, "name");
  const double value = take_real(self, "value");
  no_more(self);
  rc = rollcon_wheelrail_set_real(wheelrail, name, value);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_wheelrail_get_int(call *self) {
  int32_t rc = 0;
  rollcon_wheelrail *wheelrail = rollcon_wheelrail_from_id(take_handle(self, "wheelrail"));
  const char *name = take_text(self, "name");
  int64_t value = 0;
  no_more(self);
  rc = rollcon_wheelrail_get_int(wheelrail, name, &value);
  if (rc < 0) finish(self, rc);
  give_real(self, (double)value);
  finish(self, rc);
}

static void call_wheelrail_get_real(call *self) {
  int32_t rc = 0;
  rollcon_wheelrail *wheelrail = rollcon_wheelrail_from_id(take_handle(self, "wheelrail"));
  const char *name = take_text(self, "name");
  double value = 0;
  no_more(self);
  rc = rollcon_wheelrail_get_real(wheelrail, name, &value);
  if (rc < 0) finish(self, rc);
  give_real(self, (double)value);
  finish(self, rc);
}

static void call_wheelrail_get_patch_count(call *self) {
  int32_t rc = 0;
  rollcon_wheelrail *wheelrail = rollcon_wheelrail_from_id(take_handle(self, "wheelrail"));
  int64_t patches = 0;
  no_more(self);
  rc = rollcon_wheelrail_get_patch_count(wheelrail, &patches);
  if (rc < 0) finish(self, rc);
  give_real(self, (double)patches);
  finish(self, rc);
}

static void call_wheelrail_get_resultant(call *self) {
  int32_t rc = 0;
  rollcon_wheelrail *wheelrail = rollcon_wheelrail_from_id(take_handle(self, "wheelrail"));
  const int32_t axes = has_more(self) ? take_enumerator(self, "axes", names_of_axes_of_the_track, 0) : ROLLCON_IN_TRACK;
  double *force = NULL;
  double *moment = NULL;
  no_more(self);
  force = room(1 * (3), sizeof *force);
  moment = room(1 * (3), sizeof *moment);
  rc = rollcon_wheelrail_get_resultant(wheelrail, axes, force, moment);
  if (rc < 0) finish(self, rc);
  give_reals(self, force, 1, 3);
  give_reals(self, moment, 1, 3);
  finish(self, rc);
}

static void call_wheelrail_get_derivative(call *self) {
  int32_t rc = 0;
  rollcon_wheelrail *wheelrail = rollcon_wheelrail_from_id(take_handle(self, "wheelrail"));
  const int32_t entry = take_enumerator(self, "entry", no_names, 0);
  double *force = NULL;
  double *moment = NULL;
  double z = 0;
  no_more(self);
  force = room(1 * (3), sizeof *force);
  moment = room(1 * (3), sizeof *moment);
  rc = rollcon_wheelrail_get_derivative(wheelrail, entry, force, moment, &z);
  if (rc < 0) finish(self, rc);
  give_reals(self, force, 1, 3);
  give_reals(self, moment, 1, 3);
  give_real(self, (double)z);
  finish(self, rc);
}

static void call_wheelrail_get_stat(call *self) {
  int32_t rc = 0;
  rollcon_wheelrail *wheelrail = rollcon_wheelrail_from_id(take_handle(self, "wheelrail"));
  const char *name = take_text(self, "name");
  double value = 0;
  no_more(self);
  rc = rollcon_wheelrail_get_stat(wheelrail, name, &value);
  if (rc < 0) finish(self, rc);
  give_real(self, (double)value);
  finish(self, rc);
}

static void call_wheelrail_get_profile_point(call *self) {
  int32_t rc = 0;
  rollcon_wheelrail *wheelrail = rollcon_wheelrail_from_id(take_handle(self, "wheelrail"));
  const int32_t which = take_enumerator(self, "which", names_of_profile_of_a_wheel_on_its_rail, 0);
  const double share = take_real(self, "share");
  double *point = NULL;
  no_more(self);
  point = room(1 * (2), sizeof *point);
  rc = rollcon_wheelrail_get_profile_point(wheelrail, which, share, point);
  if (rc < 0) finish(self, rc);
  give_reals(self, point, 1, 2);
  finish(self, rc);
}

static void call_wheelrail_get_patch_stat(call *self) {
  int32_t rc = 0;
  rollcon_wheelrail *wheelrail = rollcon_wheelrail_from_id(take_handle(self, "wheelrail"));
  const int32_t patch = (int32_t)take_integer(self, "patch") - 1;
  const char *name = take_text(self, "name");
  double value = 0;
  no_more(self);
  rc = rollcon_wheelrail_get_patch_stat(wheelrail, patch, name, &value);
  if (rc < 0) finish(self, rc);
  give_real(self, (double)value);
  finish(self, rc);
}

static void call_wheelrail_get_patch_axes(call *self) {
  int32_t rc = 0;
  rollcon_wheelrail *wheelrail = rollcon_wheelrail_from_id(take_handle(self, "wheelrail"));
  const int32_t patch = (int32_t)take_integer(self, "patch") - 1;
  double *origin = NULL;
  double *axes = NULL;
  no_more(self);
  origin = room(1 * (3), sizeof *origin);
  axes = room(1 * (9), sizeof *axes);
  rc = rollcon_wheelrail_get_patch_axes(wheelrail, patch, origin, axes);
  if (rc < 0) finish(self, rc);
  give_reals(self, origin, 1, 3);
  give_reals(self, axes, 1, 9);
  finish(self, rc);
}

static void call_wheelrail_get_contact(call *self) {
  int32_t rc = 0;
  rollcon_wheelrail *wheelrail = rollcon_wheelrail_from_id(take_handle(self, "wheelrail"));
  const int32_t patch = (int32_t)take_integer(self, "patch") - 1;
  rollcon_contact *contact = NULL;
  no_more(self);
  rc = rollcon_wheelrail_get_contact(wheelrail, patch, &contact);
  if (rc < 0) finish(self, rc);
  give_real(self, rollcon_id_of(contact));
  finish(self, rc);
}

static void call_wheelrail_find_contact_points(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_wheelrail *left = rollcon_wheelrail_from_id(take_handle(self, "left"));
  rollcon_wheelrail *right = rollcon_wheelrail_from_id(take_handle(self, "right"));
  const double *shift = take_reals(self, "shift", &n, 0, 0);
  const char *columns = take_text(self, "columns");
  double *points = NULL;
  no_more(self);
  points = room(n * (count_words(columns)), sizeof *points);
  rc = rollcon_wheelrail_find_contact_points(left, right, n, shift, columns, points);
  if (rc < 0) finish(self, rc);
  give_reals(self, points, n, count_words(columns));
  finish(self, rc);
}

static void call_wheelrail_find_conicity(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_wheelrail *left = rollcon_wheelrail_from_id(take_handle(self, "left"));
  rollcon_wheelrail *right = rollcon_wheelrail_from_id(take_handle(self, "right"));
  const double *amplitude = take_reals(self, "amplitude", &n, 0, 0);
  double *conicity = NULL;
  double *wavelength = NULL;
  no_more(self);
  conicity = room(n * (1), sizeof *conicity);
  wavelength = room(n * (1), sizeof *wavelength);
  rc = rollcon_wheelrail_find_conicity(left, right, n, amplitude, conicity, wavelength);
  if (rc < 0) finish(self, rc);
  give_reals(self, conicity, n, 1);
  give_reals(self, wavelength, n, 1);
  finish(self, rc);
}

static void call_option_count(call *self) {
  const int32_t kind = take_enumerator(self, "kind", names_of_kind_of_object, 0);
  no_more(self);
  give_real(self, rollcon_option_count(kind));
}

static void call_option_info(call *self) {
  int32_t rc = 0;
  int64_t capacity = 0;
  int64_t need = 0;
  char *name_buffer = NULL;
  char *doc_buffer = NULL;
  const int32_t kind = take_enumerator(self, "kind", names_of_kind_of_object, 0);
  const int32_t i = (int32_t)take_integer(self, "i") - 1;
  int32_t type = 0;
  double low = 0;
  double high = 0;
  double standard = 0;
  no_more(self);
  rc = rollcon_option_info(kind, i, capacity, name_buffer, doc_buffer, &need, &type, &low, &high, &standard);
  if (rc < 0) finish(self, rc);
  capacity = need;
  name_buffer = room(capacity, 1);
  doc_buffer = room(capacity, 1);
  rc = rollcon_option_info(kind, i, capacity, name_buffer, doc_buffer, &need, &type, &low, &high, &standard);
  if (rc < 0) finish(self, rc);
  give_text(self, name_buffer);
  give_text(self, doc_buffer);
  give_real(self, (double)type);
  give_real(self, (double)low);
  give_real(self, (double)high);
  give_real(self, (double)standard);
  finish(self, rc);
}

static void call_stat_count(call *self) {
  const int32_t kind = take_enumerator(self, "kind", names_of_kind_of_object, 0);
  no_more(self);
  give_real(self, rollcon_stat_count(kind));
}

static void call_stat_info(call *self) {
  int32_t rc = 0;
  int64_t capacity = 0;
  int64_t need = 0;
  char *name_buffer = NULL;
  char *doc_buffer = NULL;
  const int32_t kind = take_enumerator(self, "kind", names_of_kind_of_object, 0);
  const int32_t i = (int32_t)take_integer(self, "i") - 1;
  int32_t inside = 0;
  no_more(self);
  rc = rollcon_stat_info(kind, i, capacity, name_buffer, doc_buffer, &need, &inside);
  if (rc < 0) finish(self, rc);
  capacity = need;
  name_buffer = room(capacity, 1);
  doc_buffer = room(capacity, 1);
  rc = rollcon_stat_info(kind, i, capacity, name_buffer, doc_buffer, &need, &inside);
  if (rc < 0) finish(self, rc);
  give_text(self, name_buffer);
  give_text(self, doc_buffer);
  give_real(self, (double)inside);
  finish(self, rc);
}

static void call_table_create(call *self) {
  int32_t rc = 0;
  rollcon_context *context = rollcon_context_from_id(take_handle(self, "context"));
  rollcon_table *table = NULL;
  no_more(self);
  rc = rollcon_table_create(context, &table);
  if (rc < 0) finish(self, rc);
  give_real(self, rollcon_id_of(table));
  finish(self, rc);
}

static void call_table_release(call *self) {
  rollcon_table *table = rollcon_table_from_id(take_handle(self, "table"));
  no_more(self);
  rollcon_table_release(table);
}

static void call_table_load(call *self) {
  int32_t rc = 0;
  rollcon_context *context = rollcon_context_from_id(take_handle(self, "context"));
  const char *path = take_text(self, "path");
  rollcon_table *table = NULL;
  no_more(self);
  rc = rollcon_table_load(context, path, &table);
  if (rc < 0) finish(self, rc);
  give_real(self, rollcon_id_of(table));
  finish(self, rc);
}

static void call_table_standard(call *self) {
  int32_t rc = 0;
  rollcon_context *context = rollcon_context_from_id(take_handle(self, "context"));
  rollcon_table *table = NULL;
  no_more(self);
  rc = rollcon_table_standard(context, &table);
  if (rc < 0) finish(self, rc);
  give_real(self, rollcon_id_of(table));
  finish(self, rc);
}

static void call_table_set_ratios(call *self) {
  int32_t rc = 0;
  rollcon_table *table = rollcon_table_from_id(take_handle(self, "table"));
  const int32_t intervals = take_enumerator(self, "intervals", no_names, 0);
  const double least = take_real(self, "least");
  const double greatest = take_real(self, "greatest");
  no_more(self);
  rc = rollcon_table_set_ratios(table, intervals, least, greatest);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_table_set_resolution(call *self) {
  int32_t rc = 0;
  rollcon_table *table = rollcon_table_from_id(take_handle(self, "table"));
  const int32_t magnitudes = take_enumerator(self, "magnitudes", no_names, 0);
  const int32_t angles = take_enumerator(self, "angles", no_names, 0);
  const int32_t directions = take_enumerator(self, "directions", no_names, 0);
  no_more(self);
  rc = rollcon_table_set_resolution(table, magnitudes, angles, directions);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_table_set_frame(call *self) {
  int32_t rc = 0;
  rollcon_table *table = rollcon_table_from_id(take_handle(self, "table"));
  const int32_t along = take_enumerator(self, "along", no_names, 0);
  const int32_t across = take_enumerator(self, "across", no_names, 0);
  no_more(self);
  rc = rollcon_table_set_frame(table, along, across);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_table_set_poissons(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_table *table = rollcon_table_from_id(take_handle(self, "table"));
  const double *poissons = take_reals(self, "poissons", &n, 0, 0);
  no_more(self);
  rc = rollcon_table_set_poissons(table, n, poissons);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_table_set_bodies(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_table *table = rollcon_table_from_id(take_handle(self, "table"));
  int64_t youngs_rows = 2;
  const double *youngs = take_reals(self, "youngs", &youngs_rows, 0, 0);
  int64_t poissons_rows = 2;
  const double *poissons = take_reals(self, "poissons", &poissons_rows, 0, 0);
  const double *frictions = take_reals(self, "frictions", &n, 0, 0);
  no_more(self);
  rc = rollcon_table_set_bodies(table, youngs, poissons, n, frictions);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_table_request_cancel(call *self) {
  int32_t rc = 0;
  rollcon_table *table = rollcon_table_from_id(take_handle(self, "table"));
  no_more(self);
  rc = rollcon_table_request_cancel(table);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_table_make(call *self) {
  int32_t rc = 0;
  rollcon_table *table = rollcon_table_from_id(take_handle(self, "table"));
  const int32_t part = take_enumerator(self, "part", no_names, 0);
  const int32_t parts = take_enumerator(self, "parts", no_names, 0);
  no_more(self);
  rc = rollcon_table_make(table, part, parts);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_table_get_samples(call *self) {
  int32_t rc = 0;
  int64_t capacity = 0;
  int64_t need = 0;
  rollcon_table *table = rollcon_table_from_id(take_handle(self, "table"));
  double *samples = NULL;
  no_more(self);
  rc = rollcon_table_get_samples(table, capacity, samples, &need);
  if (rc < 0) finish(self, rc);
  capacity = need;
  samples = room(capacity * (1), sizeof *samples);
  rc = rollcon_table_get_samples(table, capacity, samples, &need);
  if (rc < 0) finish(self, rc);
  give_reals(self, samples, capacity, 1);
  finish(self, rc);
}

static void call_table_add_samples(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_table *table = rollcon_table_from_id(take_handle(self, "table"));
  const double *samples = take_reals(self, "samples", &n, 0, 0);
  no_more(self);
  rc = rollcon_table_add_samples(table, n, samples);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_table_save(call *self) {
  int32_t rc = 0;
  rollcon_table *table = rollcon_table_from_id(take_handle(self, "table"));
  const char *path = take_text(self, "path");
  no_more(self);
  rc = rollcon_table_save(table, path);
  if (rc < 0) finish(self, rc);
  finish(self, rc);
}

static void call_table_evaluate(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_table *table = rollcon_table_from_id(take_handle(self, "table"));
  const double *inputs = take_reals(self, "inputs", &n, 9, 0);
  double *results = NULL;
  no_more(self);
  results = room(n * (3), sizeof *results);
  rc = rollcon_table_evaluate(table, n, inputs, results);
  if (rc < 0) finish(self, rc);
  give_reals(self, results, n, 3);
  finish(self, rc);
}

static void call_table_evaluate_derivatives(call *self) {
  int32_t rc = 0;
  int64_t n = -1;
  rollcon_table *table = rollcon_table_from_id(take_handle(self, "table"));
  const double *inputs = take_reals(self, "inputs", &n, 9, 0);
  double *results = NULL;
  double *derivatives = NULL;
  no_more(self);
  results = room(n * (3), sizeof *results);
  derivatives = room(n * (3 * 9), sizeof *derivatives);
  rc = rollcon_table_evaluate_derivatives(table, n, inputs, results, derivatives);
  if (rc < 0) finish(self, rc);
  give_reals(self, results, n, 3);
  give_reals(self, derivatives, n, 3 * 9);
  finish(self, rc);
}

static void call_table_evaluate_contact(call *self) {
  int32_t rc = 0;
  rollcon_table *table = rollcon_table_from_id(take_handle(self, "table"));
  rollcon_contact *contact = rollcon_contact_from_id(take_handle(self, "contact"));
  const double friction = take_real(self, "friction");
  double *results = NULL;
  no_more(self);
  results = room(1 * (3), sizeof *results);
  rc = rollcon_table_evaluate_contact(table, contact, friction, results);
  if (rc < 0) finish(self, rc);
  give_reals(self, results, 1, 3);
  finish(self, rc);
}

const entry calls[] = {
  {"version", call_version, 1},
  {"version_string", call_version_string, 1},
  {"build_info", call_build_info, 1},
  {"has_feature", call_has_feature, 1},
  {"status_string", call_status_string, 1},
  {"last_error", call_last_error, 1},
  {"last_caveat", call_last_caveat, 1},
  {"context_create", call_context_create, 1},
  {"context_release", call_context_release, 1},
  {"context_set_threads", call_context_set_threads, 1},
  {"context_set_latch", call_context_set_latch, 1},
  {"context_check", call_context_check, 1},
  {"body_create", call_body_create, 1},
  {"body_release", call_body_release, 1},
  {"body_set_elastic", call_body_set_elastic, 1},
  {"body_set_viscoelastic", call_body_set_viscoelastic, 1},
  {"body_prepare", call_body_prepare, 1},
  {"body_get_kind", call_body_get_kind, 1},
  {"body_save", call_body_save, 1},
  {"body_load", call_body_load, 1},
  {"body_copy", call_body_copy, 1},
  {"body_set_nodes", call_body_set_nodes, 1},
  {"body_add_elements", call_body_add_elements, 1},
  {"body_tag_faces", call_body_tag_faces, 1},
  {"body_tag_faces_of_nodes", call_body_tag_faces_of_nodes, 1},
  {"body_set_support", call_body_set_support, 1},
  {"body_set_traction", call_body_set_traction, 1},
  {"body_set_body_force", call_body_set_body_force, 1},
  {"body_set_rotation", call_body_set_rotation, 1},
  {"body_set_pressure", call_body_set_pressure, 1},
  {"body_set_springs", call_body_set_springs, 1},
  {"body_set_node_tractions", call_body_set_node_tractions, 1},
  {"body_set_contact_faces", call_body_set_contact_faces, 1},
  {"body_revolve", call_body_revolve, 1},
  {"body_extrude", call_body_extrude, 1},
  {"body_read_mesh", call_body_read_mesh, 1},
  {"body_tag_group", call_body_tag_group, 1},
  {"body_get_group_count", call_body_get_group_count, 1},
  {"body_get_group_name", call_body_get_group_name, 1},
  {"body_get_group_nodes", call_body_get_group_nodes, 1},
  {"body_set_int", call_body_set_int, 1},
  {"body_set_real", call_body_set_real, 1},
  {"body_get_int", call_body_get_int, 1},
  {"body_get_real", call_body_get_real, 1},
  {"body_set_profile", call_body_set_profile, 1},
  {"body_set_profile_shape", call_body_set_profile_shape, 1},
  {"body_read_profile", call_body_read_profile, 1},
  {"body_write_profile", call_body_write_profile, 1},
  {"body_extrude_profile", call_body_extrude_profile, 1},
  {"body_revolve_profile", call_body_revolve_profile, 1},
  {"body_get_profile_length", call_body_get_profile_length, 1},
  {"body_get_profile_point", call_body_get_profile_point, 3},
  {"body_get_size", call_body_get_size, 2},
  {"body_get_displacements", call_body_get_displacements, 1},
  {"body_get_node_stresses", call_body_get_node_stresses, 1},
  {"body_get_point_stresses", call_body_get_point_stresses, 2},
  {"body_get_fields_at", call_body_get_fields_at, 2},
  {"body_write", call_body_write, 1},
  {"body_get_reaction", call_body_get_reaction, 2},
  {"body_get_stat", call_body_get_stat, 1},
  {"contact_create", call_contact_create, 1},
  {"contact_release", call_contact_release, 1},
  {"contact_frame_nodes", call_contact_frame_nodes, 1},
  {"contact_frame_add_elements", call_contact_frame_add_elements, 1},
  {"contact_frame_from_file", call_contact_frame_from_file, 1},
  {"contact_frame_from_body", call_contact_frame_from_body, 1},
  {"contact_frame_rectangle", call_contact_frame_rectangle, 1},
  {"contact_frame_ellipse", call_contact_frame_ellipse, 1},
  {"contact_frame_strips", call_contact_frame_strips, 1},
  {"contact_frame_automatic", call_contact_frame_automatic, 1},
  {"contact_set_pose", call_contact_set_pose, 1},
  {"contact_set_axes", call_contact_set_axes, 1},
  {"contact_set_gap", call_contact_set_gap, 1},
  {"contact_set_gap_quadratic", call_contact_set_gap_quadratic, 1},
  {"contact_set_gap_grid", call_contact_set_gap_grid, 1},
  {"contact_set_rolling", call_contact_set_rolling, 1},
  {"contact_set_creep", call_contact_set_creep, 1},
  {"contact_set_step", call_contact_set_step, 1},
  {"contact_set_velocity", call_contact_set_velocity, 1},
  {"contact_set_creep_field", call_contact_set_creep_field, 1},
  {"contact_prescribe", call_contact_prescribe, 1},
  {"contact_set_friction", call_contact_set_friction, 1},
  {"contact_set_friction_memory", call_contact_set_friction_memory, 1},
  {"contact_set_layer", call_contact_set_layer, 1},
  {"contact_set_friction_across", call_contact_set_friction_across, 1},
  {"contact_set_heat", call_contact_set_heat, 1},
  {"contact_set_friction_field", call_contact_set_friction_field, 1},
  {"contact_set_int", call_contact_set_int, 1},
  {"contact_set_real", call_contact_set_real, 1},
  {"contact_set_str", call_contact_set_str, 1},
  {"contact_get_int", call_contact_get_int, 1},
  {"contact_get_real", call_contact_get_real, 1},
  {"contact_get_str", call_contact_get_str, 1},
  {"contact_set_procedure", call_contact_set_procedure, 1},
  {"contact_request_cancel", call_contact_request_cancel, 1},
  {"contact_solve", call_contact_solve, 1},
  {"contact_solve_many", call_contact_solve_many, 2},
  {"contact_repeat_step", call_contact_repeat_step, 1},
  {"contact_past_get", call_contact_past_get, 1},
  {"contact_past_set", call_contact_past_set, 1},
  {"contact_reset", call_contact_reset, 1},
  {"contact_get_size", call_contact_get_size, 2},
  {"contact_get_tractions", call_contact_get_tractions, 1},
  {"contact_get_field", call_contact_get_field, 1},
  {"contact_get_node_states", call_contact_get_node_states, 1},
  {"contact_get_resultant", call_contact_get_resultant, 2},
  {"contact_get_motion", call_contact_get_motion, 2},
  {"contact_get_tilt", call_contact_get_tilt, 1},
  {"contact_get_sensitivity", call_contact_get_sensitivity, 4},
  {"contact_get_displacements_at", call_contact_get_displacements_at, 1},
  {"contact_get_fields_at", call_contact_get_fields_at, 2},
  {"contact_get_body_displacements", call_contact_get_body_displacements, 1},
  {"contact_write_body", call_contact_write_body, 1},
  {"contact_get_temperatures_at", call_contact_get_temperatures_at, 1},
  {"contact_get_fatigue_index", call_contact_get_fatigue_index, 1},
  {"contact_get_equivalent_ellipse", call_contact_get_equivalent_ellipse, 2},
  {"contact_get_wear", call_contact_get_wear, 2},
  {"wear_profile", call_wear_profile, 2},
  {"stress_invariants", call_stress_invariants, 3},
  {"contact_get_stat", call_contact_get_stat, 1},
  {"contact_get_history", call_contact_get_history, 1},
  {"contact_get_plan", call_contact_get_plan, 1},
  {"contact_write", call_contact_write, 1},
  {"wheelrail_create", call_wheelrail_create, 1},
  {"wheelrail_release", call_wheelrail_release, 1},
  {"wheelrail_set_track", call_wheelrail_set_track, 1},
  {"wheelrail_set_wheelset", call_wheelrail_set_wheelset, 1},
  {"wheelrail_set_rail_deviation", call_wheelrail_set_rail_deviation, 1},
  {"wheelrail_set_position", call_wheelrail_set_position, 1},
  {"wheelrail_set_velocity", call_wheelrail_set_velocity, 1},
  {"wheelrail_prescribe_vertical", call_wheelrail_prescribe_vertical, 1},
  {"wheelrail_set_friction", call_wheelrail_set_friction, 1},
  {"wheelrail_set_table", call_wheelrail_set_table, 1},
  {"wheelrail_solve", call_wheelrail_solve, 1},
  {"wheelrail_request_cancel", call_wheelrail_request_cancel, 1},
  {"wheelrail_solve_many", call_wheelrail_solve_many, 2},
  {"wheelrail_find_wear", call_wheelrail_find_wear, 4},
  {"wheelrail_snapshot", call_wheelrail_snapshot, 1},
  {"wheelrail_rollback", call_wheelrail_rollback, 1},
  {"wheelrail_copy", call_wheelrail_copy, 1},
  {"wheelrail_reset", call_wheelrail_reset, 1},
  {"wheelrail_set_int", call_wheelrail_set_int, 1},
  {"wheelrail_set_real", call_wheelrail_set_real, 1},
  {"wheelrail_get_int", call_wheelrail_get_int, 1},
  {"wheelrail_get_real", call_wheelrail_get_real, 1},
  {"wheelrail_get_patch_count", call_wheelrail_get_patch_count, 1},
  {"wheelrail_get_resultant", call_wheelrail_get_resultant, 2},
  {"wheelrail_get_derivative", call_wheelrail_get_derivative, 3},
  {"wheelrail_get_stat", call_wheelrail_get_stat, 1},
  {"wheelrail_get_profile_point", call_wheelrail_get_profile_point, 1},
  {"wheelrail_get_patch_stat", call_wheelrail_get_patch_stat, 1},
  {"wheelrail_get_patch_axes", call_wheelrail_get_patch_axes, 2},
  {"wheelrail_get_contact", call_wheelrail_get_contact, 1},
  {"wheelrail_find_contact_points", call_wheelrail_find_contact_points, 1},
  {"wheelrail_find_conicity", call_wheelrail_find_conicity, 2},
  {"option_count", call_option_count, 1},
  {"option_info", call_option_info, 6},
  {"stat_count", call_stat_count, 1},
  {"stat_info", call_stat_info, 3},
  {"table_create", call_table_create, 1},
  {"table_release", call_table_release, 1},
  {"table_load", call_table_load, 1},
  {"table_standard", call_table_standard, 1},
  {"table_set_ratios", call_table_set_ratios, 1},
  {"table_set_resolution", call_table_set_resolution, 1},
  {"table_set_frame", call_table_set_frame, 1},
  {"table_set_poissons", call_table_set_poissons, 1},
  {"table_set_bodies", call_table_set_bodies, 1},
  {"table_request_cancel", call_table_request_cancel, 1},
  {"table_make", call_table_make, 1},
  {"table_get_samples", call_table_get_samples, 1},
  {"table_add_samples", call_table_add_samples, 1},
  {"table_save", call_table_save, 1},
  {"table_evaluate", call_table_evaluate, 1},
  {"table_evaluate_derivatives", call_table_evaluate_derivatives, 2},
  {"table_evaluate_contact", call_table_evaluate_contact, 1},
};
const int number_of_calls = sizeof calls / sizeof calls[0];
