/// Implements the calls that make bodies and give them meshes, supports and loads.

#include "bodies/body.hpp"

#include <memory>
#include <utility>

#include "capi/guard.hpp"
#include "linalg/blas_threads.hpp"
#include "support/input_checks.hpp"

using namespace rollcon;
using namespace rollcon::capi;

namespace {

rollcon_body* handle_of(const std::shared_ptr<Context>& context, std::shared_ptr<Body> body) {
  auto object = std::make_shared<Object>();
  object->context = context;
  object->body = std::move(body);
  return static_cast<rollcon_body*>(const_cast<void*>(handles().insert(Kind::body, std::move(object))));
}

}  // namespace

rollcon_status rollcon_body_create(rollcon_context* context, int32_t kind, rollcon_body** body) {
  if (body) *body = nullptr;
  return with_object(__func__, Kind::context, context, [&](Object& parent) {
    require_pointer(body, "body");
    *body = handle_of(parent.context, std::make_shared<Body>(parent.context, kind));
  });
}

rollcon_status rollcon_body_save(rollcon_body* body, const char* path) {
  return with_body(__func__, body, [&](Body& b) {
    require_pointer(path, "path");
    b.save(path);
  });
}

rollcon_status rollcon_body_load(rollcon_context* context, const char* path, rollcon_body** body) {
  if (body) *body = nullptr;
  return with_object(__func__, Kind::context, context, [&](Object& parent) {
    require_pointer(body, "body");
    require_pointer(path, "path");
    const BlasThreads blas(parent.context->threads());
    *body = handle_of(parent.context, Body::load(parent.context, path));
  });
}

rollcon_status rollcon_body_copy(const rollcon_body* body, rollcon_body** copy) {
  if (copy) *copy = nullptr;
  return with_object(__func__, Kind::body, body, [&](Object& from) {
    require_pointer(copy, "copy");
    *copy = handle_of(from.context, from.body->copy());
  });
}

rollcon_status rollcon_body_prepare(rollcon_body* body) {
  return with_object(__func__, Kind::body, body, [](Object& object) {
    const BlasThreads blas(object.context->threads());
    const auto prepare = [&] { object.body->prepare(); };
    if (object.body->options().factor_ranks == 0) return prepare();
    const SharedWork shared(object.context->ranks());
    object.context->ranks().together(prepare);
  });
}

rollcon_status rollcon_body_get_profile_point(const rollcon_body* body, double s, double* point, double* tangent,
                                              double* curvature) {
  return with_body(__func__, body, [&](const Body& b) {
    require_pointer(point, "point");
    require_pointer(tangent, "tangent");
    require_pointer(curvature, "curvature");
    const ProfilePoint p = b.profile_point(s);
    const Vec2 along = p.tangent();
    for (std::size_t c = 0; c < 2; ++c) {
      point[c] = p.x[c];
      tangent[c] = along[c];
    }
    *curvature = p.curvature();
  });
}

rollcon_status rollcon_body_get_kind(const rollcon_body* body, int32_t* kind) {
  return with_shared(__func__, Kind::body, body, [&](Object& object) {
    require_pointer(kind, "kind");
    *kind = static_cast<int32_t>(object.body->kind());
  });
}
