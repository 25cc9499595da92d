/// Implements the calls that solve, watch and stop a solution.

#include "capi/guard.hpp"
#include "capi/progress.hpp"
#include "capi/results.hpp"
#include "support/input_checks.hpp"
#include "support/last_error.hpp"

using namespace rollcon;
using namespace rollcon::capi;

namespace {

/// Lists the events that live in callbacks of this thread, the innermost first. An event handle is an address and is
/// compared with these before use.
struct LiveEvent {
  const Event& event;
  Context* context;
  const LiveEvent* outer;
};

thread_local const LiveEvent* innermost_event = nullptr;

template <class F>
std::int32_t with_event(const char* function, const rollcon_event* handle, F&& body) noexcept {
  for (const LiveEvent* live = innermost_event; live; live = live->outer) {
    if (reinterpret_cast<const rollcon_event*>(&live->event) == handle)
      return guarded(function, live->context, [&] { body(live->event); });
  }
  set_last_error(function, handle ? "event is no live event: events live as long as the callback "
                                    "that is given them, in its thread"
                                  : "event is NULL");
  return handle ? ROLLCON_ERR_HANDLE : ROLLCON_ERR_ARGUMENT;
}

}  // namespace

std::int32_t rollcon::capi::call_progress(const Event& event, void* user) {
  const auto& object = *static_cast<const Object*>(user);
  const LiveEvent live{event, object.context.get(), innermost_event};
  innermost_event = &live;
  struct Leave {
    ~Leave() { innermost_event = innermost_event->outer; }
  } const at_end;
  const HostFloatingPoint host;
  return object.progress(reinterpret_cast<const rollcon_event*>(&event), object.progress_user);
}

rollcon_status rollcon_contact_set_progress(rollcon_contact* contact, rollcon_progress_fn fn, void* user) {
  return with_object(__func__, Kind::contact, contact, [&](Object& object) {
    object.progress = fn;
    object.progress_user = user;
    object.contact->set_progress(fn ? call_progress : nullptr, &object);
  });
}

rollcon_status rollcon_event_get_int(const rollcon_event* event, int32_t key, int64_t* value) {
  return with_event(__func__, event, [&](const Event& e) {
    require_pointer(value, "value");
    switch (key) {
      case ROLLCON_EVENT_PHASE:
        *value = e.phase;
        return;
      case ROLLCON_EVENT_ITERATION:
        *value = e.iteration;
        return;
      default:
        fail(Status::err_argument, "key is %d; allowed: 1 (phase), 2 (iteration)", key);
    }
  });
}

rollcon_status rollcon_event_get_real(const rollcon_event* event, int32_t key, double* value) {
  return with_event(__func__, event, [&](const Event& e) {
    require_pointer(value, "value");
    switch (key) {
      case ROLLCON_EVENT_RESIDUAL:
        *value = e.residual;
        return;
      case ROLLCON_EVENT_SECONDS:
        *value = e.seconds;
        return;
      default:
        fail(Status::err_argument, "key is %d; allowed: 101 (residual), 102 (seconds)", key);
    }
  });
}

rollcon_status rollcon_contact_past_get(const rollcon_contact* contact, int64_t capacity, double* past,
                                        int64_t* n_values) {
  return with_contact(__func__, contact, [&](const Contact& c) {
    if (wants_copy(c.past_get(0, nullptr), capacity, past, "past", n_values, "doubles")) c.past_get(capacity, past);
  });
}
