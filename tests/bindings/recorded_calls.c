/* Generated from bindings/api.toml by bindings/generate.py; do not edit. */
#include "record.h"
#include "rollcon.h"

/* clang-format off */

const char* const recorded_names[] = {
  "version",
  "abi",
  "version_string",
  "build_info",
  "has_feature",
  "status_string",
  "last_error",
  "last_caveat",
  "report",
  "context_create",
  "context_retain",
  "context_release",
  "context_set_log",
  "context_set_threads",
  "context_set_latch",
  "context_check",
  "body_create",
  "body_retain",
  "body_release",
  "body_set_elastic",
  "body_prepare",
  "body_get_kind",
  "body_save",
  "body_load",
  "body_copy",
  "body_set_nodes",
  "body_add_elements",
  "body_tag_faces",
  "body_tag_faces_of_nodes",
  "body_set_support",
  "body_set_traction",
  "body_set_body_force",
  "body_set_rotation",
  "body_set_pressure",
  "body_set_node_tractions",
  "body_set_contact_faces",
  "body_read_mesh",
  "body_tag_group",
  "body_get_group_count",
  "body_get_group_name",
  "body_get_group_nodes",
  "body_set_int",
  "body_set_real",
  "body_get_int",
  "body_get_real",
  "body_option_count",
  "body_option_info",
  "body_option_doc",
  "body_set_profile",
  "body_set_profile_shape",
  "body_read_profile",
  "body_write_profile",
  "body_extrude_profile",
  "body_revolve_profile",
  "body_get_profile_length",
  "body_get_profile_point",
  "body_get_size",
  "body_get_displacements",
  "body_get_node_stresses",
  "body_get_point_stresses",
  "body_get_fields_at",
  "body_write",
  "body_get_reaction",
  "body_get_stat",
  "body_stat_count",
  "body_stat_name",
  "contact_create",
  "contact_retain",
  "contact_release",
  "contact_set_frame_nodes",
  "contact_add_frame_elements",
  "contact_read_frame",
  "contact_frame_from_body",
  "contact_frame_rectangle",
  "contact_frame_ellipse",
  "contact_frame_strips",
  "contact_frame_automatic",
  "contact_set_pose",
  "contact_set_axes",
  "contact_set_gap",
  "contact_set_gap_quadratic",
  "contact_set_gap_grid",
  "contact_set_rolling",
  "contact_set_creep",
  "contact_set_step",
  "contact_set_velocity",
  "contact_set_creep_field",
  "contact_prescribe",
  "contact_set_friction",
  "contact_set_friction_memory",
  "contact_set_layer",
  "contact_set_layer_yield",
  "contact_set_friction_across",
  "contact_set_heat",
  "contact_set_friction_field",
  "contact_set_int",
  "contact_set_real",
  "contact_set_str",
  "contact_get_int",
  "contact_get_real",
  "contact_get_str",
  "option_count",
  "option_info",
  "option_doc",
  "contact_set_progress",
  "event_get_int",
  "event_get_real",
  "contact_request_cancel",
  "contact_solve",
  "contact_solve_many",
  "contact_repeat_step",
  "contact_save_past",
  "contact_restore_past",
  "contact_reset",
  "contact_get_size",
  "contact_get_tractions",
  "contact_get_field",
  "contact_get_status",
  "contact_get_resultant",
  "contact_get_motion",
  "contact_get_tilt",
  "contact_get_sensitivity",
  "contact_get_displacements_at",
  "contact_get_stresses_at",
  "contact_get_body_displacements",
  "contact_get_body_fields_at",
  "contact_write_body",
  "contact_get_temperatures_at",
  "contact_get_fatigue_index",
  "contact_get_equivalent_ellipse",
  "contact_get_wear",
  "wear_profile",
  "stress_invariants",
  "contact_get_stat",
  "stat_count",
  "stat_name",
  "contact_get_history",
  "contact_get_error_function",
  "contact_get_plan",
  "contact_write",
  "wheelrail_create",
  "wheelrail_retain",
  "wheelrail_release",
  "wheelrail_set_track",
  "wheelrail_set_wheelset",
  "wheelrail_set_rail_deviation",
  "wheelrail_set_position",
  "wheelrail_set_roll_outside",
  "wheelrail_set_velocity",
  "wheelrail_prescribe_vertical",
  "wheelrail_set_friction",
  "wheelrail_set_table",
  "wheelrail_forget_table",
  "wheelrail_set_hertzian",
  "wheelrail_set_conformal",
  "wheelrail_set_friction_by_angle",
  "wheelrail_set_accuracy",
  "wheelrail_solve",
  "wheelrail_request_cancel",
  "wheelrail_solve_many",
  "wheelrail_find_wear",
  "wheelrail_save",
  "wheelrail_restore",
  "wheelrail_copy",
  "wheelrail_reset",
  "wheelrail_get_patch_count",
  "wheelrail_get_resultant",
  "wheelrail_get_derivative",
  "wheelrail_get_stat",
  "wheelrail_stat_count",
  "wheelrail_stat_name",
  "wheelrail_get_profile_point",
  "wheelrail_get_patch_stat",
  "wheelrail_patch_stat_count",
  "wheelrail_patch_stat_name",
  "wheelrail_get_patch_axes",
  "wheelrail_get_contact",
  "wheelrail_find_contact_points",
  "wheelrail_find_conicity",
  "id_of",
  "context_from_id",
  "body_from_id",
  "contact_from_id",
  "wheelrail_from_id",
  "table_from_id",
  "table_create",
  "table_retain",
  "table_release",
  "table_load",
  "table_standard",
  "table_set_ratios",
  "table_set_resolution",
  "table_set_frame",
  "table_set_poissons",
  "table_set_bodies",
  "table_set_progress",
  "table_request_cancel",
  "table_make",
  "table_get_samples",
  "table_add_samples",
  "table_save",
  "table_evaluate",
  "table_evaluate_derivatives",
  "table_evaluate_contact",
};

const int recorded_number = 204;

