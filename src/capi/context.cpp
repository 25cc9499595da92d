/// Implements the calls for contexts, and handles as integers.

#include "support/context.hpp"

#include "capi/guard.hpp"
#include "support/input_checks.hpp"

using namespace rollcon;
using namespace rollcon::capi;

rollcon_status rollcon_context_create(int32_t header_abi, rollcon_context** context) {
  if (context) *context = nullptr;
  return guarded(__func__, nullptr, [&] {
    require_pointer(context, "context");
    if (header_abi != ROLLCON_ABI)
      fail(Status::err_unsupported,
           "header_abi is %d, but this library, rollcon %s, has the binary interface %d: compile "
           "the program with the rollcon.h of the library that it runs with",
           header_abi, ROLLCON_VERSION_STRING, ROLLCON_ABI);
    auto object = std::make_shared<Object>();
    object->context = std::make_shared<Context>();
    *context = static_cast<rollcon_context*>(const_cast<void*>(handles().insert(Kind::context, std::move(object))));
  });
}

rollcon_status rollcon_context_set_log(rollcon_context* context, int32_t max_level, rollcon_log_fn fn, void* user) {
  return with_object(__func__, Kind::context, context,
                     [&](Object& object) { object.context->set_log(max_level, fn, user); });
}

rollcon_status rollcon_context_set_latch(rollcon_context* context, int32_t on) {
  return with_shared(__func__, Kind::context, context, [&](Object& object) {
    if (on != 0 && on != 1) fail(Status::err_argument, "on is %d; allowed: 0, 1", on);
    object.context->set_latch(on != 0);
  });
}

rollcon_status rollcon_context_check(const rollcon_context* context) {
  const std::shared_ptr<Object> object = handles().find(Kind::context, context);
  return object ? report_latched(*object->context) : report_handle(__func__, Kind::context, context);
}

int32_t rollcon_id_of(const void* handle) {
  return handles().id_of(handle);
}
