#pragma once
/// Generated from bindings/api.toml by bindings/generate.py; do not edit.
/// One call of every function with an object: check(name, whether any thread may call it at any
/// time, status). Their other arguments are harmless and no more.

#include <rollcon.h>

#include <cstdint>

namespace capi_test {

// clang-format off
struct HarmlessArguments {
  double reals[64] = {1}, out[64] = {};
  std::int32_t integers[64] = {}, states[64] = {}, kind = 0;
  std::int64_t n = 0;
  char text[64] = "";
  rollcon_body* body = nullptr;
  rollcon_contact* contact = nullptr;
  rollcon_wheelrail* wheelrail = nullptr;
  rollcon_table* table = nullptr;
};

template <class Check>
void with_each_context_call(const void* handle, Check&& check) {
  auto* object = static_cast<rollcon_context*>(const_cast<void*>(handle));
  HarmlessArguments a;
  check("rollcon_context_retain", true,
        rollcon_context_retain(object));
  check("rollcon_context_set_log", false,
        rollcon_context_set_log(object, 1, nullptr, nullptr));
  check("rollcon_context_set_threads", false,
        rollcon_context_set_threads(object, 1));
  check("rollcon_context_set_latch", true,
        rollcon_context_set_latch(object, 1));
  check("rollcon_context_check", true,
        rollcon_context_check(object));
  check("rollcon_body_create", false,
        rollcon_body_create(object, 1, &a.body));
  check("rollcon_body_load", false,
        rollcon_body_load(object, "never_written", &a.body));
  check("rollcon_contact_create", false,
        rollcon_contact_create(object, nullptr, nullptr, &a.contact));
  check("rollcon_wheelrail_create", false,
        rollcon_wheelrail_create(object, nullptr, nullptr, 1, &a.wheelrail));
  check("rollcon_table_create", false,
        rollcon_table_create(object, &a.table));
  check("rollcon_table_load", false,
        rollcon_table_load(object, "never_written", &a.table));
  check("rollcon_table_standard", false,
        rollcon_table_standard(object, &a.table));
}

template <class Check>
void with_each_body_call(const void* handle, Check&& check) {
  auto* object = static_cast<rollcon_body*>(const_cast<void*>(handle));
  HarmlessArguments a;
  check("rollcon_body_retain", true,
        rollcon_body_retain(object));
  check("rollcon_body_set_elastic", false,
        rollcon_body_set_elastic(object, 1, 1, 1));
  check("rollcon_body_prepare", false,
        rollcon_body_prepare(object));
  check("rollcon_body_get_kind", true,
        rollcon_body_get_kind(object, &a.kind));
  check("rollcon_body_save", false,
        rollcon_body_save(object, "never_written"));
  check("rollcon_body_copy", false,
        rollcon_body_copy(object, &a.body));
  check("rollcon_body_set_nodes", false,
        rollcon_body_set_nodes(object, 1, a.reals, 1, 1));
  check("rollcon_body_add_elements", false,
        rollcon_body_add_elements(object, 1, 1, a.integers, 1, 1));
  check("rollcon_body_tag_faces", false,
        rollcon_body_tag_faces(object, 1, a.integers, a.integers, 1, 1));
  check("rollcon_body_tag_faces_of_nodes", false,
        rollcon_body_tag_faces_of_nodes(object, 1, a.integers, 1, 1));
  check("rollcon_body_set_support", false,
        rollcon_body_set_support(object, 1, a.integers, 1, 1, a.reals));
  check("rollcon_body_set_traction", false,
        rollcon_body_set_traction(object, 1, a.reals));
  check("rollcon_body_set_body_force", false,
        rollcon_body_set_body_force(object, 1, a.reals));
  check("rollcon_body_set_rotation", false,
        rollcon_body_set_rotation(object, 1, 1, a.reals, a.reals));
  check("rollcon_body_set_pressure", false,
        rollcon_body_set_pressure(object, 1, 1));
  check("rollcon_body_set_node_tractions", false,
        rollcon_body_set_node_tractions(object, 1, 1, a.integers, 1, a.reals, a.reals));
  check("rollcon_body_set_contact_faces", false,
        rollcon_body_set_contact_faces(object, 1, a.integers));
  check("rollcon_body_read_mesh", false,
        rollcon_body_read_mesh(object, "never_written", "never_written"));
  check("rollcon_body_tag_group", false,
        rollcon_body_tag_group(object, "never_written", 1));
  check("rollcon_body_get_group_count", false,
        rollcon_body_get_group_count(object, &a.kind));
  check("rollcon_body_get_group_name", false,
        rollcon_body_get_group_name(object, 1, 1, a.text, &a.n));
  check("rollcon_body_get_group_nodes", false,
        rollcon_body_get_group_nodes(object, "never_written", 1, 1, a.states, &a.n));
  check("rollcon_body_set_int", false,
        rollcon_body_set_int(object, "never_written", 1));
  check("rollcon_body_set_real", false,
        rollcon_body_set_real(object, "never_written", 1));
  check("rollcon_body_get_int", false,
        rollcon_body_get_int(object, "never_written", &a.n));
  check("rollcon_body_get_real", false,
        rollcon_body_get_real(object, "never_written", a.out));
  check("rollcon_body_set_profile", false,
        rollcon_body_set_profile(object, 1, a.reals, 1));
  check("rollcon_body_set_profile_shape", false,
        rollcon_body_set_profile_shape(object, "never_written", 1, a.reals));
  check("rollcon_body_read_profile", false,
        rollcon_body_read_profile(object, "never_written", 1, 1, 1));
  check("rollcon_body_write_profile", false,
        rollcon_body_write_profile(object, "never_written", 1));
  check("rollcon_body_extrude_profile", false,
        rollcon_body_extrude_profile(object, a.reals, a.reals, a.reals));
  check("rollcon_body_revolve_profile", false,
        rollcon_body_revolve_profile(object, a.reals, a.reals, 1));
  check("rollcon_body_get_profile_length", false,
        rollcon_body_get_profile_length(object, a.out));
  check("rollcon_body_get_profile_point", false,
        rollcon_body_get_profile_point(object, 1, a.out, a.out, a.out));
  check("rollcon_body_get_size", false,
        rollcon_body_get_size(object, &a.n, &a.n));
  check("rollcon_body_get_displacements", false,
        rollcon_body_get_displacements(object, 1, a.out));
  check("rollcon_body_get_node_stresses", false,
        rollcon_body_get_node_stresses(object, 1, a.reals, a.out));
  check("rollcon_body_get_point_stresses", false,
        rollcon_body_get_point_stresses(object, 1, a.reals, 1, a.out, a.out, &a.n));
  check("rollcon_body_get_fields_at", false,
        rollcon_body_get_fields_at(object, 1, a.reals, 1, a.reals, a.out, a.out));
  check("rollcon_body_write", false,
        rollcon_body_write(object, "never_written", 1, a.reals));
  check("rollcon_body_get_reaction", false,
        rollcon_body_get_reaction(object, a.out, a.out));
  check("rollcon_body_get_stat", false,
        rollcon_body_get_stat(object, "never_written", a.out));
}

template <class Check>
void with_each_contact_call(const void* handle, Check&& check) {
  auto* object = static_cast<rollcon_contact*>(const_cast<void*>(handle));
  HarmlessArguments a;
  check("rollcon_contact_retain", true,
        rollcon_contact_retain(object));
  check("rollcon_contact_set_frame_nodes", false,
        rollcon_contact_set_frame_nodes(object, 1, a.reals, 1, 1));
  check("rollcon_contact_add_frame_elements", false,
        rollcon_contact_add_frame_elements(object, 1, 1, a.integers, 1, 1));
  check("rollcon_contact_read_frame", false,
        rollcon_contact_read_frame(object, "never_written", "never_written"));
  check("rollcon_contact_frame_from_body", false,
        rollcon_contact_frame_from_body(object, 1, 1));
  check("rollcon_contact_frame_rectangle", false,
        rollcon_contact_frame_rectangle(object, 1, 1, 1, 1, 1, 1, 1));
  check("rollcon_contact_frame_ellipse", false,
        rollcon_contact_frame_ellipse(object, 1, 1, 1, 1, 1));
  check("rollcon_contact_frame_strips", false,
        rollcon_contact_frame_strips(object, 1, 1, a.reals));
  check("rollcon_contact_frame_automatic", false,
        rollcon_contact_frame_automatic(object));
  check("rollcon_contact_set_pose", false,
        rollcon_contact_set_pose(object, 1, a.reals, a.reals));
  check("rollcon_contact_set_axes", false,
        rollcon_contact_set_axes(object, a.reals, a.reals, a.reals));
  check("rollcon_contact_set_gap", false,
        rollcon_contact_set_gap(object, 1, a.reals));
  check("rollcon_contact_set_gap_quadratic", false,
        rollcon_contact_set_gap_quadratic(object, 1, 1, 1));
  check("rollcon_contact_set_gap_grid", false,
        rollcon_contact_set_gap_grid(object, 1, 1, 1, 1, 1, 1, a.reals));
  check("rollcon_contact_set_rolling", false,
        rollcon_contact_set_rolling(object, 1));
  check("rollcon_contact_set_creep", false,
        rollcon_contact_set_creep(object, 1, 1, 1));
  check("rollcon_contact_set_step", false,
        rollcon_contact_set_step(object, 1, 1));
  check("rollcon_contact_set_velocity", false,
        rollcon_contact_set_velocity(object, 1, a.reals, a.reals, a.reals));
  check("rollcon_contact_set_creep_field", false,
        rollcon_contact_set_creep_field(object, 1, a.reals));
  check("rollcon_contact_prescribe", false,
        rollcon_contact_prescribe(object, 1, 1, 1));
  check("rollcon_contact_set_friction", false,
        rollcon_contact_set_friction(object, "never_written", 1, a.reals));
  check("rollcon_contact_set_friction_memory", false,
        rollcon_contact_set_friction_memory(object, 1, 1));
  check("rollcon_contact_set_layer", false,
        rollcon_contact_set_layer(object, 1));
  check("rollcon_contact_set_layer_yield", false,
        rollcon_contact_set_layer_yield(object, 1, 1));
  check("rollcon_contact_set_friction_across", false,
        rollcon_contact_set_friction_across(object, 1, a.reals));
  check("rollcon_contact_set_heat", false,
        rollcon_contact_set_heat(object, 1, 1, 1, 1));
  check("rollcon_contact_set_friction_field", false,
        rollcon_contact_set_friction_field(object, 1, a.reals));
  check("rollcon_contact_set_int", false,
        rollcon_contact_set_int(object, "never_written", 1));
  check("rollcon_contact_set_real", false,
        rollcon_contact_set_real(object, "never_written", 1));
  check("rollcon_contact_set_str", false,
        rollcon_contact_set_str(object, "never_written", "never_written"));
  check("rollcon_contact_get_int", false,
        rollcon_contact_get_int(object, "never_written", &a.n));
  check("rollcon_contact_get_real", false,
        rollcon_contact_get_real(object, "never_written", a.out));
  check("rollcon_contact_get_str", false,
        rollcon_contact_get_str(object, "never_written", 1, a.text, &a.n));
  check("rollcon_contact_set_progress", false,
        rollcon_contact_set_progress(object, nullptr, nullptr));
  check("rollcon_contact_request_cancel", true,
        rollcon_contact_request_cancel(object));
  check("rollcon_contact_solve", false,
        rollcon_contact_solve(object));
  check("rollcon_contact_solve_many", false,
        rollcon_contact_solve_many(object, "never_written", 1, a.reals, "never_written", 1, a.out, &a.n, a.states));
  check("rollcon_contact_repeat_step", false,
        rollcon_contact_repeat_step(object));
  check("rollcon_contact_save_past", false,
        rollcon_contact_save_past(object, 1, a.out, &a.n));
  check("rollcon_contact_restore_past", false,
        rollcon_contact_restore_past(object, 1, a.reals));
  check("rollcon_contact_reset", false,
        rollcon_contact_reset(object));
  check("rollcon_contact_get_size", false,
        rollcon_contact_get_size(object, &a.n, &a.n));
  check("rollcon_contact_get_tractions", false,
        rollcon_contact_get_tractions(object, 1, 1, a.out));
  check("rollcon_contact_get_field", false,
        rollcon_contact_get_field(object, 1, 1, 1, a.out, &a.n));
  check("rollcon_contact_get_status", false,
        rollcon_contact_get_status(object, 1, a.states));
  check("rollcon_contact_get_resultant", false,
        rollcon_contact_get_resultant(object, 1, a.out, a.out));
  check("rollcon_contact_get_motion", false,
        rollcon_contact_get_motion(object, a.out, a.out));
  check("rollcon_contact_get_tilt", false,
        rollcon_contact_get_tilt(object, a.out));
  check("rollcon_contact_get_sensitivity", false,
        rollcon_contact_get_sensitivity(object, 1, a.out, a.out, a.out, a.out));
  check("rollcon_contact_get_displacements_at", false,
        rollcon_contact_get_displacements_at(object, 1, 1, a.reals, a.out));
  check("rollcon_contact_get_stresses_at", false,
        rollcon_contact_get_stresses_at(object, 1, 1, a.reals, a.out, a.out));
  check("rollcon_contact_get_body_displacements", false,
        rollcon_contact_get_body_displacements(object, 1, 1, a.out, &a.n));
  check("rollcon_contact_get_body_fields_at", false,
        rollcon_contact_get_body_fields_at(object, 1, 1, a.reals, a.out, a.out));
  check("rollcon_contact_write_body", false,
        rollcon_contact_write_body(object, 1, "never_written"));
  check("rollcon_contact_get_temperatures_at", false,
        rollcon_contact_get_temperatures_at(object, 1, a.reals, a.out));
  check("rollcon_contact_get_fatigue_index", false,
        rollcon_contact_get_fatigue_index(object, 1, a.out));
  check("rollcon_contact_get_equivalent_ellipse", false,
        rollcon_contact_get_equivalent_ellipse(object, a.out, a.out));
  check("rollcon_contact_get_wear", false,
        rollcon_contact_get_wear(object, "never_written", 1, a.reals, 1, a.reals, a.out, a.out));
  check("rollcon_contact_get_stat", false,
        rollcon_contact_get_stat(object, "never_written", a.out));
  check("rollcon_contact_get_history", false,
        rollcon_contact_get_history(object, 1, a.out, &a.n));
  check("rollcon_contact_get_error_function", false,
        rollcon_contact_get_error_function(object, 1, a.out, a.out, &a.n));
  check("rollcon_contact_get_plan", false,
        rollcon_contact_get_plan(object, 1, a.text, &a.n));
  check("rollcon_contact_write", false,
        rollcon_contact_write(object, "never_written"));
}

template <class Check>
void with_each_wheelrail_call(const void* handle, Check&& check) {
  auto* object = static_cast<rollcon_wheelrail*>(const_cast<void*>(handle));
  HarmlessArguments a;
  check("rollcon_wheelrail_retain", true,
        rollcon_wheelrail_retain(object));
  check("rollcon_wheelrail_set_track", false,
        rollcon_wheelrail_set_track(object, 1, 1, 1));
  check("rollcon_wheelrail_set_wheelset", false,
        rollcon_wheelrail_set_wheelset(object, 1, 1, 1));
  check("rollcon_wheelrail_set_rail_deviation", false,
        rollcon_wheelrail_set_rail_deviation(object, a.reals, a.reals));
  check("rollcon_wheelrail_set_position", false,
        rollcon_wheelrail_set_position(object, a.reals));
  check("rollcon_wheelrail_set_roll_outside", false,
        rollcon_wheelrail_set_roll_outside(object, 1));
  check("rollcon_wheelrail_set_velocity", false,
        rollcon_wheelrail_set_velocity(object, a.reals));
  check("rollcon_wheelrail_prescribe_vertical", false,
        rollcon_wheelrail_prescribe_vertical(object, 1, 1));
  check("rollcon_wheelrail_set_friction", false,
        rollcon_wheelrail_set_friction(object, 1));
  check("rollcon_wheelrail_set_table", false,
        rollcon_wheelrail_set_table(object, nullptr));
  check("rollcon_wheelrail_forget_table", false,
        rollcon_wheelrail_forget_table(object));
  check("rollcon_wheelrail_set_hertzian", false,
        rollcon_wheelrail_set_hertzian(object, 1));
  check("rollcon_wheelrail_set_conformal", false,
        rollcon_wheelrail_set_conformal(object, 1));
  check("rollcon_wheelrail_set_friction_by_angle", false,
        rollcon_wheelrail_set_friction_by_angle(object, 1, a.reals));
  check("rollcon_wheelrail_set_accuracy", false,
        rollcon_wheelrail_set_accuracy(object, 1));
  check("rollcon_wheelrail_solve", false,
        rollcon_wheelrail_solve(object));
  check("rollcon_wheelrail_request_cancel", true,
        rollcon_wheelrail_request_cancel(object));
  check("rollcon_wheelrail_solve_many", false,
        rollcon_wheelrail_solve_many(object, 1, a.reals, a.reals, a.out, a.states));
  check("rollcon_wheelrail_find_wear", false,
        rollcon_wheelrail_find_wear(object, 1, a.reals, a.reals, a.reals, "never_written", 1, a.reals, 1, a.out, a.out, a.out, a.states));
  check("rollcon_wheelrail_save", false,
        rollcon_wheelrail_save(object, 1));
  check("rollcon_wheelrail_restore", false,
        rollcon_wheelrail_restore(object, 1));
  check("rollcon_wheelrail_copy", false,
        rollcon_wheelrail_copy(object, &a.wheelrail));
  check("rollcon_wheelrail_reset", false,
        rollcon_wheelrail_reset(object));
  check("rollcon_wheelrail_get_patch_count", false,
        rollcon_wheelrail_get_patch_count(object, &a.n));
  check("rollcon_wheelrail_get_resultant", false,
        rollcon_wheelrail_get_resultant(object, 1, a.out, a.out));
  check("rollcon_wheelrail_get_derivative", false,
        rollcon_wheelrail_get_derivative(object, 1, a.out, a.out, a.out));
  check("rollcon_wheelrail_get_stat", false,
        rollcon_wheelrail_get_stat(object, "never_written", a.out));
  check("rollcon_wheelrail_get_profile_point", false,
        rollcon_wheelrail_get_profile_point(object, 1, 1, a.out));
  check("rollcon_wheelrail_get_patch_stat", false,
        rollcon_wheelrail_get_patch_stat(object, 1, "never_written", a.out));
  check("rollcon_wheelrail_get_patch_axes", false,
        rollcon_wheelrail_get_patch_axes(object, 1, a.out, a.out));
  check("rollcon_wheelrail_get_contact", false,
        rollcon_wheelrail_get_contact(object, 1, &a.contact));
  check("rollcon_wheelrail_find_contact_points", false,
        rollcon_wheelrail_find_contact_points(object, nullptr, 1, a.reals, a.out));
  check("rollcon_wheelrail_find_conicity", false,
        rollcon_wheelrail_find_conicity(object, nullptr, 1, a.reals, a.out, a.out));
}

template <class Check>
void with_each_table_call(const void* handle, Check&& check) {
  auto* object = static_cast<rollcon_table*>(const_cast<void*>(handle));
  HarmlessArguments a;
  check("rollcon_table_retain", true,
        rollcon_table_retain(object));
  check("rollcon_table_set_ratios", false,
        rollcon_table_set_ratios(object, 1, 1, 1));
  check("rollcon_table_set_resolution", false,
        rollcon_table_set_resolution(object, 1, 1, 1));
  check("rollcon_table_set_frame", false,
        rollcon_table_set_frame(object, 1, 1));
  check("rollcon_table_set_poissons", false,
        rollcon_table_set_poissons(object, 1, a.reals));
  check("rollcon_table_set_bodies", false,
        rollcon_table_set_bodies(object, a.reals, a.reals, 1, a.reals));
  check("rollcon_table_set_progress", false,
        rollcon_table_set_progress(object, nullptr, nullptr));
  check("rollcon_table_request_cancel", true,
        rollcon_table_request_cancel(object));
  check("rollcon_table_make", false,
        rollcon_table_make(object, 1, 1));
  check("rollcon_table_get_samples", false,
        rollcon_table_get_samples(object, 1, a.out, &a.n));
  check("rollcon_table_add_samples", false,
        rollcon_table_add_samples(object, 1, a.reals));
  check("rollcon_table_save", false,
        rollcon_table_save(object, "never_written"));
  check("rollcon_table_evaluate", true,
        rollcon_table_evaluate(object, 1, a.reals, a.out));
  check("rollcon_table_evaluate_derivatives", true,
        rollcon_table_evaluate_derivatives(object, 1, a.reals, a.out, a.out));
  check("rollcon_table_evaluate_contact", false,
        rollcon_table_evaluate_contact(object, nullptr, 1, a.out));
}

// clang-format on

}  // namespace capi_test