enum {
  recorded_rollcon_version,
  recorded_rollcon_abi,
  recorded_rollcon_version_string,
  recorded_rollcon_build_info,
  recorded_rollcon_has_feature,
  recorded_rollcon_status_string,
  recorded_rollcon_last_error,
  recorded_rollcon_last_caveat,
  recorded_rollcon_report,
  recorded_rollcon_context_create,
  recorded_rollcon_context_retain,
  recorded_rollcon_context_release,
  recorded_rollcon_context_set_log,
  recorded_rollcon_context_set_threads,
  recorded_rollcon_context_set_latch,
  recorded_rollcon_context_check,
  recorded_rollcon_body_create,
  recorded_rollcon_body_retain,
  recorded_rollcon_body_release,
  recorded_rollcon_body_set_elastic,
  recorded_rollcon_body_prepare,
  recorded_rollcon_body_get_kind,
  recorded_rollcon_body_save,
  recorded_rollcon_body_load,
  recorded_rollcon_body_copy,
  recorded_rollcon_body_set_nodes,
  recorded_rollcon_body_add_elements,
  recorded_rollcon_body_tag_faces,
  recorded_rollcon_body_tag_faces_of_nodes,
  recorded_rollcon_body_set_support,
  recorded_rollcon_body_set_traction,
  recorded_rollcon_body_set_body_force,
  recorded_rollcon_body_set_rotation,
  recorded_rollcon_body_set_pressure,
  recorded_rollcon_body_set_node_tractions,
  recorded_rollcon_body_set_contact_faces,
  recorded_rollcon_body_read_mesh,
  recorded_rollcon_body_tag_group,
  recorded_rollcon_body_get_group_count,
  recorded_rollcon_body_get_group_name,
  recorded_rollcon_body_get_group_nodes,
  recorded_rollcon_body_set_int,
  recorded_rollcon_body_set_real,
  recorded_rollcon_body_get_int,
  recorded_rollcon_body_get_real,
  recorded_rollcon_body_option_count,
  recorded_rollcon_body_option_info,
  recorded_rollcon_body_option_doc,
  recorded_rollcon_body_set_profile,
  recorded_rollcon_body_set_profile_shape,
  recorded_rollcon_body_read_profile,
  recorded_rollcon_body_write_profile,
  recorded_rollcon_body_extrude_profile,
  recorded_rollcon_body_revolve_profile,
  recorded_rollcon_body_get_profile_length,
  recorded_rollcon_body_get_profile_point,
  recorded_rollcon_body_get_size,
  recorded_rollcon_body_get_displacements,
  recorded_rollcon_body_get_node_stresses,
  recorded_rollcon_body_get_point_stresses,
  recorded_rollcon_body_get_fields_at,
  recorded_rollcon_body_write,
  recorded_rollcon_body_get_reaction,
  recorded_rollcon_body_get_stat,
  recorded_rollcon_body_stat_count,
  recorded_rollcon_body_stat_name,
  recorded_rollcon_contact_create,
  recorded_rollcon_contact_retain,
  recorded_rollcon_contact_release,
  recorded_rollcon_contact_set_frame_nodes,
  recorded_rollcon_contact_add_frame_elements,
  recorded_rollcon_contact_read_frame,
  recorded_rollcon_contact_frame_from_body,
  recorded_rollcon_contact_frame_rectangle,
  recorded_rollcon_contact_frame_ellipse,
  recorded_rollcon_contact_frame_strips,
  recorded_rollcon_contact_frame_automatic,
  recorded_rollcon_contact_set_pose,
  recorded_rollcon_contact_set_axes,
  recorded_rollcon_contact_set_gap,
  recorded_rollcon_contact_set_gap_quadratic,
  recorded_rollcon_contact_set_gap_grid,
  recorded_rollcon_contact_set_rolling,
  recorded_rollcon_contact_set_creep,
  recorded_rollcon_contact_set_step,
  recorded_rollcon_contact_set_velocity,
  recorded_rollcon_contact_set_creep_field,
  recorded_rollcon_contact_prescribe,
  recorded_rollcon_contact_set_friction,
  recorded_rollcon_contact_set_friction_memory,
  recorded_rollcon_contact_set_layer,
  recorded_rollcon_contact_set_layer_yield,
  recorded_rollcon_contact_set_friction_across,
  recorded_rollcon_contact_set_heat,
  recorded_rollcon_contact_set_friction_field,
  recorded_rollcon_contact_set_int,
  recorded_rollcon_contact_set_real,
  recorded_rollcon_contact_set_str,
  recorded_rollcon_contact_get_int,
  recorded_rollcon_contact_get_real,
  recorded_rollcon_contact_get_str,
  recorded_rollcon_option_count,
  recorded_rollcon_option_info,
  recorded_rollcon_option_doc,
  recorded_rollcon_contact_set_progress,
  recorded_rollcon_event_get_int,
  recorded_rollcon_event_get_real,
  recorded_rollcon_contact_request_cancel,
  recorded_rollcon_contact_solve,
  recorded_rollcon_contact_solve_many,
  recorded_rollcon_contact_repeat_step,
  recorded_rollcon_contact_save_past,
  recorded_rollcon_contact_restore_past,
  recorded_rollcon_contact_reset,
  recorded_rollcon_contact_get_size,
  recorded_rollcon_contact_get_tractions,
  recorded_rollcon_contact_get_field,
  recorded_rollcon_contact_get_status,
  recorded_rollcon_contact_get_resultant,
  recorded_rollcon_contact_get_motion,
  recorded_rollcon_contact_get_tilt,
  recorded_rollcon_contact_get_sensitivity,
  recorded_rollcon_contact_get_displacements_at,
  recorded_rollcon_contact_get_stresses_at,
  recorded_rollcon_contact_get_body_displacements,
  recorded_rollcon_contact_get_body_fields_at,
  recorded_rollcon_contact_write_body,
  recorded_rollcon_contact_get_temperatures_at,
  recorded_rollcon_contact_get_fatigue_index,
  recorded_rollcon_contact_get_equivalent_ellipse,
  recorded_rollcon_contact_get_wear,
  recorded_rollcon_wear_profile,
  recorded_rollcon_stress_invariants,
  recorded_rollcon_contact_get_stat,
  recorded_rollcon_stat_count,
  recorded_rollcon_stat_name,
  recorded_rollcon_contact_get_history,
  recorded_rollcon_contact_get_error_function,
  recorded_rollcon_contact_get_plan,
  recorded_rollcon_contact_write,
  recorded_rollcon_wheelrail_create,
  recorded_rollcon_wheelrail_retain,
  recorded_rollcon_wheelrail_release,
  recorded_rollcon_wheelrail_set_track,
  recorded_rollcon_wheelrail_set_wheelset,
  recorded_rollcon_wheelrail_set_rail_deviation,
  recorded_rollcon_wheelrail_set_position,
  recorded_rollcon_wheelrail_set_roll_outside,
  recorded_rollcon_wheelrail_set_velocity,
  recorded_rollcon_wheelrail_prescribe_vertical,
  recorded_rollcon_wheelrail_set_friction,
  recorded_rollcon_wheelrail_set_table,
  recorded_rollcon_wheelrail_forget_table,
  recorded_rollcon_wheelrail_set_hertzian,
  recorded_rollcon_wheelrail_set_conformal,
  recorded_rollcon_wheelrail_set_friction_by_angle,
  recorded_rollcon_wheelrail_set_accuracy,
  recorded_rollcon_wheelrail_solve,
  recorded_rollcon_wheelrail_request_cancel,
  recorded_rollcon_wheelrail_solve_many,
  recorded_rollcon_wheelrail_find_wear,
  recorded_rollcon_wheelrail_save,
  recorded_rollcon_wheelrail_restore,
  recorded_rollcon_wheelrail_copy,
  recorded_rollcon_wheelrail_reset,
  recorded_rollcon_wheelrail_get_patch_count,
  recorded_rollcon_wheelrail_get_resultant,
  recorded_rollcon_wheelrail_get_derivative,
  recorded_rollcon_wheelrail_get_stat,
  recorded_rollcon_wheelrail_stat_count,
  recorded_rollcon_wheelrail_stat_name,
  recorded_rollcon_wheelrail_get_profile_point,
  recorded_rollcon_wheelrail_get_patch_stat,
  recorded_rollcon_wheelrail_patch_stat_count,
  recorded_rollcon_wheelrail_patch_stat_name,
  recorded_rollcon_wheelrail_get_patch_axes,
  recorded_rollcon_wheelrail_get_contact,
  recorded_rollcon_wheelrail_find_contact_points,
  recorded_rollcon_wheelrail_find_conicity,
  recorded_rollcon_id_of,
  recorded_rollcon_context_from_id,
  recorded_rollcon_body_from_id,
  recorded_rollcon_contact_from_id,
  recorded_rollcon_wheelrail_from_id,
  recorded_rollcon_table_from_id,
  recorded_rollcon_table_create,
  recorded_rollcon_table_retain,
  recorded_rollcon_table_release,
  recorded_rollcon_table_load,
  recorded_rollcon_table_standard,
  recorded_rollcon_table_set_ratios,
  recorded_rollcon_table_set_resolution,
  recorded_rollcon_table_set_frame,
  recorded_rollcon_table_set_poissons,
  recorded_rollcon_table_set_bodies,
  recorded_rollcon_table_set_progress,
  recorded_rollcon_table_request_cancel,
  recorded_rollcon_table_make,
  recorded_rollcon_table_get_samples,
  recorded_rollcon_table_add_samples,
  recorded_rollcon_table_save,
  recorded_rollcon_table_evaluate,
  recorded_rollcon_table_evaluate_derivatives,
  recorded_rollcon_table_evaluate_contact,
};

int32_t rollcon_version(void) {
  record_begin(recorded_rollcon_version);
  return RECORD_COUNT;
}

int32_t rollcon_abi(void) {
  record_begin(recorded_rollcon_abi);
  return ROLLCON_ABI;
}

const char *rollcon_version_string(void) {
  record_begin(recorded_rollcon_version_string);
  return "text of version_string";
}

const char *rollcon_build_info(void) {
  record_begin(recorded_rollcon_build_info);
  return "text of build_info";
}

int32_t rollcon_has_feature(const char *name) {
  record_begin(recorded_rollcon_has_feature);
  record_text(name);
  return RECORD_COUNT;
}

const char *rollcon_status_string(int32_t status) {
  record_begin(recorded_rollcon_status_string);
  record_integer(status);
  return "text of status_string";
}

const char *rollcon_last_error(void) {
  record_begin(recorded_rollcon_last_error);
  return "text of last_error";
}

const char *rollcon_last_caveat(void) {
  record_begin(recorded_rollcon_last_caveat);
  return "text of last_caveat";
}

int32_t rollcon_report(const void *handle, int32_t status, const char *message) {
  record_begin(recorded_rollcon_report);
  record_handle(handle);
  record_integer(status);
  record_text(message);
  return status;
}

rollcon_status rollcon_context_create(int32_t header_abi, rollcon_context **context) {
  record_begin(recorded_rollcon_context_create);
  record_integer(header_abi);
  record_room(context);
  if (context) *context = (rollcon_context*)give_handle(1);
  return record_end();
}

rollcon_status rollcon_context_retain(rollcon_context *context) {
  record_begin(recorded_rollcon_context_retain);
  record_handle(context);
  return record_end();
}

void rollcon_context_release(rollcon_context *context) {
  record_begin(recorded_rollcon_context_release);
  record_handle(context);
}

rollcon_status rollcon_context_set_log(rollcon_context *context, int32_t max_level,
    rollcon_log_fn fn, void *user) {
  if (fn) fn(2, "a message", user);
  record_begin(recorded_rollcon_context_set_log);
  record_handle(context);
  record_integer(max_level);
  if (fn) record_integer(0); else record_room(0);
  return record_end();
}

rollcon_status rollcon_context_set_threads(rollcon_context *context, int32_t n) {
  record_begin(recorded_rollcon_context_set_threads);
  record_handle(context);
  record_integer(n);
  return record_end();
}

rollcon_status rollcon_context_set_latch(rollcon_context *context, int32_t on) {
  record_begin(recorded_rollcon_context_set_latch);
  record_handle(context);
  record_integer(on);
  return record_end();
}

rollcon_status rollcon_context_check(const rollcon_context *context) {
  record_begin(recorded_rollcon_context_check);
  record_handle(context);
  return record_end();
}

rollcon_status rollcon_body_create(rollcon_context *context, int32_t kind, rollcon_body **body) {
  record_begin(recorded_rollcon_body_create);
  record_handle(context);
  record_integer(kind);
  record_room(body);
  if (body) *body = (rollcon_body*)give_handle(2);
  return record_end();
}

rollcon_status rollcon_body_retain(rollcon_body *body) {
  record_begin(recorded_rollcon_body_retain);
  record_handle(body);
  return record_end();
}

void rollcon_body_release(rollcon_body *body) {
  record_begin(recorded_rollcon_body_release);
  record_handle(body);
}

rollcon_status rollcon_body_set_elastic(rollcon_body *body, int32_t tag, double young,
    double poisson) {
  record_begin(recorded_rollcon_body_set_elastic);
  record_handle(body);
  record_integer(tag);
  record_real(young);
  record_real(poisson);
  return record_end();
}

rollcon_status rollcon_body_prepare(rollcon_body *body) {
  record_begin(recorded_rollcon_body_prepare);
  record_handle(body);
  return record_end();
}

rollcon_status rollcon_body_get_kind(const rollcon_body *body, int32_t *kind) {
  record_begin(recorded_rollcon_body_get_kind);
  record_handle(body);
  record_room(kind);
  give_integer32(kind, 1, 1);
  return record_end();
}

