#pragma once
/// Keeps the iteration log of a solve and passes its iterations to the caller's callback.

#include <algorithm>
#include <atomic>

#include "contact/effort.hpp"
#include "contact/newton/report.hpp"
#include "contact/scene/enumerators.hpp"
#include "support/clock.hpp"
#include "support/context.hpp"

namespace rollcon {

/// Asks only whether to stop.
class CancelOnly final : public Monitor {
 public:
  explicit CancelOnly(const std::atomic<bool>& cancel) : cancel_(cancel) {}
  bool step(const StepRecord&) override { return cancel_.load(); }
  bool cancelled() const override { return cancel_.load(); }

 private:
  const std::atomic<bool>& cancel_;
};

class Watch final : public Monitor {
 public:
  Watch(Effort& effort, const Context& context, ProgressFunction function, void* user, std::atomic<bool>& cancel,
        double start)
      : effort_(effort), context_(context), function_(function), user_(user), cancel_(cancel), start_(start) {}

  bool step(const StepRecord& r) override {
    const double seconds = prepared_ > 0 ? prepared_ : now_seconds() - start_;
    prepared_ = 0;
    for (const double v :
         {static_cast<double>(r.part), static_cast<double>(r.iteration), r.residual_normal, r.residual_tangential,
          r.step, static_cast<double>(r.contact), static_cast<double>(r.sliding), seconds})
      effort_.history.push_back(v);
    effort_.merit.push_back(r.merit);
    context_.log(LogLevel::debug,
                 "%s iteration %lld: residual normal %.2e, tangential %.2e; step %.3g; %lld nodes "
                 "in contact, %lld sliding",
                 name(r.part), static_cast<long long>(r.iteration), r.residual_normal, r.residual_tangential, r.step,
                 static_cast<long long>(r.contact), static_cast<long long>(r.sliding));
    return tell(static_cast<Phase>(r.part), r.iteration, std::max(r.residual_normal, r.residual_tangential), seconds);
  }

  bool cancelled() const override { return cancel_.load(); }

  /// Takes the seconds until now, with which the first iteration is told of: its clock need not be read.
  void prepared(double seconds) { prepared_ = seconds; }

  bool tell(Phase phase, std::int64_t iteration, double residual, double seconds) {
    if (cancel_.load()) return true;
    if (!function_) return false;
    Event event;
    event.phase = static_cast<std::int32_t>(phase);
    event.iteration = iteration;
    event.residual = residual;
    event.seconds = seconds;
    if (function_(event, user_) != 0) cancel_.store(true);
    return cancel_.load();
  }

 private:
  static const char* name(Part part) {
    return part == Part::normal ? "normal" : part == Part::tangential ? "tangential" : "full";
  }
  Effort& effort_;
  const Context& context_;
  ProgressFunction function_;
  void* user_;
  std::atomic<bool>& cancel_;
  double start_, prepared_ = 0;
};

}  // namespace rollcon
