#pragma once
/// Lets preparation tell the host's progress function that it is at work, and stop when asked to.

#include <atomic>

#include "contact/scene/enumerators.hpp"
#include "support/clock.hpp"
#include "support/interrupt.hpp"

namespace rollcon {

/// Counts iterations of the phase `compliance` from 1; the phase's end is told as 0.
class HostInterrupt final : public Interrupt {
 public:
  HostInterrupt(ProgressFunction function, void* user, std::atomic<bool>& cancel)
      : function_(function), user_(user), cancel_(cancel) {}
  bool wanted() const override { return cancel_.load(std::memory_order_relaxed); }

 private:
  void tell() override {
    if (!function_) return;
    Event event;
    event.phase = static_cast<std::int32_t>(Phase::compliance);
    event.iteration = ++told_;
    event.seconds = now_seconds() - start_;
    if (function_(event, user_) != 0) cancel_.store(true);
  }

  ProgressFunction function_;
  void* user_;
  std::atomic<bool>& cancel_;
  const double start_ = now_seconds();
  std::int64_t told_ = 0;
};

}  // namespace rollcon