rollcon_status rollcon_body_save(rollcon_body *body, const char *path) {
  record_begin(recorded_rollcon_body_save);
  record_handle(body);
  record_text(path);
  return record_end();
}

rollcon_status rollcon_body_load(rollcon_context *context, const char *path, rollcon_body **body) {
  record_begin(recorded_rollcon_body_load);
  record_handle(context);
  record_text(path);
  record_room(body);
  if (body) *body = (rollcon_body*)give_handle(2);
  return record_end();
}

rollcon_status rollcon_body_copy(const rollcon_body *body, rollcon_body **copy) {
  record_begin(recorded_rollcon_body_copy);
  record_handle(body);
  record_room(copy);
  if (copy) *copy = (rollcon_body*)give_handle(2);
  return record_end();
}

rollcon_status rollcon_body_set_nodes(rollcon_body *body, int64_t n, const double *x,
    int64_t node_stride, int64_t component_stride) {
  record_begin(recorded_rollcon_body_set_nodes);
  record_handle(body);
  record_integer(n);
  record_nodes(x, n, node_stride, component_stride);
  return record_end();
}

rollcon_status rollcon_body_add_elements(rollcon_body *body, int32_t type, int64_t n,
    const int32_t *connectivity, int32_t index_base, int32_t tag) {
  record_begin(recorded_rollcon_body_add_elements);
  record_handle(body);
  record_integer(type);
  record_integer(n);
  record_integers(connectivity, n * record_nodes_of(type));
  record_integer(index_base);
  record_integer(tag);
  return record_end();
}

rollcon_status rollcon_body_tag_faces(rollcon_body *body, int64_t n, const int32_t *elements,
    const int32_t *faces, int32_t index_base, int32_t tag) {
  record_begin(recorded_rollcon_body_tag_faces);
  record_handle(body);
  record_integer(n);
  record_integers(elements, n);
  record_integers(faces, n);
  record_integer(index_base);
  record_integer(tag);
  return record_end();
}

rollcon_status rollcon_body_tag_faces_of_nodes(rollcon_body *body, int64_t n,
    const int32_t *nodes, int32_t index_base, int32_t tag) {
  record_begin(recorded_rollcon_body_tag_faces_of_nodes);
  record_handle(body);
  record_integer(n);
  record_integers(nodes, n);
  record_integer(index_base);
  record_integer(tag);
  return record_end();
}

rollcon_status rollcon_body_set_support(rollcon_body *body, int64_t n, const int32_t *nodes,
    int32_t index_base, int32_t dof_mask, const double *values) {
  record_begin(recorded_rollcon_body_set_support);
  record_handle(body);
  record_integer(n);
  record_integers(nodes, n);
  record_integer(index_base);
  record_integer(dof_mask);
  record_reals(values, n * 3);
  return record_end();
}

rollcon_status rollcon_body_set_traction(rollcon_body *body, int32_t tag, const double *traction) {
  record_begin(recorded_rollcon_body_set_traction);
  record_handle(body);
  record_integer(tag);
  record_reals(traction, 3);
  return record_end();
}

rollcon_status rollcon_body_set_body_force(rollcon_body *body, int32_t tag, const double *force) {
  record_begin(recorded_rollcon_body_set_body_force);
  record_handle(body);
  record_integer(tag);
  record_reals(force, 3);
  return record_end();
}

rollcon_status rollcon_body_set_rotation(rollcon_body *body, int32_t tag, double density,
    const double *origin, const double *rate) {
  record_begin(recorded_rollcon_body_set_rotation);
  record_handle(body);
  record_integer(tag);
  record_real(density);
  record_reals(origin, 3);
  record_reals(rate, 3);
  return record_end();
}

rollcon_status rollcon_body_set_pressure(rollcon_body *body, int32_t tag, double pressure) {
  record_begin(recorded_rollcon_body_set_pressure);
  record_handle(body);
  record_integer(tag);
  record_real(pressure);
  return record_end();
}

rollcon_status rollcon_body_set_node_tractions(rollcon_body *body, int32_t tag, int64_t n,
    const int32_t *nodes, int32_t index_base, const double *along, const double *tractions) {
  record_begin(recorded_rollcon_body_set_node_tractions);
  record_handle(body);
  record_integer(tag);
  record_integer(n);
  record_integers(nodes, n);
  record_integer(index_base);
  record_reals(along, 3);
  record_reals(tractions, n * 3);
  return record_end();
}

rollcon_status rollcon_body_set_contact_faces(rollcon_body *body, int64_t n, const int32_t *tags) {
  record_begin(recorded_rollcon_body_set_contact_faces);
  record_handle(body);
  record_integer(n);
  record_integers(tags, n);
  return record_end();
}

rollcon_status rollcon_body_read_mesh(rollcon_body *body, const char *path, const char *part) {
  record_begin(recorded_rollcon_body_read_mesh);
  record_handle(body);
  record_text(path);
  record_text(part);
  return record_end();
}

rollcon_status rollcon_body_tag_group(rollcon_body *body, const char *group, int32_t tag) {
  record_begin(recorded_rollcon_body_tag_group);
  record_handle(body);
  record_text(group);
  record_integer(tag);
  return record_end();
}

rollcon_status rollcon_body_get_group_count(const rollcon_body *body, int32_t *n) {
  record_begin(recorded_rollcon_body_get_group_count);
  record_handle(body);
  record_room(n);
  give_integer32(n, 1, 1);
  return record_end();
}

rollcon_status rollcon_body_get_group_name(const rollcon_body *body, int32_t i, int64_t capacity,
    char *text, int64_t *needed) {
  record_begin(recorded_rollcon_body_get_group_name);
  record_handle(body);
  record_integer(i);
  record_integer(capacity);
  record_room(text);
  record_room(needed);
  give_text(text, capacity, needed, recorded_rollcon_body_get_group_name);
  return record_end();
}

rollcon_status rollcon_body_get_group_nodes(const rollcon_body *body, const char *group,
    int32_t index_base, int64_t capacity, int32_t *nodes, int64_t *n_nodes) {
  record_begin(recorded_rollcon_body_get_group_nodes);
  record_handle(body);
  record_text(group);
  record_integer(index_base);
  record_integer(capacity);
  record_room(nodes);
  record_room(n_nodes);
  give_integer32(nodes, capacity, 4);
  give_count(n_nodes, RECORD_NODES);
  return record_end();
}

rollcon_status rollcon_body_set_int(rollcon_body *body, const char *name, int64_t value) {
  record_begin(recorded_rollcon_body_set_int);
  record_handle(body);
  record_text(name);
  record_integer(value);
  return record_end();
}

rollcon_status rollcon_body_set_real(rollcon_body *body, const char *name, double value) {
  record_begin(recorded_rollcon_body_set_real);
  record_handle(body);
  record_text(name);
  record_real(value);
  return record_end();
}

rollcon_status rollcon_body_get_int(const rollcon_body *body, const char *name, int64_t *value) {
  record_begin(recorded_rollcon_body_get_int);
  record_handle(body);
  record_text(name);
  record_room(value);
  give_integer64(value, 2);
  return record_end();
}

rollcon_status rollcon_body_get_real(const rollcon_body *body, const char *name, double *value) {
  record_begin(recorded_rollcon_body_get_real);
  record_handle(body);
  record_text(name);
  record_room(value);
  give_reals(value, 1, 2);
  return record_end();
}

int32_t rollcon_body_option_count(void) {
  record_begin(recorded_rollcon_body_option_count);
  return RECORD_COUNT;
}

rollcon_status rollcon_body_option_info(int32_t i, int64_t capacity, char *name, int32_t *type,
    double *low, double *high, double *standard) {
  record_begin(recorded_rollcon_body_option_info);
  record_integer(i);
  record_integer(capacity);
  record_room(name);
  record_room(type);
  record_room(low);
  record_room(high);
  record_room(standard);
  give_text(name, capacity, 0, recorded_rollcon_body_option_info);
  give_integer32(type, 1, 3);
  give_reals(low, 1, 4);
  give_reals(high, 1, 5);
  give_reals(standard, 1, 6);
  return record_end();
}

rollcon_status rollcon_body_option_doc(int32_t i, int64_t capacity, char *text, int64_t *needed) {
  record_begin(recorded_rollcon_body_option_doc);
  record_integer(i);
  record_integer(capacity);
  record_room(text);
  record_room(needed);
  give_text(text, capacity, needed, recorded_rollcon_body_option_doc);
  return record_end();
}

rollcon_status rollcon_body_set_profile(rollcon_body *body, int64_t n, const double *points,
    double filter_length) {
  record_begin(recorded_rollcon_body_set_profile);
  record_handle(body);
  record_integer(n);
  record_reals(points, n * 2);
  record_real(filter_length);
  return record_end();
}

rollcon_status rollcon_body_set_profile_shape(rollcon_body *body, const char *shape, int64_t n,
    const double *parameters) {
  record_begin(recorded_rollcon_body_set_profile_shape);
  record_handle(body);
  record_text(shape);
  record_integer(n);
  record_reals(parameters, n);
  return record_end();
}

rollcon_status rollcon_body_read_profile(rollcon_body *body, const char *path, double unit,
    int32_t mirror, double filter_length) {
  record_begin(recorded_rollcon_body_read_profile);
  record_handle(body);
  record_text(path);
  record_real(unit);
  record_integer(mirror);
  record_real(filter_length);
  return record_end();
}

rollcon_status rollcon_body_write_profile(const rollcon_body *body, const char *path,
    double unit) {
  record_begin(recorded_rollcon_body_write_profile);
  record_handle(body);
  record_text(path);
  record_real(unit);
  return record_end();
}

rollcon_status rollcon_body_extrude_profile(rollcon_body *body, const double *origin,
    const double *along, const double *z_axis) {
  record_begin(recorded_rollcon_body_extrude_profile);
  record_handle(body);
  record_reals(origin, 3);
  record_reals(along, 3);
  record_reals(z_axis, 3);
  return record_end();
}

