#pragma once
/// Implements the generalised Newton method with line search (Pang 1990) of Rodriguez-Tembleque & Abascal (2010),
/// section 11.1, on either form of the system and with any of its Jacobians.

#include "contact/newton/report.hpp"
#include "contact/problem/law_residual.hpp"
#include "contact/scene/procedure.hpp"
#include "procedures/step_system.hpp"

namespace rollcon {

class Gnmls {
 public:
  /// Solves from the given iterate. All zeros stand for a cold start (section 11.6): zero tractions, or a Hertzian
  /// pressure where the Jacobian is the exact one. On return the iterate's images belong to its tractions.
  NewtonReport solve(const Problem& problem, const Prescribed& given, Iterate& iterate, StepSystem& system,
                     const Procedure& procedure, bool frictionless, double tolerance, std::int64_t max_iterations,
                     Monitor& monitor);

 private:
  struct Residual : LawResidual {
    double imbalance = 0;
    double greatest() const { return std::max({normal, tangential, load, imbalance}); }
  };
  void begin(Iterate& iterate, bool frictionless);
  Outcome run(double tolerance, std::int64_t max_iterations, Monitor& monitor);
  /// Evaluates the laws at a point; fixes the scales that residuals are relative to when `measure`.
  Residual evaluate(const Point& z, bool measure);
  void linearise();
  bool beyond_friction();
  bool creepage_unknown() const;
  bool any_sticks() const;
  void estimate_slip();
  double next_tolerance(const Residual& residual, double worst, double tolerance);
  double search(double merit, Point& trial);

  const Problem* problem_ = nullptr;
  Prescribed given_;
  StepSystem* system_ = nullptr;
  Procedure procedure_;
  NewtonReport report_;
  bool tangential_ = true, stick_first_ = false, warm_ = false;
  Point z_, next_, trial_, best_;
  double best_worst_ = 0;
  Step step_;
  std::vector<double> merits_;
  LawScales scales_;
  double eta_ = 0, last_merit_ = 0;
  double sharpening_ = 1;  ///< factor on linear tolerances, after short steps
};

}  // namespace rollcon
