#pragma once
/// Represents failures inside the library: a status and a message, thrown as one type and mapped once, at the C
/// boundary. Messages name the offending entry and the allowed range; the C layer adds the name of the public function.

#include <cstdint>
#include <exception>
#include <new>
#include <string>

namespace rollcon {

/// Lists the statuses. Numbers are those of rollcon.h and never change.
enum class Status : std::int32_t {
  ok = 0,
  not_converged = 1,
  no_contact = 2,
  cancelled = 3,
  rim_contact = 4,
  coarse = 5,
  inaccurate = 6,
  too_deep = 7,
  derailed = 8,
  err_argument = -1,
  err_handle = -2,
  err_nonfinite = -3,
  err_mesh = -4,
  err_state = -5,
  err_option = -6,
  err_capacity = -7,
  err_singular = -8,
  err_memory = -9,
  err_unsupported = -10,
  err_busy = -11,
  err_load = -12,
  err_io = -13,
  err_internal = -99,
};

class Error : public std::exception {
 public:
  Error(Status status, std::string message) : status_(status), message_(std::move(message)) {}
  Status status() const noexcept { return status_; }
  const char* what() const noexcept override { return message_.c_str(); }

 private:
  Status status_;
  std::string message_;
};

/// Returns the one of two statuses that comes first in the order of docs/api.md; a failure counts as not_converged.
Status worse(Status a, Status b);

/// Throws Error; the message is formatted as printf does, and holds whatever length is needed.
[[noreturn]] void fail(Status status, const char* format, ...) __attribute__((format(printf, 2, 3)));

/// Returns the text for an allocation that failed: "out of memory: this machine has free 1 GB". It belongs to the
/// thread.
const char* out_of_memory_text() noexcept;

/// Calls tell(status, text) for the exception in flight, from a catch block.
template <class Tell>
auto tell_exception(const Tell& tell) {
  try {
    throw;
  } catch (const Error& error) {
    return tell(error.status(), error.what());
  } catch (const std::bad_alloc&) {
    return tell(Status::err_memory, out_of_memory_text());
  } catch (const std::exception& error) {
    return tell(Status::err_internal, error.what());
  } catch (...) {
    return tell(Status::err_internal, "an unknown exception");
  }
}

}  // namespace rollcon