rollcon_status rollcon_body_revolve_profile(rollcon_body *body, const double *origin,
    const double *axis, double radius) {
  record_begin(recorded_rollcon_body_revolve_profile);
  record_handle(body);
  record_reals(origin, 3);
  record_reals(axis, 3);
  record_real(radius);
  return record_end();
}

rollcon_status rollcon_body_get_profile_length(const rollcon_body *body, double *length) {
  record_begin(recorded_rollcon_body_get_profile_length);
  record_handle(body);
  record_room(length);
  give_reals(length, 1, 1);
  return record_end();
}

rollcon_status rollcon_body_get_profile_point(const rollcon_body *body, double s, double *point,
    double *tangent, double *curvature) {
  record_begin(recorded_rollcon_body_get_profile_point);
  record_handle(body);
  record_real(s);
  record_room(point);
  record_room(tangent);
  record_room(curvature);
  give_reals(point, 2, 2);
  give_reals(tangent, 2, 3);
  give_reals(curvature, 1, 4);
  return record_end();
}

rollcon_status rollcon_body_get_size(const rollcon_body *body, int64_t *nodes, int64_t *elements) {
  record_begin(recorded_rollcon_body_get_size);
  record_handle(body);
  record_room(nodes);
  record_room(elements);
  give_count(nodes, RECORD_NODES);
  give_count(elements, RECORD_ELEMENTS);
  return record_end();
}

rollcon_status rollcon_body_get_displacements(const rollcon_body *body, int64_t capacity,
    double *u) {
  record_begin(recorded_rollcon_body_get_displacements);
  record_handle(body);
  record_integer(capacity);
  record_room(u);
  give_reals(u, capacity * 3, 2);
  return record_end();
}

rollcon_status rollcon_body_get_node_stresses(const rollcon_body *body, int64_t nodes,
    const double *u, double *stress) {
  record_begin(recorded_rollcon_body_get_node_stresses);
  record_handle(body);
  record_integer(nodes);
  record_reals(u, nodes * 3);
  record_room(stress);
  give_reals(stress, nodes * 6, 3);
  return record_end();
}

rollcon_status rollcon_body_get_point_stresses(const rollcon_body *body, int64_t nodes,
    const double *u, int64_t capacity, double *stress, double *xyz, int64_t *n_rows) {
  record_begin(recorded_rollcon_body_get_point_stresses);
  record_handle(body);
  record_integer(nodes);
  record_reals(u, nodes * 3);
  record_integer(capacity);
  record_room(stress);
  record_room(xyz);
  record_room(n_rows);
  give_reals(stress, capacity * 6, 4);
  give_reals(xyz, capacity * 3, 5);
  give_count(n_rows, RECORD_ROWS);
  return record_end();
}

rollcon_status rollcon_body_get_fields_at(const rollcon_body *body, int64_t nodes,
    const double *u, int64_t n, const double *xyz, double *displacement, double *stress) {
  record_begin(recorded_rollcon_body_get_fields_at);
  record_handle(body);
  record_integer(nodes);
  record_reals(u, nodes * 3);
  record_integer(n);
  record_reals(xyz, n * 3);
  record_room(displacement);
  record_room(stress);
  give_reals(displacement, n * 3, 5);
  give_reals(stress, n * 6, 6);
  return record_end();
}

rollcon_status rollcon_body_write(const rollcon_body *body, const char *path, int64_t nodes,
    const double *u) {
  record_begin(recorded_rollcon_body_write);
  record_handle(body);
  record_text(path);
  record_integer(nodes);
  record_reals(u, nodes * 3);
  return record_end();
}

rollcon_status rollcon_body_get_reaction(const rollcon_body *body, double *force, double *moment) {
  record_begin(recorded_rollcon_body_get_reaction);
  record_handle(body);
  record_room(force);
  record_room(moment);
  give_reals(force, 3, 1);
  give_reals(moment, 3, 2);
  return record_end();
}

rollcon_status rollcon_body_get_stat(const rollcon_body *body, const char *name, double *value) {
  record_begin(recorded_rollcon_body_get_stat);
  record_handle(body);
  record_text(name);
  record_room(value);
  give_reals(value, 1, 2);
  return record_end();
}

int32_t rollcon_body_stat_count(void) {
  record_begin(recorded_rollcon_body_stat_count);
  return RECORD_COUNT;
}

rollcon_status rollcon_body_stat_name(int32_t i, int64_t capacity, char *text, int64_t *needed) {
  record_begin(recorded_rollcon_body_stat_name);
  record_integer(i);
  record_integer(capacity);
  record_room(text);
  record_room(needed);
  give_text(text, capacity, needed, recorded_rollcon_body_stat_name);
  return record_end();
}

rollcon_status rollcon_contact_create(rollcon_context *context, rollcon_body *body1,
    rollcon_body *body2, rollcon_contact **contact) {
  record_begin(recorded_rollcon_contact_create);
  record_handle(context);
  record_handle(body1);
  record_handle(body2);
  record_room(contact);
  if (contact) *contact = (rollcon_contact*)give_handle(3);
  return record_end();
}

rollcon_status rollcon_contact_retain(rollcon_contact *contact) {
  record_begin(recorded_rollcon_contact_retain);
  record_handle(contact);
  return record_end();
}

void rollcon_contact_release(rollcon_contact *contact) {
  record_begin(recorded_rollcon_contact_release);
  record_handle(contact);
}

rollcon_status rollcon_contact_set_frame_nodes(rollcon_contact *contact, int64_t n,
    const double *x, int64_t node_stride, int64_t component_stride) {
  record_begin(recorded_rollcon_contact_set_frame_nodes);
  record_handle(contact);
  record_integer(n);
  record_nodes(x, n, node_stride, component_stride);
  return record_end();
}

rollcon_status rollcon_contact_add_frame_elements(rollcon_contact *contact, int32_t type,
    int64_t n, const int32_t *connectivity, int32_t index_base, int32_t tag) {
  record_begin(recorded_rollcon_contact_add_frame_elements);
  record_handle(contact);
  record_integer(type);
  record_integer(n);
  record_integers(connectivity, n * record_nodes_of(type));
  record_integer(index_base);
  record_integer(tag);
  return record_end();
}

rollcon_status rollcon_contact_read_frame(rollcon_contact *contact, const char *path,
    const char *part) {
  record_begin(recorded_rollcon_contact_read_frame);
  record_handle(contact);
  record_text(path);
  record_text(part);
  return record_end();
}

rollcon_status rollcon_contact_frame_from_body(rollcon_contact *contact, int32_t which,
    int32_t tag) {
  record_begin(recorded_rollcon_contact_frame_from_body);
  record_handle(contact);
  record_integer(which);
  record_integer(tag);
  return record_end();
}

rollcon_status rollcon_contact_frame_rectangle(rollcon_contact *contact, int32_t type,
    int32_t nx, int32_t ny, double x_least, double x_greatest, double y_least,
    double y_greatest) {
  record_begin(recorded_rollcon_contact_frame_rectangle);
  record_handle(contact);
  record_integer(type);
  record_integer(nx);
  record_integer(ny);
  record_real(x_least);
  record_real(x_greatest);
  record_real(y_least);
  record_real(y_greatest);
  return record_end();
}

rollcon_status rollcon_contact_frame_ellipse(rollcon_contact *contact, int32_t along,
    int32_t across, double a, double b, double angle) {
  record_begin(recorded_rollcon_contact_frame_ellipse);
  record_handle(contact);
  record_integer(along);
  record_integer(across);
  record_real(a);
  record_real(b);
  record_real(angle);
  return record_end();
}

rollcon_status rollcon_contact_frame_strips(rollcon_contact *contact, int32_t along, int64_t n,
    const double *lines) {
  record_begin(recorded_rollcon_contact_frame_strips);
  record_handle(contact);
  record_integer(along);
  record_integer(n);
  record_reals(lines, n * 3);
  return record_end();
}

rollcon_status rollcon_contact_frame_automatic(rollcon_contact *contact) {
  record_begin(recorded_rollcon_contact_frame_automatic);
  record_handle(contact);
  return record_end();
}

rollcon_status rollcon_contact_set_pose(rollcon_contact *contact, int32_t which,
    const double *rotation, const double *translation) {
  record_begin(recorded_rollcon_contact_set_pose);
  record_handle(contact);
  record_integer(which);
  record_reals(rotation, 3 * 3);
  record_reals(translation, 3);
  return record_end();
}

rollcon_status rollcon_contact_set_axes(rollcon_contact *contact, const double *origin,
    const double *rolling, const double *normal) {
  record_begin(recorded_rollcon_contact_set_axes);
  record_handle(contact);
  record_reals(origin, 3);
  record_reals(rolling, 3);
  record_reals(normal, 3);
  return record_end();
}

rollcon_status rollcon_contact_set_gap(rollcon_contact *contact, int64_t n, const double *gap) {
  record_begin(recorded_rollcon_contact_set_gap);
  record_handle(contact);
  record_integer(n);
  record_reals(gap, n);
  return record_end();
}

rollcon_status rollcon_contact_set_gap_quadratic(rollcon_contact *contact, double a, double b,
    double c) {
  record_begin(recorded_rollcon_contact_set_gap_quadratic);
  record_handle(contact);
  record_real(a);
  record_real(b);
  record_real(c);
  return record_end();
}

rollcon_status rollcon_contact_set_gap_grid(rollcon_contact *contact, int32_t nx, double x_least,
    double x_greatest, double y_least, double y_greatest, int64_t n, const double *gap) {
  record_begin(recorded_rollcon_contact_set_gap_grid);
  record_handle(contact);
  record_integer(nx);
  record_real(x_least);
  record_real(x_greatest);
  record_real(y_least);
  record_real(y_greatest);
  record_integer(n);
  record_reals(gap, n);
  return record_end();
}

