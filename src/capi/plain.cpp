/// Generated from bindings/api.toml by bindings/generate.py; do not edit.
/// The functions that hand their arguments to one method of their object.

#include "bodies/body.hpp"
#include "capi/guard.hpp"
#include "capi/results.hpp"
#include "contact/contact.hpp"
#include "support/input_checks.hpp"
#include "tables/force_table.hpp"
#include "wheelrail/wheel_rail.hpp"

using namespace rollcon;
using namespace rollcon::capi;

// clang-format off

void rollcon_context_release(rollcon_context *context) {
  release(Kind::context, context);
}

rollcon_status rollcon_context_set_threads(rollcon_context *context, int32_t n) {
  return with_object(__func__, Kind::context, context, [&](Object& self) {
    self.context->set_threads(n);
  });
}

rollcon_status rollcon_context_set_communicator(rollcon_context *context, int32_t communicator) {
  return with_object(__func__, Kind::context, context, [&](Object& self) {
    self.context->set_communicator(communicator);
  });
}

void rollcon_body_release(rollcon_body *body) {
  release(Kind::body, body);
}

rollcon_status rollcon_body_set_elastic(rollcon_body *body, int32_t tag, double young,
    double poisson) {
  return with_body(__func__, body, [&](Body& self) {
    self.set_elastic(tag, young, poisson);
  });
}

rollcon_status rollcon_body_set_viscoelastic(rollcon_body *body, int32_t tag, int64_t n,
    const double *ratios, const double *times) {
  return with_body(__func__, body, [&](Body& self) {
    self.set_viscoelastic(tag, n, ratios, times);
  });
}

rollcon_status rollcon_body_set_moduli(rollcon_body *body, int32_t tag, int64_t n,
    const double *frequencies, const double *storage, const double *loss) {
  return with_body(__func__, body, [&](Body& self) {
    self.set_moduli(tag, n, frequencies, storage, loss);
  });
}

rollcon_status rollcon_body_set_nodes(rollcon_body *body, int64_t n, const double *x,
    int64_t node_stride, int64_t component_stride) {
  return with_body(__func__, body, [&](Body& self) {
    self.set_nodes(n, x, node_stride, component_stride);
  });
}

rollcon_status rollcon_body_add_elements(rollcon_body *body, int32_t type, int64_t n,
    const int32_t *connectivity, int32_t index_base, int32_t tag) {
  return with_body(__func__, body, [&](Body& self) {
    self.add_elements(type, n, connectivity, index_base, tag);
  });
}

rollcon_status rollcon_body_tag_faces(rollcon_body *body, int64_t n, const int32_t *elements,
    const int32_t *faces, int32_t index_base, int32_t tag) {
  return with_body(__func__, body, [&](Body& self) {
    self.tag_faces(n, elements, faces, index_base, tag);
  });
}

rollcon_status rollcon_body_tag_faces_of_nodes(rollcon_body *body, int64_t n,
    const int32_t *nodes, int32_t index_base, int32_t tag) {
  return with_body(__func__, body, [&](Body& self) {
    self.tag_faces_of_nodes(n, nodes, index_base, tag);
  });
}

rollcon_status rollcon_body_set_support(rollcon_body *body, int64_t n, const int32_t *nodes,
    int32_t index_base, int32_t dof_mask, const double *values) {
  return with_body(__func__, body, [&](Body& self) {
    self.set_support(n, nodes, index_base, dof_mask, values);
  });
}

rollcon_status rollcon_body_set_traction(rollcon_body *body, int32_t tag, const double *traction) {
  return with_body(__func__, body, [&](Body& self) {
    self.set_traction(tag, traction);
  });
}

rollcon_status rollcon_body_set_body_force(rollcon_body *body, int32_t tag, const double *force) {
  return with_body(__func__, body, [&](Body& self) {
    self.set_body_force(tag, force);
  });
}

