/// Tangential loads of frames that the library makes: what they take of friction, and their part on each frame.

#include "contact/contact.hpp"
#include "contact/results/outcome_text.hpp"
#include "contact/scene/host_interrupt.hpp"
#include "contact/solution.hpp"
#include "linalg/blas_threads.hpp"
#include "support/clock.hpp"

namespace rollcon {
namespace {

class Quiet final : public Monitor {
 public:
  explicit Quiet(const std::atomic<bool>& cancel) : cancel_(cancel) {}
  bool step(const StepRecord&) override { return cancel_.load(); }
  bool cancelled() const override { return cancel_.load(); }

 private:
  const std::atomic<bool>& cancel_;
};

}  // namespace

std::optional<FrictionShare> Contact::frictionless_share() {
  SolverState& s = *state_;
  const double start = now_seconds();
  forget_solution(s);
  {
    const HostInterrupt interrupt(progress_, progress_user_, *cancel_);
    prepare_or_clear();
  }
  s.revision_solved = scene.revision;
  refuse_overflow(s);
  try {
    const BlasThreads blas(blas_threads());
    std::optional<FrictionShare> share;
    Quiet monitor(*cancel_);
    if (s.procedure.standard() && !s.frictionless) {
      if (!s.frictionless_share) s.frictionless_share = std::make_unique<FrictionlessShare>();
      share = s.frictionless_share->find(s.prepared->problem, s.given, s.procedure, scene.options.tolerance,
                                         scene.options.max_iterations, monitor);
    }
    s.ahead = {true, s.work_before, s.assemblies_before, s.timings, now_seconds() - start};
    return share;
  } catch (...) {
    clear_state();
    throw;
  }
}

void Contact::refuse_loads(const FrictionShare& share) const {
  fail(Status::err_load, "%s: there is no steady solution", describe_beyond_friction(share).c_str());
}

}  // namespace rollcon
