#pragma once
/// Solves a problem by Newton's iteration: the order of its parts, a guard before every success, and what is tried
/// where the full step gets stuck.

#include <cstdint>
#include <functional>
#include <vector>

#include "contact/newton/iteration.hpp"

namespace rollcon {

class Newton {
 public:
  bool predict = true;  ///< warm starts look along the line of the last change

  /// Solves from the given iterate (all zero: cold start; the approach is then guessed when the load is a force).
  /// frictionless: mu is zero at every node.
  NewtonReport solve(const Problem& problem, const Prescribed& given, Iterate& iterate, bool frictionless,
                     double tolerance, std::int64_t max_iterations, Monitor& monitor);
  /// Returns the part whose convergence ends a solve: all unknowns at once unless the normal problem stands alone.
  static Part goal(const Problem& problem, const Prescribed& given, bool frictionless);
  ReducedSystem& linearise(const Problem& problem, const Prescribed& given, const Iterate& iterate, Part part) {
    return iteration_.linearise(problem, given, iterate, part);
  }
  LinearSolver& linear() { return iteration_.linear; }
  /// Takes the tolerances of the linear systems.
  void use(const Procedure& procedure);
  /// Tells that the next iterate is not one that this class found.
  void forget_prediction() { iteration_.prediction.forget(); }
  /// Makes approaches count from a datum that is further by so much.
  void move_datum(double change) { iteration_.prediction.move_datum(change); }
  /// Must be called when the operators or scales were assembled anew.
  void operators_changed();
  /// Makes the next solve depend on the iterate that it is given alone.
  void forget_all();
  std::size_t bytes() const;

 private:
  void begin_prediction();
  Outcome attempt(bool cold);
  Outcome fall_back();
  Outcome guarded(Outcome outcome);
  bool holds();
  bool beyond_sliding(double by);
  void begin_cold();

  NewtonIteration iteration_;
  Solve solve_;
  std::vector<double> judged_;    ///< pressures that the normal part converged to
  MotionValues judged_motion_{};  ///< motions that it converged to
  bool pressures_found_ = false;  ///< the normal part converged
  bool compared_ = false;         ///< compared with sliding against the loads, in this solve
  FrictionShare slides_;          ///< result of that comparison
};

}  // namespace rollcon