rollcon_status rollcon_body_set_rotation(rollcon_body *body, int32_t tag, double density,
    const double *origin, const double *rate) {
  return with_body(__func__, body, [&](Body& self) {
    self.set_rotation(tag, density, origin, rate);
  });
}

rollcon_status rollcon_body_set_pressure(rollcon_body *body, int32_t tag, double pressure) {
  return with_body(__func__, body, [&](Body& self) {
    self.set_pressure(tag, pressure);
  });
}

rollcon_status rollcon_body_set_springs(rollcon_body *body, int32_t tag, const double *stiffness) {
  return with_body(__func__, body, [&](Body& self) {
    self.set_springs(tag, stiffness);
  });
}

rollcon_status rollcon_body_set_node_tractions(rollcon_body *body, int32_t tag, int64_t n,
    const int32_t *nodes, int32_t index_base, const double *along, const double *tractions) {
  return with_body(__func__, body, [&](Body& self) {
    self.set_node_tractions(tag, n, nodes, index_base, along, tractions);
  });
}

rollcon_status rollcon_body_set_contact_faces(rollcon_body *body, int64_t n, const int32_t *tags) {
  return with_body(__func__, body, [&](Body& self) {
    self.set_contact_faces(n, tags);
  });
}

rollcon_status rollcon_body_revolve(rollcon_body *body, const double *origin, const double *axis) {
  return with_body(__func__, body, [&](Body& self) {
    self.revolve(origin, axis);
  });
}

rollcon_status rollcon_body_extrude(rollcon_body *body, const double *origin,
    const double *direction, double period) {
  return with_body(__func__, body, [&](Body& self) {
    self.extrude(origin, direction, period);
  });
}

rollcon_status rollcon_body_set_condensed(rollcon_body *body, int32_t form, int64_t n,
    const double *matrix) {
  return with_body(__func__, body, [&](Body& self) {
    self.set_condensed(form, n, matrix);
  });
}

rollcon_status rollcon_body_read_condensed(rollcon_body *body, int32_t form, const char *path) {
  return with_body(__func__, body, [&](Body& self) {
    self.read_condensed(form, path);
  });
}

rollcon_status rollcon_body_write_condensed(const rollcon_body *body, int32_t form,
    const char *path) {
  return with_body(__func__, body, [&](Body& self) {
    self.write_condensed(form, path);
  });
}

rollcon_status rollcon_body_read_mesh(rollcon_body *body, const char *path, const char *part) {
  return with_body(__func__, body, [&](Body& self) {
    self.read_mesh(path, part);
  });
}

rollcon_status rollcon_body_tag_group(rollcon_body *body, const char *group, int32_t tag) {
  return with_body(__func__, body, [&](Body& self) {
    self.tag_group(group, tag);
  });
}

rollcon_status rollcon_body_get_group_count(const rollcon_body *body, int32_t *n) {
  return with_body(__func__, body, [&](Body& self) {
    require_pointer(n, "n");
    *n = self.group_count();
  });
}

rollcon_status rollcon_body_get_group_name(const rollcon_body *body, int32_t i, int64_t capacity,
    char *text, int64_t *needed) {
  return with_body(__func__, body, [&](Body& self) {
    copy_text(self.group_name(i), capacity, text, needed);
  });
}

rollcon_status rollcon_body_set_int(rollcon_body *body, const char *name, int64_t value) {
  return with_body(__func__, body, [&](Body& self) {
    self.set_int(name, value);
  });
}

rollcon_status rollcon_body_set_real(rollcon_body *body, const char *name, double value) {
  return with_body(__func__, body, [&](Body& self) {
    self.set_real(name, value);
  });
}

rollcon_status rollcon_body_get_int(const rollcon_body *body, const char *name, int64_t *value) {
  return with_body(__func__, body, [&](Body& self) {
    require_pointer(value, "value");
    *value = self.get_int(name);
  });
}

rollcon_status rollcon_body_get_real(const rollcon_body *body, const char *name, double *value) {
  return with_body(__func__, body, [&](Body& self) {
    require_pointer(value, "value");
    *value = self.get_real(name);
  });
}

