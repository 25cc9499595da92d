#include "capi/guard.hpp"

#include <cstdio>
#include <string>

#include "support/input_checks.hpp"
#include "support/last_error.hpp"

namespace rollcon::capi {

Status report(const char* function, Context* context, Status status, const char* message) noexcept {
  set_last_error(function, message);
  if (!context) return status;
  context->keep(status, last_error());
  try {
    context->log(LogLevel::error, "%s", last_error());
  } catch (...) {
    // The log sink threw; the status alone has to report the failure.
  }
  set_last_error(function, message);  // the sink may have set an error of its own
  return status;
}

Status report_current_exception(const char* function, Context* context) noexcept {
  return tell_exception([&](Status status, const char* text) { return report(function, context, status, text); });
}

const char* name(Kind kind) noexcept {
  switch (kind) {
    case Kind::context:
      return "context";
    case Kind::body:
      return "body";
    case Kind::contact:
      return "contact";
    case Kind::wheelrail:
      return "wheelrail";
    default:
      return "table";
  }
}

std::int32_t report_handle(const char* function, Kind kind, const void* handle) noexcept {
  const int hosts_errno = errno;
  char text[128];
  if (handle)
    std::snprintf(text, sizeof text, "%s is no live %s: it was released, is of another kind, or never was a handle",
                  name(kind), name(kind));
  else
    std::snprintf(text, sizeof text, "%s is NULL: there is no %s to work on", name(kind), name(kind));
  set_last_error(function, text);
  errno = hosts_errno;
  return handle ? ROLLCON_ERR_HANDLE : ROLLCON_ERR_ARGUMENT;
}

std::int32_t report_latched(const Context& context) noexcept {
  return static_cast<std::int32_t>(context.tell_kept());
}

void report_caveat(const char* function, Context& context, Status status) noexcept {
  set_last_caveat(function, status, rollcon_status_string(static_cast<std::int32_t>(status)));
  context.keep(status, last_caveat());
}

std::shared_ptr<Body> body_of(const rollcon_body* handle, const char* name) {
  require_pointer(handle, name);
  const std::shared_ptr<Object> object = handles().find(Kind::body, handle);
  if (!object) fail(Status::err_handle, "%s is not a live body", name);
  return object->body;
}

std::shared_ptr<const ForceTable> table_of(const rollcon_table* handle, const char* name) {
  require_pointer(handle, name);
  const std::shared_ptr<Object> object = handles().find(Kind::table, handle);
  if (!object) fail(Status::err_handle, "%s is not a live table", name);
  return object->table;
}

std::int32_t retain(const char* function, Kind kind, const void* handle) noexcept {
  return handles().retain(kind, handle) ? ROLLCON_OK : report_handle(function, kind, handle);
}

void release(Kind kind, const void* handle) noexcept {
  if (!handle) return;
  const QuietFloatingPoint quiet;
  handles().release(kind, handle).reset();
}

}  // namespace rollcon::capi
