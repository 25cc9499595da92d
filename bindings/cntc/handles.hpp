#pragma once
#include <rollcon.h>

#include <memory>
#include <stdexcept>

namespace cntc {

template <auto release>
struct Releaser {
  template <class T>
  void operator()(T* p) const {
    release(p);
  }
};
using ContextHandle = std::unique_ptr<rollcon_context, Releaser<rollcon_context_release>>;
using BodyHandle = std::unique_ptr<rollcon_body, Releaser<rollcon_body_release>>;
using ContactHandle = std::unique_ptr<rollcon_contact, Releaser<rollcon_contact_release>>;
using WheelHandle = std::unique_ptr<rollcon_wheelrail, Releaser<rollcon_wheelrail_release>>;

/// Ends a solve with one of CONTACT's error codes.
struct Failure : std::runtime_error {
  Failure(int code_, const std::string& text) : std::runtime_error(text), code(code_) {}
  int code;
};

/// Throws Failure with rollcon's last error if a call of rollcon failed.
int check(rollcon_status status);

/// Makes an object of rollcon by the function that creates it; throws Failure.
template <class Handle, class Create, class... A>
void create(Handle& handle, Create function, A... arguments) {
  typename Handle::pointer made = nullptr;
  check(function(arguments..., &made));
  handle.reset(made);
}

}  // namespace cntc