rollcon_status rollcon_body_set_profile(rollcon_body *body, int64_t n, const double *points,
    double filter_length) {
  return with_body(__func__, body, [&](Body& self) {
    self.set_profile(n, points, filter_length);
  });
}

rollcon_status rollcon_body_set_profile_shape(rollcon_body *body, const char *shape, int64_t n,
    const double *parameters) {
  return with_body(__func__, body, [&](Body& self) {
    self.set_profile_shape(shape, n, parameters);
  });
}

rollcon_status rollcon_body_read_profile(rollcon_body *body, const char *path, double unit,
    int32_t mirror, double filter_length) {
  return with_body(__func__, body, [&](Body& self) {
    self.read_profile(path, unit, mirror, filter_length);
  });
}

rollcon_status rollcon_body_add_slice(rollcon_body *body, double u, int64_t n,
    const double *features) {
  return with_body(__func__, body, [&](Body& self) {
    self.add_slice(u, n, features);
  });
}

rollcon_status rollcon_body_read_slices(rollcon_body *body, const char *path, double mm,
    double unit, int32_t mirror, double filter_length) {
  return with_body(__func__, body, [&](Body& self) {
    self.read_slices(path, mm, unit, mirror, filter_length);
  });
}

rollcon_status rollcon_body_add_wave(rollcon_body *body, double amplitude, double wavelength,
    double phase) {
  return with_body(__func__, body, [&](Body& self) {
    self.add_wave(amplitude, wavelength, phase);
  });
}

rollcon_status rollcon_body_write_profile(const rollcon_body *body, const char *path,
    double unit) {
  return with_body(__func__, body, [&](Body& self) {
    self.write_profile(path, unit);
  });
}

rollcon_status rollcon_body_extrude_profile(rollcon_body *body, const double *origin,
    const double *along, const double *z_axis) {
  return with_body(__func__, body, [&](Body& self) {
    self.extrude_profile(origin, along, z_axis);
  });
}

rollcon_status rollcon_body_revolve_profile(rollcon_body *body, const double *origin,
    const double *axis, double radius) {
  return with_body(__func__, body, [&](Body& self) {
    self.revolve_profile(origin, axis, radius);
  });
}

rollcon_status rollcon_body_get_profile_length(const rollcon_body *body, double *length) {
  return with_body(__func__, body, [&](Body& self) {
    require_pointer(length, "length");
    *length = self.profile_length();
  });
}

void rollcon_contact_release(rollcon_contact *contact) {
  release(Kind::contact, contact);
}

rollcon_status rollcon_contact_frame_nodes(rollcon_contact *contact, int64_t n, const double *x,
    int64_t node_stride, int64_t component_stride) {
  return with_contact(__func__, contact, [&](Contact& self) {
    self.scene.set_frame_nodes(n, x, node_stride, component_stride);
  });
}

rollcon_status rollcon_contact_frame_add_elements(rollcon_contact *contact, int32_t type,
    int64_t n, const int32_t *connectivity, int32_t index_base, int32_t tag) {
  return with_contact(__func__, contact, [&](Contact& self) {
    self.scene.add_frame_elements(type, n, connectivity, index_base, tag);
  });
}

rollcon_status rollcon_contact_frame_from_body(rollcon_contact *contact, int32_t which,
    int32_t tag) {
  return with_contact(__func__, contact, [&](Contact& self) {
    self.frame_from_body(which, tag);
  });
}

rollcon_status rollcon_contact_frame_automatic(rollcon_contact *contact) {
  return with_contact(__func__, contact, [&](Contact& self) {
    self.scene.forget_frame();
  });
}

rollcon_status rollcon_contact_set_pose(rollcon_contact *contact, int32_t which,
    const double *rotation, const double *translation) {
  return with_contact(__func__, contact, [&](Contact& self) {
    self.scene.set_pose(which, rotation, translation);
  });
}

