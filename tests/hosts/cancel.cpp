/// Tests that flows cancelled at every progress call in turn, by its result and by a request from inside, say so, and
/// that the next call ends as if nothing had happened.

#include <algorithm>
#include <cstdio>
#include <string>

#include "flows.hpp"

namespace {

using namespace hosts;

class Cancelling final : public Caller {
 public:
  /// Cancels at one call of the progress function, counted from 1.
  Cancelling(int at, bool by_request, bool reset) : at_(at), by_request_(by_request), reset_(reset) {
    made_contact = [this](rollcon_contact* contact) {
      contact_ = contact;
      rollcon_contact_set_progress(contact, progress, this);
    };
  }
  int calls() const { return calls_; }
  int cancelled() const { return cancelled_; }

 private:
  static std::int32_t progress(const rollcon_event* event, void* user) {
    auto& self = *static_cast<Cancelling*>(user);
    // Long preparations report that they are at work; how often depends on the clock.
    std::int64_t phase = 0, iteration = 0;
    rollcon_event_get_int(event, ROLLCON_EVENT_PHASE, &phase);
    rollcon_event_get_int(event, ROLLCON_EVENT_ITERATION, &iteration);
    if (phase == ROLLCON_PHASE_COMPLIANCE && iteration > 0) return 0;
    if (++self.calls_ != self.at_) return 0;
    if (!self.by_request_) return 1;
    rollcon_contact_request_cancel(self.contact_);
    return 0;
  }

  std::int32_t make(const char*, const std::function<std::int32_t()>& function) override {
    const std::int32_t status = function();
    if (status != ROLLCON_CANCELLED) return status;
    ++cancelled_;
    if (reset_) rollcon_contact_reset(contact_);
    return function();
  }

  int at_;
  bool by_request_, reset_;
  rollcon_contact* contact_ = nullptr;
  int calls_ = 0, cancelled_ = 0;
};

void cancel_everywhere(const Flow& flow, int threads, Verdict& verdict) {
  Cancelling never(0, false, false);
  never.threads = threads;
  const std::vector<double> right = flow.run(never);
  const int calls = never.calls();
  double worst = 0;
  int late = 0;
  for (int at = 1; at <= calls; ++at)
    for (const bool by_request : {false, true}) {
      Cancelling cancelling(at, by_request, at % 2 == 0);
      cancelling.threads = threads;
      double apart = 1;
      try {
        apart = difference(flow.run(cancelling), right);
      } catch (const Unexpected& error) {
        verdict.expect(false, "%s, cancelled at %d of %d: %s", flow.name, at, calls, error.what());
      }
      worst = std::max(worst, apart);
      // Lists of cases may be finished when the last of them is reported.
      if (std::string(flow.name) == "many" && cancelling.cancelled() == 0)
        ++late;
      else
        verdict.expect(cancelling.cancelled() == 1, "%s, cancelled at %d of %d: %d calls ended so", flow.name, at,
                       calls, cancelling.cancelled());
    }
  std::printf(
      "%s, %d threads: cancelled at each of %d calls (%d times too late), results apart by %.1e (bound 1e-12)\n",
      flow.name, threads, calls, late, worst);
  // The calling thread reports its own cases; on two threads the other one may have taken them all.
  if (threads == 1) {
    verdict.expect(late < calls / 2, "%s: %d of %d times too late", flow.name, late, 2 * calls);
    verdict.expect(calls > 2, "%s: %d progress calls", flow.name, calls);
  }
  verdict.expect(worst <= 1e-12, "%s: results are apart by %.1e", flow.name, worst);
}

}  // namespace

int main() {
  Verdict verdict;
  for (const Flow& flow : flows())
    for (const int threads : {1, 2})
      if (threads == 1 || std::string(flow.name) == "many") cancel_everywhere(flow, threads, verdict);
  return verdict.exit_code();
}
