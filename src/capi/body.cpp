/// Bodies.

#include "bodies/body.hpp"

#include "capi/guard.hpp"
#include "support/input_checks.hpp"

using namespace rollcon;
using namespace rollcon::capi;

rollcon_status rollcon_body_create(rollcon_context* context, int32_t kind, rollcon_body** body) {
  if (body) *body = nullptr;
  return with_object(__func__, Kind::context, context, [&](Object& parent) {
    require_pointer(body, "body");
    auto object = std::make_shared<Object>();
    object->context = parent.context;
    object->body = std::make_shared<Body>(parent.context, kind);
    *body = static_cast<rollcon_body*>(
        const_cast<void*>(handles().insert(Kind::body, std::move(object))));
  });
}

rollcon_status rollcon_body_retain(rollcon_body* body) {
  return retain(Kind::body, body);
}

void rollcon_body_release(rollcon_body* body) {
  release(Kind::body, body);
}

rollcon_status rollcon_body_set_elastic(rollcon_body* body, int32_t tag, double young,
                                        double poisson) {
  return with_object(__func__, Kind::body, body,
                     [&](Object& object) { object.body->set_elastic(tag, young, poisson); });
}

rollcon_status rollcon_body_prepare(rollcon_body* body) {
  return with_object(__func__, Kind::body, body, [](Object& object) { object.body->prepare(); });
}

rollcon_status rollcon_body_get_kind(const rollcon_body* body, int32_t* kind) {
  return with_shared(__func__, Kind::body, body, [&](Object& object) {
    require_pointer(kind, "kind");
    *kind = static_cast<int32_t>(object.body->kind());
  });
}