rollcon_status rollcon_contact_set_rolling(rollcon_contact *contact, double speed) {
  record_begin(recorded_rollcon_contact_set_rolling);
  record_handle(contact);
  record_real(speed);
  return record_end();
}

rollcon_status rollcon_contact_set_creep(rollcon_contact *contact, double longitudinal,
    double lateral, double spin) {
  record_begin(recorded_rollcon_contact_set_creep);
  record_handle(contact);
  record_real(longitudinal);
  record_real(lateral);
  record_real(spin);
  return record_end();
}

rollcon_status rollcon_contact_set_step(rollcon_contact *contact, int32_t kind, double dt) {
  record_begin(recorded_rollcon_contact_set_step);
  record_handle(contact);
  record_integer(kind);
  record_real(dt);
  return record_end();
}

rollcon_status rollcon_contact_set_velocity(rollcon_contact *contact, int32_t which,
    const double *velocity, const double *angular_velocity, const double *point) {
  record_begin(recorded_rollcon_contact_set_velocity);
  record_handle(contact);
  record_integer(which);
  record_reals(velocity, 3);
  record_reals(angular_velocity, 3);
  record_reals(point, 3);
  return record_end();
}

rollcon_status rollcon_contact_set_creep_field(rollcon_contact *contact, int64_t n,
    const double *slip) {
  record_begin(recorded_rollcon_contact_set_creep_field);
  record_handle(contact);
  record_integer(n);
  record_reals(slip, n * 2);
  return record_end();
}

rollcon_status rollcon_contact_prescribe(rollcon_contact *contact, int32_t direction,
    int32_t how, double value) {
  record_begin(recorded_rollcon_contact_prescribe);
  record_handle(contact);
  record_integer(direction);
  record_integer(how);
  record_real(value);
  return record_end();
}

rollcon_status rollcon_contact_set_friction(rollcon_contact *contact, const char *law, int32_t n,
    const double *parameters) {
  record_begin(recorded_rollcon_contact_set_friction);
  record_handle(contact);
  record_text(law);
  record_integer(n);
  record_reals(parameters, n);
  return record_end();
}

rollcon_status rollcon_contact_set_friction_memory(rollcon_contact *contact, double length,
    double least_speed) {
  record_begin(recorded_rollcon_contact_set_friction_memory);
  record_handle(contact);
  record_real(length);
  record_real(least_speed);
  return record_end();
}

rollcon_status rollcon_contact_set_layer(rollcon_contact *contact, double flexibility) {
  record_begin(recorded_rollcon_contact_set_layer);
  record_handle(contact);
  record_real(flexibility);
  return record_end();
}

rollcon_status rollcon_contact_set_layer_yield(rollcon_contact *contact, double stress,
    double hardening) {
  record_begin(recorded_rollcon_contact_set_layer_yield);
  record_handle(contact);
  record_real(stress);
  record_real(hardening);
  return record_end();
}

rollcon_status rollcon_contact_set_friction_across(rollcon_contact *contact, int64_t n,
    const double *points) {
  record_begin(recorded_rollcon_contact_set_friction_across);
  record_handle(contact);
  record_integer(n);
  record_reals(points, n * 2);
  return record_end();
}

rollcon_status rollcon_contact_set_heat(rollcon_contact *contact, int32_t which,
    double conductivity, double heat_capacity, double temperature) {
  record_begin(recorded_rollcon_contact_set_heat);
  record_handle(contact);
  record_integer(which);
  record_real(conductivity);
  record_real(heat_capacity);
  record_real(temperature);
  return record_end();
}

rollcon_status rollcon_contact_set_friction_field(rollcon_contact *contact, int64_t n,
    const double *mu) {
  record_begin(recorded_rollcon_contact_set_friction_field);
  record_handle(contact);
  record_integer(n);
  record_reals(mu, n);
  return record_end();
}

rollcon_status rollcon_contact_set_int(rollcon_contact *contact, const char *name, int64_t value) {
  record_begin(recorded_rollcon_contact_set_int);
  record_handle(contact);
  record_text(name);
  record_integer(value);
  return record_end();
}

rollcon_status rollcon_contact_set_real(rollcon_contact *contact, const char *name, double value) {
  record_begin(recorded_rollcon_contact_set_real);
  record_handle(contact);
  record_text(name);
  record_real(value);
  return record_end();
}

rollcon_status rollcon_contact_set_str(rollcon_contact *contact, const char *name,
    const char *value) {
  record_begin(recorded_rollcon_contact_set_str);
  record_handle(contact);
  record_text(name);
  record_text(value);
  return record_end();
}

rollcon_status rollcon_contact_get_int(const rollcon_contact *contact, const char *name,
    int64_t *value) {
  record_begin(recorded_rollcon_contact_get_int);
  record_handle(contact);
  record_text(name);
  record_room(value);
  give_integer64(value, 2);
  return record_end();
}

rollcon_status rollcon_contact_get_real(const rollcon_contact *contact, const char *name,
    double *value) {
  record_begin(recorded_rollcon_contact_get_real);
  record_handle(contact);
  record_text(name);
  record_room(value);
  give_reals(value, 1, 2);
  return record_end();
}

rollcon_status rollcon_contact_get_str(const rollcon_contact *contact, const char *name,
    int64_t capacity, char *text, int64_t *needed) {
  record_begin(recorded_rollcon_contact_get_str);
  record_handle(contact);
  record_text(name);
  record_integer(capacity);
  record_room(text);
  record_room(needed);
  give_text(text, capacity, needed, recorded_rollcon_contact_get_str);
  return record_end();
}

int32_t rollcon_option_count(void) {
  record_begin(recorded_rollcon_option_count);
  return RECORD_COUNT;
}

rollcon_status rollcon_option_info(int32_t i, int64_t capacity, char *name, int32_t *type,
    double *low, double *high, double *standard) {
  record_begin(recorded_rollcon_option_info);
  record_integer(i);
  record_integer(capacity);
  record_room(name);
  record_room(type);
  record_room(low);
  record_room(high);
  record_room(standard);
  give_text(name, capacity, 0, recorded_rollcon_option_info);
  give_integer32(type, 1, 3);
  give_reals(low, 1, 4);
  give_reals(high, 1, 5);
  give_reals(standard, 1, 6);
  return record_end();
}

rollcon_status rollcon_option_doc(int32_t i, int64_t capacity, char *text, int64_t *needed) {
  record_begin(recorded_rollcon_option_doc);
  record_integer(i);
  record_integer(capacity);
  record_room(text);
  record_room(needed);
  give_text(text, capacity, needed, recorded_rollcon_option_doc);
  return record_end();
}

rollcon_status rollcon_contact_set_progress(rollcon_contact *contact, rollcon_progress_fn fn,
    void *user) {
  const int64_t told = fn ? fn((const rollcon_event*)7, user) : 0;
  record_begin(recorded_rollcon_contact_set_progress);
  record_handle(contact);
  if (fn) record_integer(told); else record_room(0);
  return record_end();
}

rollcon_status rollcon_event_get_int(const rollcon_event *event, int32_t key, int64_t *value) {
  record_begin(recorded_rollcon_event_get_int);
  record_integer((intptr_t)event);
  record_integer(key);
  record_room(value);
  give_integer64(value, 2);
  return record_end();
}

rollcon_status rollcon_event_get_real(const rollcon_event *event, int32_t key, double *value) {
  record_begin(recorded_rollcon_event_get_real);
  record_integer((intptr_t)event);
  record_integer(key);
  record_room(value);
  give_reals(value, 1, 2);
  return record_end();
}

rollcon_status rollcon_contact_request_cancel(rollcon_contact *contact) {
  record_begin(recorded_rollcon_contact_request_cancel);
  record_handle(contact);
  return record_end();
}

rollcon_status rollcon_contact_solve(rollcon_contact *contact) {
  record_begin(recorded_rollcon_contact_solve);
  record_handle(contact);
  return record_end();
}

rollcon_status rollcon_contact_solve_many(rollcon_contact *contact, const char *parameters,
    int64_t n_cases, const double *values, const char *columns, int64_t capacity,
    double *results, int64_t *n_results, int32_t *status) {
  record_begin(recorded_rollcon_contact_solve_many);
  record_handle(contact);
  record_text(parameters);
  record_integer(n_cases);
  record_reals(values, n_cases * record_words(parameters));
  record_text(columns);
  record_integer(capacity);
  record_room(results);
  record_room(n_results);
  record_room(status);
  give_reals(results, n_cases * capacity, 6);
  give_count(n_results, capacity);
  give_integer32(status, n_cases, 8);
  return record_end();
}

rollcon_status rollcon_contact_repeat_step(rollcon_contact *contact) {
  record_begin(recorded_rollcon_contact_repeat_step);
  record_handle(contact);
  return record_end();
}

rollcon_status rollcon_contact_save_past(const rollcon_contact *contact, int64_t capacity,
    double *past, int64_t *n_values) {
  record_begin(recorded_rollcon_contact_save_past);
  record_handle(contact);
  record_integer(capacity);
  record_room(past);
  record_room(n_values);
  give_reals(past, capacity, 2);
  give_count(n_values, RECORD_VALUES);
  return record_end();
}

rollcon_status rollcon_contact_restore_past(rollcon_contact *contact, int64_t n,
    const double *past) {
  record_begin(recorded_rollcon_contact_restore_past);
  record_handle(contact);
  record_integer(n);
  record_reals(past, n);
  return record_end();
}

rollcon_status rollcon_contact_reset(rollcon_contact *contact) {
  record_begin(recorded_rollcon_contact_reset);
  record_handle(contact);
  return record_end();
}

rollcon_status rollcon_contact_get_size(const rollcon_contact *contact, int64_t *nodes,
    int64_t *elements) {
  record_begin(recorded_rollcon_contact_get_size);
  record_handle(contact);
  record_room(nodes);
  record_room(elements);
  give_count(nodes, RECORD_NODES);
  give_count(elements, RECORD_ELEMENTS);
  return record_end();
}

