#pragma once
/// Whom a solve works for.

#include <atomic>
#include <memory>

#include "contact/scene/enumerators.hpp"
#include "support/context.hpp"

namespace rollcon {

struct Host {
  std::shared_ptr<Context> context;
  ProgressFunction progress = nullptr;
  void* user = nullptr;                 ///< of the progress function
  std::atomic<bool>* cancel = nullptr;  ///< set by any thread: the solve that is running stops
  bool quiet = false;                   ///< caveats are for a frame maker alone

  bool cancelled() const noexcept { return cancel->load(); }
  void caveat(Status status, const char* text) const {
    if (!quiet) context->caveat(status, "%s", text);
  }
};

/// Whether a solve with this status leaves a state that a time step can start from.
inline bool is_answer(Status status) {
  return status == Status::ok || status == Status::rim_contact || status == Status::coarse ||
         status == Status::no_contact || status == Status::inaccurate || status == Status::too_deep;
}

}  // namespace rollcon
