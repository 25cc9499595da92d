#pragma once
/// Steps of the generalised Newton method with the bodies' unknowns eliminated: dense systems on
/// the pairs in contact.

#include "bodies/model/compliance.hpp"
#include "contact/linear/linear_solver.hpp"
#include "procedures/estimated_system.hpp"
#include "procedures/step_system.hpp"

namespace rollcon {

class CondensedSystem final : public StepSystem {
 public:
  /// `linear` is shared with the contact's own iteration: its kept factors serve both. Everything
  /// must outlive the object; the blocks of problem.op must be assembled.
  CondensedSystem(const Problem& problem, const Frame& frame, const Compliance& compliance,
                  LinearSolver& linear);

  bool solve(const Step& step, const Point& z, double eta, Point& next) override;
  void update(Point& z) override;
  StepCounters counters() const override;

 private:
  bool solve_slip(const Step& step, const Point& z, double eta, Point& next);
  bool solve_estimated(const Step& step, const Point& z, double eta, Point& next);
  void take_active(const Step& step);

  const Problem& problem_;
  LinearSolver& linear_;
  ReducedSystem system_;
  EstimatedSystem estimated_;
  bool gathered_ = false;
  std::vector<std::int32_t> active_;
  std::vector<double> known_[3], b_, x_, jx_, correction_;
  std::int64_t unknowns_ = 0;
  double seconds_ = 0;
};

}  // namespace rollcon
