#pragma once
/// The generalised Newton method with line search (Pang 1990) of Rodriguez-Tembleque & Abascal
/// (2010), section 11.1, on either form of the system and with any of its Jacobians.

#include "contact/newton/newton.hpp"
#include "contact/scene/procedure.hpp"
#include "procedures/step_system.hpp"

namespace rollcon {

class Gnmls {
 public:
  /// Solves from the given iterate; all zero: a cold start, (section 11.6) zero tractions, or a
  /// Hertzian pressure where the Jacobian is the exact one. On return the iterate's images belong
  /// to its tractions.
  NewtonReport solve(Problem& problem, Iterate& iterate, StepSystem& system,
                     const Procedure& procedure, bool frictionless, double tolerance,
                     std::int64_t max_iterations, Monitor& monitor);

 private:
  struct Residual {
    double normal = 0, tangential = 0, load = 0, imbalance = 0, merit = 0;
    std::int64_t contact = 0, sliding = 0;
    double worst() const;
  };
  void begin(Iterate& iterate, bool frictionless);
  Outcome run(double tolerance, std::int64_t max_iterations, Monitor& monitor);
  /// Laws at a point; fixes the scales that residuals are relative to when `measure`.
  Residual evaluate(const Point& z, bool measure);
  double load_residual(const Point& z) const;
  void linearise();
  bool beyond_friction();
  bool creepage_unknown() const;
  bool any_sticks() const;
  void estimate_slip();
  double next_tolerance(const Residual& residual, double worst, double tolerance);
  double search(double merit, Point& trial);

  Problem* problem_ = nullptr;
  StepSystem* system_ = nullptr;
  Procedure procedure_;
  NewtonReport report_;
  bool tangential_ = true, stick_first_ = false, warm_ = false;
  Point z_, next_, trial_, best_;
  double best_worst_ = 0;
  Step step_;
  std::vector<double> merits_;
  double pressure_scale_ = 1, traction_scale_ = 1;
  double eta_ = 0, last_merit_ = 0;
  double sharpening_ = 1;  ///< of linear tolerances, after short steps
};

}  // namespace rollcon
