/// Contexts, and handles as integers.

#include "support/context.hpp"

#include "capi/guard.hpp"
#include "capi/results.hpp"

using namespace rollcon;
using namespace rollcon::capi;

namespace {

template <class Handle>
Handle* as_handle(const void* handle) {
  return static_cast<Handle*>(const_cast<void*>(handle));
}

}  // namespace

rollcon_status rollcon_context_create(int32_t header_abi, rollcon_context** context) {
  if (!context) return ROLLCON_ERR_ARGUMENT;
  *context = nullptr;
  if (header_abi != ROLLCON_ABI) return ROLLCON_ERR_UNSUPPORTED;
  return guarded(__func__, nullptr, [&] {
    auto object = std::make_shared<Object>();
    object->context = std::make_shared<Context>();
    *context = as_handle<rollcon_context>(handles().insert(Kind::context, std::move(object)));
  });
}

rollcon_status rollcon_context_retain(rollcon_context* context) {
  return retain(Kind::context, context);
}

void rollcon_context_release(rollcon_context* context) {
  release(Kind::context, context);
}

rollcon_status rollcon_context_set_log(rollcon_context* context, int32_t max_level,
                                       rollcon_log_fn fn, void* user) {
  return with_object(__func__, Kind::context, context,
                     [&](Object& object) { object.context->set_log(max_level, fn, user); });
}

rollcon_status rollcon_context_set_threads(rollcon_context* context, int32_t n) {
  return with_object(__func__, Kind::context, context,
                     [&](Object& object) { object.context->set_threads(n); });
}

rollcon_status rollcon_context_get_error(const rollcon_context* context, int64_t capacity,
                                         char* text, int64_t* needed) {
  if (!context) return ROLLCON_ERR_ARGUMENT;
  const std::shared_ptr<Object> object = handles().find(Kind::context, context);
  if (!object) return ROLLCON_ERR_HANDLE;
  // Its own failures are not stored: they would replace the text that was asked for.
  return guarded(__func__, nullptr,
                 [&] { copy_text(object->context->error(), capacity, text, needed); });
}

int32_t rollcon_id_of(const void* handle) {
  return handles().id_of(handle);
}

rollcon_context* rollcon_context_from_id(int32_t id) {
  return as_handle<rollcon_context>(HandleTable::from_id(id));
}

rollcon_body* rollcon_body_from_id(int32_t id) {
  return as_handle<rollcon_body>(HandleTable::from_id(id));
}

rollcon_contact* rollcon_contact_from_id(int32_t id) {
  return as_handle<rollcon_contact>(HandleTable::from_id(id));
}