rollcon_status rollcon_contact_get_tractions(const rollcon_contact *contact, int32_t axes,
    int64_t capacity, double *t) {
  record_begin(recorded_rollcon_contact_get_tractions);
  record_handle(contact);
  record_integer(axes);
  record_integer(capacity);
  record_room(t);
  give_reals(t, capacity * 3, 3);
  return record_end();
}

rollcon_status rollcon_contact_get_field(const rollcon_contact *contact, int32_t field,
    int32_t axes, int64_t capacity, double *v, int64_t *n_values) {
  record_begin(recorded_rollcon_contact_get_field);
  record_handle(contact);
  record_integer(field);
  record_integer(axes);
  record_integer(capacity);
  record_room(v);
  record_room(n_values);
  give_reals(v, capacity, 4);
  give_count(n_values, RECORD_VALUES);
  return record_end();
}

rollcon_status rollcon_contact_get_status(const rollcon_contact *contact, int64_t capacity,
    int32_t *status) {
  record_begin(recorded_rollcon_contact_get_status);
  record_handle(contact);
  record_integer(capacity);
  record_room(status);
  give_integer32(status, capacity, 2);
  return record_end();
}

rollcon_status rollcon_contact_get_resultant(const rollcon_contact *contact, int32_t axes,
    double *force, double *moment) {
  record_begin(recorded_rollcon_contact_get_resultant);
  record_handle(contact);
  record_integer(axes);
  record_room(force);
  record_room(moment);
  give_reals(force, 3, 2);
  give_reals(moment, 3, 3);
  return record_end();
}

rollcon_status rollcon_contact_get_motion(const rollcon_contact *contact, double *approach,
    double *creep) {
  record_begin(recorded_rollcon_contact_get_motion);
  record_handle(contact);
  record_room(approach);
  record_room(creep);
  give_reals(approach, 1, 1);
  give_reals(creep, 3, 2);
  return record_end();
}

rollcon_status rollcon_contact_get_tilt(const rollcon_contact *contact, double *tilt) {
  record_begin(recorded_rollcon_contact_get_tilt);
  record_handle(contact);
  record_room(tilt);
  give_reals(tilt, 2, 1);
  return record_end();
}

rollcon_status rollcon_contact_get_sensitivity(const rollcon_contact *contact, int32_t parameter,
    double *force, double *moment, double *approach, double *creep) {
  record_begin(recorded_rollcon_contact_get_sensitivity);
  record_handle(contact);
  record_integer(parameter);
  record_room(force);
  record_room(moment);
  record_room(approach);
  record_room(creep);
  give_reals(force, 3, 2);
  give_reals(moment, 3, 3);
  give_reals(approach, 1, 4);
  give_reals(creep, 3, 5);
  return record_end();
}

rollcon_status rollcon_contact_get_displacements_at(const rollcon_contact *contact, int32_t body,
    int64_t n, const double *xy, double *u) {
  record_begin(recorded_rollcon_contact_get_displacements_at);
  record_handle(contact);
  record_integer(body);
  record_integer(n);
  record_reals(xy, n * 2);
  record_room(u);
  give_reals(u, n * 3, 4);
  return record_end();
}

rollcon_status rollcon_contact_get_stresses_at(const rollcon_contact *contact, int32_t body,
    int64_t n, const double *xyz, double *stress, double *u) {
  record_begin(recorded_rollcon_contact_get_stresses_at);
  record_handle(contact);
  record_integer(body);
  record_integer(n);
  record_reals(xyz, n * 3);
  record_room(stress);
  record_room(u);
  give_reals(stress, n * 6, 4);
  give_reals(u, n * 3, 5);
  return record_end();
}

rollcon_status rollcon_contact_get_body_displacements(const rollcon_contact *contact,
    int32_t body, int64_t capacity, double *u, int64_t *n_values) {
  record_begin(recorded_rollcon_contact_get_body_displacements);
  record_handle(contact);
  record_integer(body);
  record_integer(capacity);
  record_room(u);
  record_room(n_values);
  give_reals(u, capacity, 3);
  give_count(n_values, RECORD_VALUES);
  return record_end();
}

rollcon_status rollcon_contact_get_body_fields_at(const rollcon_contact *contact, int32_t body,
    int64_t n, const double *xyz, double *displacement, double *stress) {
  record_begin(recorded_rollcon_contact_get_body_fields_at);
  record_handle(contact);
  record_integer(body);
  record_integer(n);
  record_reals(xyz, n * 3);
  record_room(displacement);
  record_room(stress);
  give_reals(displacement, n * 3, 4);
  give_reals(stress, n * 6, 5);
  return record_end();
}

rollcon_status rollcon_contact_write_body(const rollcon_contact *contact, int32_t body,
    const char *path) {
  record_begin(recorded_rollcon_contact_write_body);
  record_handle(contact);
  record_integer(body);
  record_text(path);
  return record_end();
}

rollcon_status rollcon_contact_get_temperatures_at(const rollcon_contact *contact, int64_t n,
    const double *xy, double *temperature) {
  record_begin(recorded_rollcon_contact_get_temperatures_at);
  record_handle(contact);
  record_integer(n);
  record_reals(xy, n * 2);
  record_room(temperature);
  give_reals(temperature, n * 2, 3);
  return record_end();
}

rollcon_status rollcon_contact_get_fatigue_index(const rollcon_contact *contact,
    double shear_yield, double *index) {
  record_begin(recorded_rollcon_contact_get_fatigue_index);
  record_handle(contact);
  record_real(shear_yield);
  record_room(index);
  give_reals(index, 1, 2);
  return record_end();
}

rollcon_status rollcon_contact_get_equivalent_ellipse(const rollcon_contact *contact,
    double *inputs, double *center) {
  record_begin(recorded_rollcon_contact_get_equivalent_ellipse);
  record_handle(contact);
  record_room(inputs);
  record_room(center);
  give_reals(inputs, 9, 1);
  give_reals(center, 2, 2);
  return record_end();
}

rollcon_status rollcon_contact_get_wear(const rollcon_contact *contact, const char *law,
    int32_t n, const double *parameters, int64_t points, const double *y, double *depth,
    double *volume) {
  record_begin(recorded_rollcon_contact_get_wear);
  record_handle(contact);
  record_text(law);
  record_integer(n);
  record_reals(parameters, n);
  record_integer(points);
  record_reals(y, points);
  record_room(depth);
  record_room(volume);
  give_reals(depth, points, 6);
  give_reals(volume, 1, 7);
  return record_end();
}

rollcon_status rollcon_wear_profile(int64_t points, const double *yz, const double *rate,
    int32_t side, double distance, double most_depth, double smoothing, double *worn,
    double *taken) {
  record_begin(recorded_rollcon_wear_profile);
  record_integer(points);
  record_reals(yz, points * 2);
  record_reals(rate, points);
  record_integer(side);
  record_real(distance);
  record_real(most_depth);
  record_real(smoothing);
  record_room(worn);
  record_room(taken);
  give_reals(worn, points * 2, 7);
  give_reals(taken, 1, 8);
  return record_end();
}

rollcon_status rollcon_stress_invariants(int64_t n, const double *stress, double *principal,
    double *von_mises, double *shear) {
  record_begin(recorded_rollcon_stress_invariants);
  record_integer(n);
  record_reals(stress, n * 6);
  record_room(principal);
  record_room(von_mises);
  record_room(shear);
  give_reals(principal, n * 3, 2);
  give_reals(von_mises, n, 3);
  give_reals(shear, n, 4);
  return record_end();
}

rollcon_status rollcon_contact_get_stat(const rollcon_contact *contact, const char *name,
    double *value) {
  record_begin(recorded_rollcon_contact_get_stat);
  record_handle(contact);
  record_text(name);
  record_room(value);
  give_reals(value, 1, 2);
  return record_end();
}

int32_t rollcon_stat_count(void) {
  record_begin(recorded_rollcon_stat_count);
  return RECORD_COUNT;
}

rollcon_status rollcon_stat_name(int32_t i, int64_t capacity, char *text, int64_t *needed) {
  record_begin(recorded_rollcon_stat_name);
  record_integer(i);
  record_integer(capacity);
  record_room(text);
  record_room(needed);
  give_text(text, capacity, needed, recorded_rollcon_stat_name);
  return record_end();
}

rollcon_status rollcon_contact_get_history(const rollcon_contact *contact, int64_t capacity,
    double *rows, int64_t *n_rows) {
  record_begin(recorded_rollcon_contact_get_history);
  record_handle(contact);
  record_integer(capacity);
  record_room(rows);
  record_room(n_rows);
  give_reals(rows, capacity * 8, 2);
  give_count(n_rows, RECORD_ROWS);
  return record_end();
}

rollcon_status rollcon_contact_get_error_function(const rollcon_contact *contact,
    int64_t capacity, double *psi, double *seconds, int64_t *n_rows) {
  record_begin(recorded_rollcon_contact_get_error_function);
  record_handle(contact);
  record_integer(capacity);
  record_room(psi);
  record_room(seconds);
  record_room(n_rows);
  give_reals(psi, capacity, 2);
  give_reals(seconds, capacity, 3);
  give_count(n_rows, RECORD_ROWS);
  return record_end();
}

rollcon_status rollcon_contact_get_plan(const rollcon_contact *contact, int64_t capacity,
    char *text, int64_t *needed) {
  record_begin(recorded_rollcon_contact_get_plan);
  record_handle(contact);
  record_integer(capacity);
  record_room(text);
  record_room(needed);
  give_text(text, capacity, needed, recorded_rollcon_contact_get_plan);
  return record_end();
}

rollcon_status rollcon_contact_write(const rollcon_contact *contact, const char *path) {
  record_begin(recorded_rollcon_contact_write);
  record_handle(contact);
  record_text(path);
  return record_end();
}