rollcon_status rollcon_contact_set_axes(rollcon_contact *contact, const double *origin,
    const double *rolling, const double *normal) {
  return with_contact(__func__, contact, [&](Contact& self) {
    self.scene.set_axes(origin, rolling, normal);
  });
}

rollcon_status rollcon_contact_set_gap(rollcon_contact *contact, int64_t n, const double *gap) {
  return with_contact(__func__, contact, [&](Contact& self) {
    self.scene.set_gap(n, gap);
  });
}

rollcon_status rollcon_contact_set_gap_quadratic(rollcon_contact *contact, double a, double b,
    double c) {
  return with_contact(__func__, contact, [&](Contact& self) {
    self.scene.set_gap_quadratic(a, b, c);
  });
}

rollcon_status rollcon_contact_set_rolling(rollcon_contact *contact, double speed) {
  return with_contact(__func__, contact, [&](Contact& self) {
    self.scene.set_speed(speed);
  });
}

rollcon_status rollcon_contact_set_creep(rollcon_contact *contact, double longitudinal,
    double lateral, double spin) {
  return with_contact(__func__, contact, [&](Contact& self) {
    self.scene.set_creep(longitudinal, lateral, spin);
  });
}

rollcon_status rollcon_contact_set_step(rollcon_contact *contact, int32_t kind, double dt) {
  return with_contact(__func__, contact, [&](Contact& self) {
    self.scene.set_step(kind, dt);
  });
}

rollcon_status rollcon_contact_set_velocity(rollcon_contact *contact, int32_t which,
    const double *velocity, const double *angular_velocity, const double *point) {
  return with_contact(__func__, contact, [&](Contact& self) {
    self.scene.set_velocity(which, velocity, angular_velocity, point);
  });
}

rollcon_status rollcon_contact_set_creep_field(rollcon_contact *contact, int64_t n,
    const double *slip) {
  return with_contact(__func__, contact, [&](Contact& self) {
    self.scene.set_creep_field(n, slip);
  });
}

rollcon_status rollcon_contact_prescribe(rollcon_contact *contact, int32_t direction,
    int32_t how, double value) {
  return with_contact(__func__, contact, [&](Contact& self) {
    self.scene.prescribe(direction, how, value);
  });
}

rollcon_status rollcon_contact_set_friction(rollcon_contact *contact, const char *law, int32_t n,
    const double *parameters) {
  return with_contact(__func__, contact, [&](Contact& self) {
    self.scene.set_friction(law, n, parameters);
  });
}

rollcon_status rollcon_contact_set_friction_memory(rollcon_contact *contact, double length,
    double least_speed) {
  return with_contact(__func__, contact, [&](Contact& self) {
    self.scene.set_friction_memory(length, least_speed);
  });
}

rollcon_status rollcon_contact_set_layer(rollcon_contact *contact, double flexibility,
    double stress, double hardening) {
  return with_contact(__func__, contact, [&](Contact& self) {
    self.scene.set_layer(flexibility, stress, hardening);
  });
}

rollcon_status rollcon_contact_set_friction_across(rollcon_contact *contact, int64_t n,
    const double *points) {
  return with_contact(__func__, contact, [&](Contact& self) {
    self.scene.set_friction_across(n, points);
  });
}

rollcon_status rollcon_contact_set_heat(rollcon_contact *contact, int32_t which,
    double conductivity, double heat_capacity, double temperature) {
  return with_contact(__func__, contact, [&](Contact& self) {
    self.scene.set_heat(which, conductivity, heat_capacity, temperature);
  });
}

rollcon_status rollcon_contact_set_friction_field(rollcon_contact *contact, int64_t n,
    const double *mu) {
  return with_contact(__func__, contact, [&](Contact& self) {
    self.scene.set_friction_field(n, mu);
  });
}

