#include "procedures/published.hpp"

#include "contact/prepare/preparation.hpp"
#include "procedures/condensed.hpp"
#include "procedures/gnmls.hpp"
#include "procedures/monolithic.hpp"

namespace rollcon {
namespace {

/// What a system of the steps was made for.
struct Key {
  bool monolithic = false, frictionless = false;
  std::array<bool, 4> by_force{};
  LinearMethod linear = LinearMethod::automatic;
  Preconditioner preconditioner = Preconditioner::automatic;
  bool operator==(const Key&) const = default;
};

std::unique_ptr<StepSystem> make_step_system(SolverState& s) {
  Prepared& on = *s.preparation->made;
  if (s.procedure.monolithic) {
    const bool direct =
        s.procedure.linear == LinearMethod::lu || s.procedure.linear == LinearMethod::automatic;
    const MonolithicOptions options{direct ? StepSolver::lu : StepSolver::gmres,
                                    s.procedure.preconditioner};
    return std::make_unique<MonolithicSystem>(on.problem, on.frame, *on.compliance, options);
  }
  return std::make_unique<CondensedSystem>(on.problem, on.frame, *on.compliance, s.newton.linear());
}

class Published final : public PublishedSolver {
 public:
  void run(SolverState& s, const Options& options, Monitor& monitor) override {
    s.newton.use(s.procedure);
    s.newton.linear().forget_exact();
    Prepared& on = *s.preparation->made;
    static_cast<Prescribed&>(on.problem) = s.given;
    s.newton.forget_prediction();
    const Key key{s.procedure.monolithic, s.frictionless, s.given.by_force, s.procedure.linear,
                  s.procedure.preconditioner};
    if (!system_ || key != key_) system_ = make_step_system(s);
    key_ = key;
    const StepCounters before = system_->counters();
    s.report = gnmls_.solve(on.problem, s.iterate, *system_, s.procedure, s.frictionless,
                            options.tolerance, options.max_iterations, monitor);
    const StepCounters after = system_->counters();
    s.linear_iterations = after.iterations - before.iterations;
    s.factorizations = after.factorizations - before.factorizations;
    s.right_sides =
        s.report.normal_iterations + s.report.tangential_iterations + s.report.full_iterations;
    s.timings.linear = after.seconds - before.seconds;
    s.system_unknowns = after.unknowns;
    s.system_nonzeros = after.nonzeros;
    s.images_known = !s.frictionless;
  }
  std::size_t bytes() const override { return system_ ? system_->counters().bytes : 0; }

 private:
  Gnmls gnmls_;
  std::unique_ptr<StepSystem> system_;
  Key key_;
};

}  // namespace

std::unique_ptr<PublishedSolver> make_published() {
  return std::make_unique<Published>();
}

}  // namespace rollcon