rollcon_status rollcon_wheelrail_create(rollcon_context *context, rollcon_body *wheel,
    rollcon_body *rail, int32_t side, rollcon_wheelrail **wheelrail) {
  record_begin(recorded_rollcon_wheelrail_create);
  record_handle(context);
  record_handle(wheel);
  record_handle(rail);
  record_integer(side);
  record_room(wheelrail);
  if (wheelrail) *wheelrail = (rollcon_wheelrail*)give_handle(4);
  return record_end();
}

rollcon_status rollcon_wheelrail_retain(rollcon_wheelrail *wheelrail) {
  record_begin(recorded_rollcon_wheelrail_retain);
  record_handle(wheelrail);
  return record_end();
}

void rollcon_wheelrail_release(rollcon_wheelrail *wheelrail) {
  record_begin(recorded_rollcon_wheelrail_release);
  record_handle(wheelrail);
}

rollcon_status rollcon_wheelrail_set_track(rollcon_wheelrail *wheelrail, double gauge,
    double gauge_height, double cant) {
  record_begin(recorded_rollcon_wheelrail_set_track);
  record_handle(wheelrail);
  record_real(gauge);
  record_real(gauge_height);
  record_real(cant);
  return record_end();
}

rollcon_status rollcon_wheelrail_set_wheelset(rollcon_wheelrail *wheelrail, double back_to_back,
    double flange_back, double radius) {
  record_begin(recorded_rollcon_wheelrail_set_wheelset);
  record_handle(wheelrail);
  record_real(back_to_back);
  record_real(flange_back);
  record_real(radius);
  return record_end();
}

rollcon_status rollcon_wheelrail_set_rail_deviation(rollcon_wheelrail *wheelrail,
    const double *deviation, const double *rate) {
  record_begin(recorded_rollcon_wheelrail_set_rail_deviation);
  record_handle(wheelrail);
  record_reals(deviation, 3);
  record_reals(rate, 3);
  return record_end();
}

rollcon_status rollcon_wheelrail_set_position(rollcon_wheelrail *wheelrail,
    const double *position) {
  record_begin(recorded_rollcon_wheelrail_set_position);
  record_handle(wheelrail);
  record_reals(position, 6);
  return record_end();
}

rollcon_status rollcon_wheelrail_set_roll_outside(rollcon_wheelrail *wheelrail, int32_t on) {
  record_begin(recorded_rollcon_wheelrail_set_roll_outside);
  record_handle(wheelrail);
  record_integer(on);
  return record_end();
}

rollcon_status rollcon_wheelrail_set_velocity(rollcon_wheelrail *wheelrail,
    const double *velocity) {
  record_begin(recorded_rollcon_wheelrail_set_velocity);
  record_handle(wheelrail);
  record_reals(velocity, 6);
  return record_end();
}

rollcon_status rollcon_wheelrail_prescribe_vertical(rollcon_wheelrail *wheelrail, int32_t how,
    double force) {
  record_begin(recorded_rollcon_wheelrail_prescribe_vertical);
  record_handle(wheelrail);
  record_integer(how);
  record_real(force);
  return record_end();
}

rollcon_status rollcon_wheelrail_set_friction(rollcon_wheelrail *wheelrail, double mu) {
  record_begin(recorded_rollcon_wheelrail_set_friction);
  record_handle(wheelrail);
  record_real(mu);
  return record_end();
}

rollcon_status rollcon_wheelrail_set_table(rollcon_wheelrail *wheelrail,
    const rollcon_table *table) {
  record_begin(recorded_rollcon_wheelrail_set_table);
  record_handle(wheelrail);
  record_handle(table);
  return record_end();
}

rollcon_status rollcon_wheelrail_forget_table(rollcon_wheelrail *wheelrail) {
  record_begin(recorded_rollcon_wheelrail_forget_table);
  record_handle(wheelrail);
  return record_end();
}

rollcon_status rollcon_wheelrail_set_hertzian(rollcon_wheelrail *wheelrail, int32_t on) {
  record_begin(recorded_rollcon_wheelrail_set_hertzian);
  record_handle(wheelrail);
  record_integer(on);
  return record_end();
}

rollcon_status rollcon_wheelrail_set_conformal(rollcon_wheelrail *wheelrail, int32_t on) {
  record_begin(recorded_rollcon_wheelrail_set_conformal);
  record_handle(wheelrail);
  record_integer(on);
  return record_end();
}

rollcon_status rollcon_wheelrail_set_friction_by_angle(rollcon_wheelrail *wheelrail, int64_t n,
    const double *points) {
  record_begin(recorded_rollcon_wheelrail_set_friction_by_angle);
  record_handle(wheelrail);
  record_integer(n);
  record_reals(points, n * 2);
  return record_end();
}

rollcon_status rollcon_wheelrail_set_accuracy(rollcon_wheelrail *wheelrail, double accuracy) {
  record_begin(recorded_rollcon_wheelrail_set_accuracy);
  record_handle(wheelrail);
  record_real(accuracy);
  return record_end();
}

rollcon_status rollcon_wheelrail_solve(rollcon_wheelrail *wheelrail) {
  record_begin(recorded_rollcon_wheelrail_solve);
  record_handle(wheelrail);
  return record_end();
}

rollcon_status rollcon_wheelrail_request_cancel(rollcon_wheelrail *wheelrail) {
  record_begin(recorded_rollcon_wheelrail_request_cancel);
  record_handle(wheelrail);
  return record_end();
}

rollcon_status rollcon_wheelrail_solve_many(rollcon_wheelrail *wheelrail, int64_t n,
    const double *positions, const double *velocities, double *totals, int32_t *status) {
  record_begin(recorded_rollcon_wheelrail_solve_many);
  record_handle(wheelrail);
  record_integer(n);
  record_reals(positions, n * 6);
  record_reals(velocities, n * 6);
  record_room(totals);
  record_room(status);
  give_reals(totals, n * 9, 4);
  give_integer32(status, n, 5);
  return record_end();
}

rollcon_status rollcon_wheelrail_find_wear(rollcon_wheelrail *wheelrail, int64_t n_cases,
    const double *positions, const double *velocities, const double *weights, const char *law,
    int32_t n, const double *parameters, int64_t points, double *wheel, double *rail,
    double *volumes, int32_t *status) {
  record_begin(recorded_rollcon_wheelrail_find_wear);
  record_handle(wheelrail);
  record_integer(n_cases);
  record_reals(positions, n_cases * 6);
  record_reals(velocities, n_cases * 6);
  record_reals(weights, n_cases);
  record_text(law);
  record_integer(n);
  record_reals(parameters, n);
  record_integer(points);
  record_room(wheel);
  record_room(rail);
  record_room(volumes);
  record_room(status);
  give_reals(wheel, points, 9);
  give_reals(rail, points, 10);
  give_reals(volumes, 2, 11);
  give_integer32(status, n_cases, 12);
  return record_end();
}

rollcon_status rollcon_wheelrail_save(rollcon_wheelrail *wheelrail, int32_t place) {
  record_begin(recorded_rollcon_wheelrail_save);
  record_handle(wheelrail);
  record_integer(place);
  return record_end();
}

rollcon_status rollcon_wheelrail_restore(rollcon_wheelrail *wheelrail, int32_t place) {
  record_begin(recorded_rollcon_wheelrail_restore);
  record_handle(wheelrail);
  record_integer(place);
  return record_end();
}

rollcon_status rollcon_wheelrail_copy(const rollcon_wheelrail *wheelrail,
    rollcon_wheelrail **copy) {
  record_begin(recorded_rollcon_wheelrail_copy);
  record_handle(wheelrail);
  record_room(copy);
  if (copy) *copy = (rollcon_wheelrail*)give_handle(4);
  return record_end();
}

rollcon_status rollcon_wheelrail_reset(rollcon_wheelrail *wheelrail) {
  record_begin(recorded_rollcon_wheelrail_reset);
  record_handle(wheelrail);
  return record_end();
}

rollcon_status rollcon_wheelrail_get_patch_count(const rollcon_wheelrail *wheelrail,
    int64_t *patches) {
  record_begin(recorded_rollcon_wheelrail_get_patch_count);
  record_handle(wheelrail);
  record_room(patches);
  give_integer64(patches, 1);
  return record_end();
}

rollcon_status rollcon_wheelrail_get_resultant(const rollcon_wheelrail *wheelrail, int32_t axes,
    double *force, double *moment) {
  record_begin(recorded_rollcon_wheelrail_get_resultant);
  record_handle(wheelrail);
  record_integer(axes);
  record_room(force);
  record_room(moment);
  give_reals(force, 3, 2);
  give_reals(moment, 3, 3);
  return record_end();
}

rollcon_status rollcon_wheelrail_get_derivative(rollcon_wheelrail *wheelrail, int32_t entry,
    double *force, double *moment, double *z) {
  record_begin(recorded_rollcon_wheelrail_get_derivative);
  record_handle(wheelrail);
  record_integer(entry);
  record_room(force);
  record_room(moment);
  record_room(z);
  give_reals(force, 3, 2);
  give_reals(moment, 3, 3);
  give_reals(z, 1, 4);
  return record_end();
}

rollcon_status rollcon_wheelrail_get_stat(const rollcon_wheelrail *wheelrail, const char *name,
    double *value) {
  record_begin(recorded_rollcon_wheelrail_get_stat);
  record_handle(wheelrail);
  record_text(name);
  record_room(value);
  give_reals(value, 1, 2);
  return record_end();
}

int32_t rollcon_wheelrail_stat_count(void) {
  record_begin(recorded_rollcon_wheelrail_stat_count);
  return RECORD_COUNT;
}

rollcon_status rollcon_wheelrail_stat_name(int32_t i, int64_t capacity, char *text,
    int64_t *needed) {
  record_begin(recorded_rollcon_wheelrail_stat_name);
  record_integer(i);
  record_integer(capacity);
  record_room(text);
  record_room(needed);
  give_text(text, capacity, needed, recorded_rollcon_wheelrail_stat_name);
  return record_end();
}