rollcon_status rollcon_contact_set_int(rollcon_contact *contact, const char *name, int64_t value) {
  return with_contact(__func__, contact, [&](Contact& self) {
    self.scene.options.set_int(name, value);
  });
}

rollcon_status rollcon_contact_set_real(rollcon_contact *contact, const char *name, double value) {
  return with_contact(__func__, contact, [&](Contact& self) {
    self.scene.options.set_real(name, value);
  });
}

rollcon_status rollcon_contact_set_str(rollcon_contact *contact, const char *name,
    const char *value) {
  return with_contact(__func__, contact, [&](Contact& self) {
    self.scene.options.set_text(name, value);
  });
}

rollcon_status rollcon_contact_get_int(const rollcon_contact *contact, const char *name,
    int64_t *value) {
  return with_contact(__func__, contact, [&](Contact& self) {
    require_pointer(value, "value");
    *value = self.scene.options.get_int(name);
  });
}

rollcon_status rollcon_contact_get_real(const rollcon_contact *contact, const char *name,
    double *value) {
  return with_contact(__func__, contact, [&](Contact& self) {
    require_pointer(value, "value");
    *value = self.scene.options.get_real(name);
  });
}

rollcon_status rollcon_contact_get_str(const rollcon_contact *contact, const char *name,
    int64_t capacity, char *text, int64_t *needed) {
  return with_contact(__func__, contact, [&](Contact& self) {
    copy_text(self.scene.options.get_text(name), capacity, text, needed);
  });
}

rollcon_status rollcon_contact_set_procedure(rollcon_contact *contact, const char *procedure) {
  return with_contact(__func__, contact, [&](Contact& self) {
    self.scene.options.set_procedure(procedure);
  });
}

rollcon_status rollcon_contact_request_cancel(rollcon_contact *contact) {
  return with_shared(__func__, Kind::contact, contact, [&](Object& self) {
    self.contact->request_cancel();
  });
}

rollcon_status rollcon_contact_solve(rollcon_contact *contact) {
  return with_contact(__func__, contact, [&](Contact& self) {
    return self.solve();
  });
}

rollcon_status rollcon_contact_repeat_step(rollcon_contact *contact) {
  return with_contact(__func__, contact, [&](Contact& self) {
    self.repeat_step();
  });
}

rollcon_status rollcon_contact_past_set(rollcon_contact *contact, int64_t n, const double *past) {
  return with_contact(__func__, contact, [&](Contact& self) {
    self.past_set(n, past);
  });
}

rollcon_status rollcon_contact_reset(rollcon_contact *contact) {
  return with_contact(__func__, contact, [&](Contact& self) {
    self.reset();
  });
}

rollcon_status rollcon_contact_write_loads(const rollcon_contact *contact, int32_t which,
    const char *path) {
  return with_contact(__func__, contact, [&](Contact& self) {
    self.write_loads(which, path);
  });
}

rollcon_status rollcon_contact_get_stat(const rollcon_contact *contact, const char *name,
    double *value) {
  return with_contact(__func__, contact, [&](Contact& self) {
    require_pointer(value, "value");
    *value = self.stat(name);
  });
}

rollcon_status rollcon_contact_get_plan(const rollcon_contact *contact, int64_t capacity,
    char *text, int64_t *needed) {
  return with_contact(__func__, contact, [&](Contact& self) {
    copy_text(self.plan(), capacity, text, needed);
  });
}

void rollcon_wheelrail_release(rollcon_wheelrail *wheelrail) {
  release(Kind::wheelrail, wheelrail);
}

rollcon_status rollcon_wheelrail_set_track(rollcon_wheelrail *wheelrail, double gauge,
    double gauge_height, double cant) {
  return with_wheelrail(__func__, wheelrail, [&](WheelRail& self) {
    self.set_track(gauge, gauge_height, cant);
  });
}

rollcon_status rollcon_wheelrail_set_wheelset(rollcon_wheelrail *wheelrail, double back_to_back,
    double flange_back, double radius) {
  return with_wheelrail(__func__, wheelrail, [&](WheelRail& self) {
    self.set_wheelset(back_to_back, flange_back, radius);
  });
}

