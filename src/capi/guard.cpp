#include "capi/guard.hpp"

#include <new>

namespace rollcon::capi {

Status report(const char* function, Context* context, Status status, const char* message) noexcept {
  if (!context) return status;
  context->set_error(function, message);
  try {
    context->log(LogLevel::error, "%s: %s", function, message);
  } catch (...) {
    // A log sink that throws: the status has to do.
  }
  return status;
}

Status report_current_exception(const char* function, Context* context) noexcept {
  try {
    throw;
  } catch (const Error& error) {
    return report(function, context, error.status(), error.what());
  } catch (const std::bad_alloc&) {
    return report(function, context, Status::err_memory, "out of memory");
  } catch (const std::exception& error) {
    return report(function, context, Status::err_internal, error.what());
  } catch (...) {
    return report(function, context, Status::err_internal, "an unknown exception");
  }
}

std::int32_t retain(Kind kind, const void* handle) noexcept {
  if (!handle) return ROLLCON_ERR_ARGUMENT;
  return handles().retain(kind, handle) ? ROLLCON_OK : ROLLCON_ERR_HANDLE;
}

void release(Kind kind, const void* handle) noexcept {
  if (!handle) return;
  const QuietFloatingPoint quiet;
  handles().release(kind, handle).reset();
}

}  // namespace rollcon::capi
