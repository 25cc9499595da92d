#pragma once
/// Wraps every public function: a quiet floating-point environment, handle to object, busy flag, exceptions to
/// statuses. Functions pass their own name, because __func__ inside a lambda is the lambda's.

#include <cerrno>
#include <cstdint>
#include <memory>
#include <type_traits>

#include "capi/handle_table.hpp"
#include "support/error.hpp"
#include "support/fpenv.hpp"
#include "support/last_error.hpp"

namespace rollcon::capi {

/// Makes "function: message" the thread's last error, and hands it to the context's log and latch.
Status report(const char* function, Context* context, Status status, const char* message) noexcept;

/// Reports a handle that is null or does not belong to a live object of this kind.
std::int32_t report_handle(const char* function, Kind kind, const void* handle) noexcept;

/// Makes the failure that the context's latch holds the thread's last error.
std::int32_t report_latched(const Context& context) noexcept;

/// Makes the context's caveat the thread's last caveat, and hands it to the context's latch.
void report_caveat(const char* function, Context& context, Status status) noexcept;

const char* name(Kind kind) noexcept;

/// Reports the exception in flight; call it from a catch block.
Status report_current_exception(const char* function, Context* context) noexcept;

/// Runs the body of a function that has no object, or whose object was found already.
template <class F>
std::int32_t guarded(const char* function, Context* context, F&& body) noexcept {
  const QuietFloatingPoint quiet;
  const int hosts_errno = errno;
  Status status = Status::ok;
  forget_caveat_note();
  try {
    if constexpr (std::is_void_v<std::invoke_result_t<F>>)
      body();
    else
      status = body();
  } catch (...) {
    status = report_current_exception(function, context);
  }
  if (context && static_cast<std::int32_t>(status) > 0) report_caveat(function, *context, status);
  errno = hosts_errno;
  return static_cast<std::int32_t>(status);
}

/// Runs the body with the object of a handle, which it may share with calls in other threads.
template <class F>
std::int32_t with_shared(const char* function, Kind kind, const void* handle, F&& body) noexcept {
  const std::shared_ptr<Object> object = handles().find(kind, handle);
  if (!object) return report_handle(function, kind, handle);
  return guarded(function, object->context.get(), [&] { return body(*object); });
}

/// Keeps other calls off an object while it lives. Throws err_busy, naming the object by `what`, if another call has
/// it.
class InUse {
 public:
  InUse(const Object& object, const char* what) : busy_(*object.busy) {
    if (busy_.exchange(true, std::memory_order_acquire))
      fail(Status::err_busy, "the %s is in use by another call", what);
  }
  ~InUse() { busy_.store(false, std::memory_order_release); }
  InUse(const InUse&) = delete;
  InUse& operator=(const InUse&) = delete;

 private:
  std::atomic<bool>& busy_;
};

/// Runs the body with the object of a handle for itself alone, unless the context's latch has caught a failure.
template <class F>
std::int32_t with_object(const char* function, Kind kind, const void* handle, F&& body) noexcept {
  const std::shared_ptr<Object> found = handles().find(kind, handle);
  if (!found) return report_handle(function, kind, handle);
  Object& object = *found;
  if (object.context->latched() != Status::ok) return report_latched(*object.context);
  return guarded(function, object.context.get(), [&] {
    const InUse use(object, name(kind));
    return body(object);
  });
}

template <class F>
std::int32_t with_contact(const char* function, const rollcon_contact* handle, F&& body) noexcept {
  return with_object(function, Kind::contact, handle, [&](Object& object) { return body(*object.contact); });
}

/// Runs the body for a call that changes the contact, whose handle is therefore not const.
template <class F>
std::int32_t with_contact(const char* function, rollcon_contact* handle, F&& body) noexcept {
  return with_object(function, Kind::contact, handle, [&](Object& object) {
    if (object.read_only)
      fail(Status::err_state, "the contact belongs to a wheel on its rail, which alone changes it: set that one");
    return body(*object.contact);
  });
}

template <class F>
std::int32_t with_body(const char* function, const rollcon_body* handle, F&& body) noexcept {
  return with_object(function, Kind::body, handle, [&](Object& object) { return body(*object.body); });
}

template <class F>
std::int32_t with_wheelrail(const char* function, const rollcon_wheelrail* handle, F&& body) noexcept {
  return with_object(function, Kind::wheelrail, handle, [&](Object& object) { return body(*object.wheelrail); });
}

template <class F>
std::int32_t with_table(const char* function, const rollcon_table* handle, F&& body) noexcept {
  return with_object(function, Kind::table, handle, [&](Object& object) { return body(*object.table); });
}

/// Makes the body of a call a joint one of all ranks of its object's context: an error on one rank is one on all.
template <class F>
auto together(const F& body) {
  return [&](auto& object) { return object.context().ranks().together([&] { return body(object); }); };
}

// Returns the body that a further argument of a call refers to; errors give the argument's name.

std::shared_ptr<Body> body_of(const rollcon_body* handle, const char* name);
std::shared_ptr<const ForceTable> table_of(const rollcon_table* handle, const char* name);

std::int32_t retain(const char* function, Kind kind, const void* handle) noexcept;
void release(Kind kind, const void* handle) noexcept;

}  // namespace rollcon::capi