rollcon_status rollcon_wheelrail_place_rail(rollcon_wheelrail *wheelrail, double y, double z,
    double cant) {
  return with_wheelrail(__func__, wheelrail, [&](WheelRail& self) {
    self.place_by_origin(y, z, cant);
  });
}

rollcon_status rollcon_wheelrail_set_roller(rollcon_wheelrail *wheelrail, double radius,
    double rate) {
  return with_wheelrail(__func__, wheelrail, [&](WheelRail& self) {
    self.set_roller(radius, rate);
  });
}

rollcon_status rollcon_wheelrail_set_step(rollcon_wheelrail *wheelrail, int32_t kind, double dt) {
  return with_wheelrail(__func__, wheelrail, [&](WheelRail& self) {
    self.set_step(kind, dt);
  });
}

rollcon_status rollcon_wheelrail_repeat_step(rollcon_wheelrail *wheelrail) {
  return with_wheelrail(__func__, wheelrail, [&](WheelRail& self) {
    self.repeat_step();
  });
}

rollcon_status rollcon_wheelrail_past_set(rollcon_wheelrail *wheelrail, int64_t n,
    const double *past) {
  return with_wheelrail(__func__, wheelrail, [&](WheelRail& self) {
    self.past_set(n, past);
  });
}

rollcon_status rollcon_wheelrail_set_tape_circle(rollcon_wheelrail *wheelrail, double y) {
  return with_wheelrail(__func__, wheelrail, [&](WheelRail& self) {
    self.set_tape_circle(y);
  });
}

rollcon_status rollcon_wheelrail_set_flexibility(rollcon_wheelrail *wheelrail,
    const double *displacement, const double *rate) {
  return with_wheelrail(__func__, wheelrail, [&](WheelRail& self) {
    self.set_flexibility(displacement, rate);
  });
}

rollcon_status rollcon_wheelrail_set_rail_springs(rollcon_wheelrail *wheelrail,
    const double *stiffness, const double *force) {
  return with_wheelrail(__func__, wheelrail, [&](WheelRail& self) {
    self.set_rail_springs(stiffness, force);
  });
}

rollcon_status rollcon_wheelrail_set_rail_deviation(rollcon_wheelrail *wheelrail,
    const double *deviation, const double *rate) {
  return with_wheelrail(__func__, wheelrail, [&](WheelRail& self) {
    self.set_rail_deviation(deviation, rate);
  });
}

rollcon_status rollcon_wheelrail_set_position(rollcon_wheelrail *wheelrail,
    const double *position) {
  return with_wheelrail(__func__, wheelrail, [&](WheelRail& self) {
    self.set_position(position);
  });
}

rollcon_status rollcon_wheelrail_set_velocity(rollcon_wheelrail *wheelrail,
    const double *velocity) {
  return with_wheelrail(__func__, wheelrail, [&](WheelRail& self) {
    self.set_velocity(velocity);
  });
}

rollcon_status rollcon_wheelrail_prescribe_vertical(rollcon_wheelrail *wheelrail, int32_t how,
    double force) {
  return with_wheelrail(__func__, wheelrail, [&](WheelRail& self) {
    self.prescribe_vertical(how, force);
  });
}

rollcon_status rollcon_wheelrail_prescribe_longitudinal(rollcon_wheelrail *wheelrail,
    int32_t how, double force) {
  return with_wheelrail(__func__, wheelrail, [&](WheelRail& self) {
    self.prescribe_longitudinal(how, force);
  });
}

rollcon_status rollcon_wheelrail_set_friction(rollcon_wheelrail *wheelrail, const char *law,
    int32_t n, const double *parameters) {
  return with_wheelrail(__func__, wheelrail, [&](WheelRail& self) {
    self.set_friction(law, n, parameters);
  });
}