rollcon_status rollcon_wheelrail_get_profile_point(const rollcon_wheelrail *wheelrail,
    int32_t body, double share, double *point) {
  record_begin(recorded_rollcon_wheelrail_get_profile_point);
  record_handle(wheelrail);
  record_integer(body);
  record_real(share);
  record_room(point);
  give_reals(point, 2, 3);
  return record_end();
}

rollcon_status rollcon_wheelrail_get_patch_stat(const rollcon_wheelrail *wheelrail,
    int32_t patch, const char *name, double *value) {
  record_begin(recorded_rollcon_wheelrail_get_patch_stat);
  record_handle(wheelrail);
  record_integer(patch);
  record_text(name);
  record_room(value);
  give_reals(value, 1, 3);
  return record_end();
}

int32_t rollcon_wheelrail_patch_stat_count(void) {
  record_begin(recorded_rollcon_wheelrail_patch_stat_count);
  return RECORD_COUNT;
}

rollcon_status rollcon_wheelrail_patch_stat_name(int32_t i, int64_t capacity, char *text,
    int64_t *needed) {
  record_begin(recorded_rollcon_wheelrail_patch_stat_name);
  record_integer(i);
  record_integer(capacity);
  record_room(text);
  record_room(needed);
  give_text(text, capacity, needed, recorded_rollcon_wheelrail_patch_stat_name);
  return record_end();
}

rollcon_status rollcon_wheelrail_get_patch_axes(const rollcon_wheelrail *wheelrail,
    int32_t patch, double *origin, double *axes) {
  record_begin(recorded_rollcon_wheelrail_get_patch_axes);
  record_handle(wheelrail);
  record_integer(patch);
  record_room(origin);
  record_room(axes);
  give_reals(origin, 3, 2);
  give_reals(axes, 9, 3);
  return record_end();
}

rollcon_status rollcon_wheelrail_get_contact(const rollcon_wheelrail *wheelrail, int32_t patch,
    rollcon_contact **contact) {
  record_begin(recorded_rollcon_wheelrail_get_contact);
  record_handle(wheelrail);
  record_integer(patch);
  record_room(contact);
  if (contact) *contact = (rollcon_contact*)give_handle(3);
  return record_end();
}

rollcon_status rollcon_wheelrail_find_contact_points(rollcon_wheelrail *left,
    rollcon_wheelrail *right, int64_t n, const double *shift, double *points) {
  record_begin(recorded_rollcon_wheelrail_find_contact_points);
  record_handle(left);
  record_handle(right);
  record_integer(n);
  record_reals(shift, n);
  record_room(points);
  give_reals(points, n * 13, 4);
  return record_end();
}

rollcon_status rollcon_wheelrail_find_conicity(rollcon_wheelrail *left, rollcon_wheelrail *right,
    int64_t n, const double *amplitude, double *conicity, double *wavelength) {
  record_begin(recorded_rollcon_wheelrail_find_conicity);
  record_handle(left);
  record_handle(right);
  record_integer(n);
  record_reals(amplitude, n);
  record_room(conicity);
  record_room(wavelength);
  give_reals(conicity, n, 4);
  give_reals(wavelength, n, 5);
  return record_end();
}

int32_t rollcon_id_of(const void *handle) {
  record_begin(recorded_rollcon_id_of);
  record_handle(handle);
  return (int32_t)(intptr_t)handle;
}

rollcon_context *rollcon_context_from_id(int32_t id) {
  record_begin(recorded_rollcon_context_from_id);
  record_integer(id);
  return (rollcon_context*)(intptr_t)id;
}

rollcon_body *rollcon_body_from_id(int32_t id) {
  record_begin(recorded_rollcon_body_from_id);
  record_integer(id);
  return (rollcon_body*)(intptr_t)id;
}

rollcon_contact *rollcon_contact_from_id(int32_t id) {
  record_begin(recorded_rollcon_contact_from_id);
  record_integer(id);
  return (rollcon_contact*)(intptr_t)id;
}

rollcon_wheelrail *rollcon_wheelrail_from_id(int32_t id) {
  record_begin(recorded_rollcon_wheelrail_from_id);
  record_integer(id);
  return (rollcon_wheelrail*)(intptr_t)id;
}

rollcon_table *rollcon_table_from_id(int32_t id) {
  record_begin(recorded_rollcon_table_from_id);
  record_integer(id);
  return (rollcon_table*)(intptr_t)id;
}

rollcon_status rollcon_table_create(rollcon_context *context, rollcon_table **table) {
  record_begin(recorded_rollcon_table_create);
  record_handle(context);
  record_room(table);
  if (table) *table = (rollcon_table*)give_handle(5);
  return record_end();
}

rollcon_status rollcon_table_retain(rollcon_table *table) {
  record_begin(recorded_rollcon_table_retain);
  record_handle(table);
  return record_end();
}

void rollcon_table_release(rollcon_table *table) {
  record_begin(recorded_rollcon_table_release);
  record_handle(table);
}

rollcon_status rollcon_table_load(rollcon_context *context, const char *path,
    rollcon_table **table) {
  record_begin(recorded_rollcon_table_load);
  record_handle(context);
  record_text(path);
  record_room(table);
  if (table) *table = (rollcon_table*)give_handle(5);
  return record_end();
}

rollcon_status rollcon_table_standard(rollcon_context *context, rollcon_table **table) {
  record_begin(recorded_rollcon_table_standard);
  record_handle(context);
  record_room(table);
  if (table) *table = (rollcon_table*)give_handle(5);
  return record_end();
}

rollcon_status rollcon_table_set_ratios(rollcon_table *table, int32_t intervals, double least,
    double greatest) {
  record_begin(recorded_rollcon_table_set_ratios);
  record_handle(table);
  record_integer(intervals);
  record_real(least);
  record_real(greatest);
  return record_end();
}

rollcon_status rollcon_table_set_resolution(rollcon_table *table, int32_t magnitudes,
    int32_t angles, int32_t directions) {
  record_begin(recorded_rollcon_table_set_resolution);
  record_handle(table);
  record_integer(magnitudes);
  record_integer(angles);
  record_integer(directions);
  return record_end();
}

rollcon_status rollcon_table_set_frame(rollcon_table *table, int32_t along, int32_t across) {
  record_begin(recorded_rollcon_table_set_frame);
  record_handle(table);
  record_integer(along);
  record_integer(across);
  return record_end();
}

rollcon_status rollcon_table_set_poissons(rollcon_table *table, int64_t n,
    const double *poissons) {
  record_begin(recorded_rollcon_table_set_poissons);
  record_handle(table);
  record_integer(n);
  record_reals(poissons, n);
  return record_end();
}

rollcon_status rollcon_table_set_bodies(rollcon_table *table, const double *youngs,
    const double *poissons, int64_t n, const double *frictions) {
  record_begin(recorded_rollcon_table_set_bodies);
  record_handle(table);
  record_reals(youngs, 2);
  record_reals(poissons, 2);
  record_integer(n);
  record_reals(frictions, n);
  return record_end();
}

rollcon_status rollcon_table_set_progress(rollcon_table *table, rollcon_progress_fn fn,
    void *user) {
  const int64_t told = fn ? fn((const rollcon_event*)7, user) : 0;
  record_begin(recorded_rollcon_table_set_progress);
  record_handle(table);
  if (fn) record_integer(told); else record_room(0);
  return record_end();
}

rollcon_status rollcon_table_request_cancel(rollcon_table *table) {
  record_begin(recorded_rollcon_table_request_cancel);
  record_handle(table);
  return record_end();
}

rollcon_status rollcon_table_make(rollcon_table *table, int32_t part, int32_t parts) {
  record_begin(recorded_rollcon_table_make);
  record_handle(table);
  record_integer(part);
  record_integer(parts);
  return record_end();
}

rollcon_status rollcon_table_get_samples(const rollcon_table *table, int64_t capacity,
    double *samples, int64_t *count) {
  record_begin(recorded_rollcon_table_get_samples);
  record_handle(table);
  record_integer(capacity);
  record_room(samples);
  record_room(count);
  give_reals(samples, capacity, 2);
  give_integer64(count, 3);
  return record_end();
}

rollcon_status rollcon_table_add_samples(rollcon_table *table, int64_t n, const double *samples) {
  record_begin(recorded_rollcon_table_add_samples);
  record_handle(table);
  record_integer(n);
  record_reals(samples, n);
  return record_end();
}

rollcon_status rollcon_table_save(rollcon_table *table, const char *path) {
  record_begin(recorded_rollcon_table_save);
  record_handle(table);
  record_text(path);
  return record_end();
}

rollcon_status rollcon_table_evaluate(const rollcon_table *table, int64_t n,
    const double *inputs, double *results) {
  record_begin(recorded_rollcon_table_evaluate);
  record_handle(table);
  record_integer(n);
  record_reals(inputs, n * 9);
  record_room(results);
  give_reals(results, n * 3, 3);
  return record_end();
}

rollcon_status rollcon_table_evaluate_derivatives(const rollcon_table *table, int64_t n,
    const double *inputs, double *results, double *derivatives) {
  record_begin(recorded_rollcon_table_evaluate_derivatives);
  record_handle(table);
  record_integer(n);
  record_reals(inputs, n * 9);
  record_room(results);
  record_room(derivatives);
  give_reals(results, n * 3, 3);
  give_reals(derivatives, n * 3 * 9, 4);
  return record_end();
}

rollcon_status rollcon_table_evaluate_contact(const rollcon_table *table,
    const rollcon_contact *contact, double friction, double *results) {
  record_begin(recorded_rollcon_table_evaluate_contact);
  record_handle(table);
  record_handle(contact);
  record_real(friction);
  record_room(results);
  give_reals(results, 3, 3);
  return record_end();
}
