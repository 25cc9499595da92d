#pragma once
/// Steps of the generalised Newton method with the bodies' unknowns written out: the paper's
/// systems (48), (58), (62), or (88) with reduced unknowns, for any pair of bodies.

#include <memory>

#include "bodies/model/compliance.hpp"
#include "procedures/monolithic_krylov.hpp"
#include "procedures/step_system.hpp"

namespace rollcon {

struct MonolithicOptions {
  StepSolver solver = StepSolver::lu;
  Preconditioner preconditioner = Preconditioner::automatic;  ///< of GMRES
};

class MonolithicSystem final : public StepSystem {
 public:
  /// Scales rn and rt, convection and loads are the problem's; its dense blocks are not needed.
  /// Everything must outlive the object. Throws Error(err_unsupported) when a body cannot be
  /// written out, and when the system is sparse, large, and the build has no UMFPACK.
  MonolithicSystem(const Problem& problem, const Frame& frame, const Compliance& compliance,
                   const MonolithicOptions& options);

  bool solve(const Step& step, const Point& z, double eta, Point& next) override;
  void update(Point& z) override;
  double imbalance(const Point& z) override;
  StepCounters counters() const override;

 private:
  struct Form {
    std::unique_ptr<MonolithicMatrix> matrix;
    MonolithicLu lu;
    int excess = 0;  ///< iterations beyond good ones since these factors were made
  };
  Form& form(const Step& step);
  bool factor(Form& form);
  bool solve_directly(Form& form, const std::vector<double>& residual);
  bool solve_iteratively(Form& form, const std::vector<double>& residual, double target);
  bool solve_with_kept_factors(Form& form, const std::vector<double>& residual, double target);
  bool solve_core(double target);
  bool solve_with_body_factors(double target);
  GmresReport run(LinearOperator& system, LinearOperator& preconditioner,
                  const std::vector<double>& right, std::vector<double>& x, double target,
                  int space, int limit);

  const Problem& problem_;
  const Frame& frame_;
  MonolithicOptions options_;
  MonolithicBodies bodies_;
  Form form_[3];
  StepCounters counters_;
  MonolithicCore core_;
  CoreProduct core_product_;
  CoreDiagonal diagonal_;
  CoreBodies body_factors_;
  int fresh_iterations_ = 0, excess_ = 0;  ///< of body_factors_
  Gmres gmres_;
  std::vector<double> b_, x_, product_, correction_, rest_, right_, solution_;
};

}  // namespace rollcon