rollcon_status rollcon_wheelrail_set_law_by_angle(rollcon_wheelrail *wheelrail, const char *law,
    int32_t points, int32_t n, const double *parameters) {
  return with_wheelrail(__func__, wheelrail, [&](WheelRail& self) {
    self.set_law_by_angle(law, points, n, parameters);
  });
}

rollcon_status rollcon_wheelrail_set_friction_memory(rollcon_wheelrail *wheelrail, double length,
    double least_speed) {
  return with_wheelrail(__func__, wheelrail, [&](WheelRail& self) {
    self.set_friction_memory(length, least_speed);
  });
}

rollcon_status rollcon_wheelrail_set_layer(rollcon_wheelrail *wheelrail, double flexibility,
    double stress, double hardening) {
  return with_wheelrail(__func__, wheelrail, [&](WheelRail& self) {
    self.set_layer(flexibility, stress, hardening);
  });
}

rollcon_status rollcon_wheelrail_set_heat(rollcon_wheelrail *wheelrail, int32_t which,
    double conductivity, double heat_capacity, double temperature) {
  return with_wheelrail(__func__, wheelrail, [&](WheelRail& self) {
    self.set_heat(which, conductivity, heat_capacity, temperature);
  });
}

rollcon_status rollcon_wheelrail_solve(rollcon_wheelrail *wheelrail) {
  return with_wheelrail(__func__, wheelrail, [&](WheelRail& self) {
    return self.solve();
  });
}

rollcon_status rollcon_wheelrail_request_cancel(rollcon_wheelrail *wheelrail) {
  return with_shared(__func__, Kind::wheelrail, wheelrail, [&](Object& self) {
    self.wheelrail->request_cancel();
  });
}

rollcon_status rollcon_wheelrail_snapshot(rollcon_wheelrail *wheelrail, int32_t place) {
  return with_wheelrail(__func__, wheelrail, [&](WheelRail& self) {
    self.snapshot(place);
  });
}

rollcon_status rollcon_wheelrail_rollback(rollcon_wheelrail *wheelrail, int32_t place) {
  return with_wheelrail(__func__, wheelrail, [&](WheelRail& self) {
    self.rollback(place);
  });
}

rollcon_status rollcon_wheelrail_reset(rollcon_wheelrail *wheelrail) {
  return with_wheelrail(__func__, wheelrail, [&](WheelRail& self) {
    self.reset();
  });
}

rollcon_status rollcon_wheelrail_set_int(rollcon_wheelrail *wheelrail, const char *name,
    int64_t value) {
  return with_wheelrail(__func__, wheelrail, [&](WheelRail& self) {
    self.set_int(name, value);
  });
}

rollcon_status rollcon_wheelrail_set_real(rollcon_wheelrail *wheelrail, const char *name,
    double value) {
  return with_wheelrail(__func__, wheelrail, [&](WheelRail& self) {
    self.set_real(name, value);
  });
}

rollcon_status rollcon_wheelrail_get_int(const rollcon_wheelrail *wheelrail, const char *name,
    int64_t *value) {
  return with_wheelrail(__func__, wheelrail, [&](WheelRail& self) {
    require_pointer(value, "value");
    *value = self.get_int(name);
  });
}

rollcon_status rollcon_wheelrail_get_real(const rollcon_wheelrail *wheelrail, const char *name,
    double *value) {
  return with_wheelrail(__func__, wheelrail, [&](WheelRail& self) {
    require_pointer(value, "value");
    *value = self.get_real(name);
  });
}

rollcon_status rollcon_wheelrail_get_patch_count(const rollcon_wheelrail *wheelrail,
    int64_t *patches) {
  return with_wheelrail(__func__, wheelrail, [&](WheelRail& self) {
    require_pointer(patches, "patches");
    *patches = self.patches();
  });
}

rollcon_status rollcon_wheelrail_get_stat(const rollcon_wheelrail *wheelrail, const char *name,
    double *value) {
  return with_wheelrail(__func__, wheelrail, [&](WheelRail& self) {
    require_pointer(value, "value");
    *value = self.stat(name);
  });
}

