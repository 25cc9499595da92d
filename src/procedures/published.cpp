#include "procedures/published.hpp"

#include "contact/settle/solve_prepared.hpp"
#include "procedures/gnmls.hpp"

namespace rollcon {
namespace {

class Published final : public PublishedSolver {
 public:
  void run(Solution& s, Newton& newton, Effort& effort, const Options& options, Monitor& monitor) override {
    newton.use(s.procedure);
    newton.linear().forget_exact();
    const Prepared& on = *s.prepared;
    newton.forget_prediction();
    const Tangential tangential = s.frictionless                              ? Tangential::none
                                  : s.procedure.jacobian == Jacobian::reduced ? Tangential::shift
                                                                              : Tangential::slip;
    const StepOptions wanted{s.procedure.monolithic, tangential, s.procedure.linear, s.procedure.preconditioner};
    if (!system_ || wanted != made_for_ || s.given.by_force != by_force_)
      system_ = std::make_unique<StepSystem>(on.problem, on.frame, *on.compliance, wanted);
    made_for_ = wanted;
    by_force_ = s.given.by_force;
    const StepCounters before = system_->counters();
    s.report = gnmls_.solve(on.problem, s.given, s.iterate, *system_, s.procedure, s.frictionless, options.tolerance,
                            options.max_iterations, monitor);
    const StepCounters after = system_->counters();
    effort.linear_iterations = after.iterations - before.iterations;
    effort.factorizations = after.factorizations - before.factorizations;
    effort.right_sides = s.report.normal_iterations + s.report.tangential_iterations + s.report.full_iterations;
    effort.timings.linear = after.seconds - before.seconds;
    effort.unknowns = after.unknowns;
    effort.nonzeros = after.nonzeros;
    s.images_known = !s.frictionless;
  }
  std::size_t bytes() const override { return system_ ? system_->counters().bytes : 0; }

 private:
  Gnmls gnmls_;
  std::unique_ptr<StepSystem> system_;
  StepOptions made_for_;
  std::array<bool, motion_count> by_force_{};
};

}  // namespace

std::unique_ptr<PublishedSolver> make_published() {
  return std::make_unique<Published>();
}

}  // namespace rollcon
