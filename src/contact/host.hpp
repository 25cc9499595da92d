#pragma once
/// Tells a solve whom it works for.

#include <atomic>
#include <memory>

#include "contact/scene/enumerators.hpp"
#include "support/context.hpp"

namespace rollcon {

struct Host {
  std::shared_ptr<Context> context;
  ProgressFunction progress = nullptr;
  void* user = nullptr;                 ///< argument of the progress function
  std::atomic<bool>* cancel = nullptr;  ///< flag that any thread may set to stop the running solve
  bool quiet = false;                   ///< caveats are not told to the context

  bool cancelled() const noexcept { return cancel->load(); }
  void caveat(Status status, const char* text) const {
    if (!quiet) context->caveat(status, "%s", text);
  }
};

/// Says whether a solve with this status leaves a state that a time step can start from.
inline bool is_answer(Status status) {
  return status == Status::ok || status == Status::rim_contact || status == Status::coarse ||
         status == Status::no_contact || status == Status::inaccurate || status == Status::too_deep;
}

}  // namespace rollcon