rollcon_status rollcon_wheelrail_get_patch_stat(const rollcon_wheelrail *wheelrail,
    int32_t patch, const char *name, double *value) {
  return with_wheelrail(__func__, wheelrail, [&](WheelRail& self) {
    require_pointer(value, "value");
    *value = self.patch_stat(patch, name);
  });
}

rollcon_status rollcon_context_retain(rollcon_context *context) {
  return retain(__func__, Kind::context, context);
}

rollcon_status rollcon_body_retain(rollcon_body *body) {
  return retain(__func__, Kind::body, body);
}

rollcon_status rollcon_contact_retain(rollcon_contact *contact) {
  return retain(__func__, Kind::contact, contact);
}

rollcon_status rollcon_wheelrail_retain(rollcon_wheelrail *wheelrail) {
  return retain(__func__, Kind::wheelrail, wheelrail);
}

rollcon_status rollcon_table_retain(rollcon_table *table) {
  return retain(__func__, Kind::table, table);
}

rollcon_context *rollcon_context_from_id(int32_t id) {
  return static_cast<rollcon_context*>(const_cast<void*>(HandleTable::from_id(id)));
}

rollcon_body *rollcon_body_from_id(int32_t id) {
  return static_cast<rollcon_body*>(const_cast<void*>(HandleTable::from_id(id)));
}

rollcon_contact *rollcon_contact_from_id(int32_t id) {
  return static_cast<rollcon_contact*>(const_cast<void*>(HandleTable::from_id(id)));
}

rollcon_wheelrail *rollcon_wheelrail_from_id(int32_t id) {
  return static_cast<rollcon_wheelrail*>(const_cast<void*>(HandleTable::from_id(id)));
}

rollcon_table *rollcon_table_from_id(int32_t id) {
  return static_cast<rollcon_table*>(const_cast<void*>(HandleTable::from_id(id)));
}

void rollcon_table_release(rollcon_table *table) {
  release(Kind::table, table);
}

rollcon_status rollcon_table_set_ratios(rollcon_table *table, int32_t intervals, double least,
    double greatest) {
  return with_table(__func__, table, [&](ForceTable& self) {
    self.set_ratios(intervals, least, greatest);
  });
}

rollcon_status rollcon_table_set_resolution(rollcon_table *table, int32_t magnitudes,
    int32_t angles, int32_t directions) {
  return with_table(__func__, table, [&](ForceTable& self) {
    self.set_resolution(magnitudes, angles, directions);
  });
}

rollcon_status rollcon_table_set_frame(rollcon_table *table, int32_t along, int32_t across) {
  return with_table(__func__, table, [&](ForceTable& self) {
    self.set_frame(along, across);
  });
}

rollcon_status rollcon_table_set_poissons(rollcon_table *table, int64_t n,
    const double *poissons) {
  return with_table(__func__, table, [&](ForceTable& self) {
    self.set_poissons(n, poissons);
  });
}

rollcon_status rollcon_table_set_bodies(rollcon_table *table, const double *youngs,
    const double *poissons, int64_t n, const double *frictions) {
  return with_table(__func__, table, [&](ForceTable& self) {
    self.set_bodies(youngs, poissons, n, frictions);
  });
}

rollcon_status rollcon_table_request_cancel(rollcon_table *table) {
  return with_shared(__func__, Kind::table, table, [&](Object& self) {
    self.table->request_cancel();
  });
}

rollcon_status rollcon_table_add_samples(rollcon_table *table, int64_t n, const double *samples) {
  return with_table(__func__, table, [&](ForceTable& self) {
    self.add_samples(n, samples);
  });
}

rollcon_status rollcon_table_save(rollcon_table *table, const char *path) {
  return with_table(__func__, table, [&](ForceTable& self) {
    self.save(path);
  });
}

// clang-format on
