/// Contacts: making, scene.

#include "contact/contact.hpp"

#include "capi/guard.hpp"
#include "support/input_checks.hpp"

using namespace rollcon;
using namespace rollcon::capi;

namespace {

std::shared_ptr<Body> body_of(const rollcon_body* handle, const char* name) {
  require_pointer(handle, name);
  const std::shared_ptr<Object> object = handles().find(Kind::body, handle);
  if (!object) fail(Status::err_handle, "%s is not a live body", name);
  return object->body;
}

}  // namespace

rollcon_status rollcon_contact_create(rollcon_context* context, rollcon_body* body1,
                                      rollcon_body* body2, rollcon_contact** contact) {
  if (contact) *contact = nullptr;
  return with_object(__func__, Kind::context, context, [&](Object& parent) {
    std::shared_ptr<Body> first = body_of(body1, "body1");
    std::shared_ptr<Body> second = body_of(body2, "body2");
    require_pointer(contact, "contact");
    auto object = std::make_shared<Object>();
    object->context = parent.context;
    object->contact =
        std::make_unique<Contact>(parent.context, std::move(first), std::move(second));
    *contact = static_cast<rollcon_contact*>(
        const_cast<void*>(handles().insert(Kind::contact, std::move(object))));
  });
}

rollcon_status rollcon_contact_retain(rollcon_contact* contact) {
  return retain(Kind::contact, contact);
}

void rollcon_contact_release(rollcon_contact* contact) {
  release(Kind::contact, contact);
}

rollcon_status rollcon_contact_set_frame_nodes(rollcon_contact* contact, int64_t n, const double* x,
                                               int64_t node_stride, int64_t component_stride) {
  return with_contact(__func__, contact, [&](Contact& c) {
    c.scene.set_frame_nodes(n, x, node_stride, component_stride);
  });
}

rollcon_status rollcon_contact_add_frame_elements(rollcon_contact* contact, int32_t type, int64_t n,
                                                  const int32_t* connectivity, int32_t index_base,
                                                  int32_t tag) {
  return with_contact(__func__, contact, [&](Contact& c) {
    c.scene.add_frame_elements(type, n, connectivity, index_base, tag);
  });
}

rollcon_status rollcon_contact_frame_from_body(rollcon_contact* contact, int32_t which,
                                               int32_t tag) {
  return with_contact(__func__, contact, [&](Contact& c) { c.frame_from_body(which, tag); });
}

rollcon_status rollcon_contact_set_pose(rollcon_contact* contact, int32_t which,
                                        const double* rotation, const double* translation) {
  return with_contact(__func__, contact,
                      [&](Contact& c) { c.scene.set_pose(which, rotation, translation); });
}

rollcon_status rollcon_contact_set_axes(rollcon_contact* contact, const double* origin,
                                        const double* rolling, const double* normal) {
  return with_contact(__func__, contact,
                      [&](Contact& c) { c.scene.set_axes(origin, rolling, normal); });
}

rollcon_status rollcon_contact_set_gap(rollcon_contact* contact, int64_t n, const double* gap) {
  return with_contact(__func__, contact, [&](Contact& c) { c.scene.set_gap(n, gap); });
}

rollcon_status rollcon_contact_set_gap_quadratic(rollcon_contact* contact, double a, double b,
                                                 double c) {
  return with_contact(__func__, contact,
                      [&](Contact& object) { object.scene.set_gap_quadratic(a, b, c); });
}

rollcon_status rollcon_contact_set_rolling(rollcon_contact* contact, double speed) {
  return with_contact(__func__, contact, [&](Contact& c) { c.scene.set_speed(speed); });
}

rollcon_status rollcon_contact_set_creep(rollcon_contact* contact, double longitudinal,
                                         double lateral, double spin) {
  return with_contact(__func__, contact,
                      [&](Contact& c) { c.scene.set_creep(longitudinal, lateral, spin); });
}

rollcon_status rollcon_contact_set_creep_field(rollcon_contact* contact, int64_t n,
                                               const double* slip) {
  return with_contact(__func__, contact, [&](Contact& c) { c.scene.set_creep_field(n, slip); });
}

rollcon_status rollcon_contact_prescribe(rollcon_contact* contact, int32_t direction, int32_t how,
                                         double value) {
  return with_contact(__func__, contact,
                      [&](Contact& c) { c.scene.prescribe(direction, how, value); });
}

rollcon_status rollcon_contact_set_friction(rollcon_contact* contact, const char* law, int32_t n,
                                            const double* parameters) {
  return with_contact(__func__, contact,
                      [&](Contact& c) { c.scene.set_friction(law, n, parameters); });
}

rollcon_status rollcon_contact_set_friction_field(rollcon_contact* contact, int64_t n,
                                                  const double* mu) {
  return with_contact(__func__, contact, [&](Contact& c) { c.scene.set_friction_field(n, mu); });
}
