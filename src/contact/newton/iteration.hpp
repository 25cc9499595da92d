#pragma once
/// Iterates by an exact semismooth Newton method for frictional rolling contact (docs/theory.md, section 6) with a
/// non-monotone line search, on one part of a problem that it does not change; each run is given what is prescribed.

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "contact/linear/linear_solver.hpp"
#include "contact/linear/reduced_system.hpp"
#include "contact/newton/prediction.hpp"
#include "contact/newton/report.hpp"
#include "contact/problem/law_residual.hpp"
#include "contact/problem/problem.hpp"
#include "contact/scene/procedure.hpp"

namespace rollcon {

/// Holds one solve: what it works on, what it may still spend, and what came of it so far.
struct Solve {
  const Problem* problem = nullptr;
  Iterate* iterate = nullptr;
  Monitor* monitor = nullptr;
  Prescribed given;
  Part goal = Part::normal;  ///< part whose convergence ends the solve
  double tolerance = 0;
  std::int64_t max_iterations = 0;   ///< limit of one run
  std::int64_t iterations_left = 0;  ///< iterations left for all runs
  NewtonReport report;
};

/// Tells how a run differs from the standard one.
struct RunSettings {
  double tolerance = 0;             ///< 0: the solve's
  std::int64_t max_iterations = 0;  ///< 0: the solve's
  int free_steps = 0;               ///< number of first steps that are taken without line search
  bool stick_first = false;         ///< the first step takes every node with friction for sticking
  bool rehearsal = false;           ///< what is prescribed is not yet what is asked: no best iterate is noted
};

class NewtonIteration {
 public:
  LinearSolver linear;
  Procedure procedure;  ///< tolerances of the linear systems
  Prediction prediction;
  double prediction_ratio = 0;  ///< 0: none (any more) in this solve

  /// Begins a solve, which must outlive its runs.
  void begin(Solve& solve);
  Outcome run(Part part, const Prescribed& given, const RunSettings& settings = {});
  /// Returns the residuals; also finds the active nodes and makes the images that the next step needs valid.
  LawResidual evaluate(Part part, const Prescribed& given);
  /// Returns residuals of the part's laws alone: the active nodes stay those of the part that was solved last.
  LawResidual judge(Part part, const Prescribed& given);
  /// Goes back to the best iterate of the runs that were no rehearsal; to a cold start where there is none and the
  /// iterate is not finite.
  void return_to_best();
  void forget_best() { best_.worst = std::numeric_limits<double>::infinity(); }
  /// Returns the tractions of the best iterate, or else of the present one.
  const std::vector<double> (&best_tractions() const)[3];
  /// Returns the system of a part linearised at a solution, for its rates. The laws' own[i][2] is mu e_i at sliding
  /// nodes even where pressures are given.
  ReducedSystem& linearise(const Problem& problem, const Prescribed& given, const Iterate& iterate, Part part);
  /// Tells that scaled rows are others than at the last step.
  void rows_changed() {
    rows_changed_ = true;
    linear.forget();
  }
  Solve& solve() { return *solve_; }
  std::size_t bytes() const;

 private:
  struct Best {
    double worst = 0, residual_normal = 0, residual_tangential = 0, residual_load = 0;
    std::vector<double> lambda[3];
    MotionValues motion{};
  };

  void remember_best(double worst);
  std::optional<Outcome> touch_again(Part part, std::int64_t iteration);
  double forcing_of(std::int64_t iteration, const LawResidual& residual, double worst, double tolerance);
  bool beyond_friction(Part part, std::int64_t iteration, double residual_normal);
  void fit_approach();
  bool start_predicted(Part part);
  void freeze_other_part(Part part);
  TangentialLaw law_of(Part part, std::int32_t node, bool bound_follows) const;
  bool take_product(Part part);
  bool newton_step(Part part, bool stick, double forcing);
  void take_step(Part part);
  void advance(Part part, double alpha);
  double line_search(Part part, bool free);
  double trial_merit(Part part, double alpha) const;
  double load_error_at(Part part, double alpha) const;
  void reserve(std::size_t nodes);

  Solve* solve_ = nullptr;
  const Problem* problem_ = nullptr;
  Iterate* iterate_ = nullptr;
  const Prescribed* given_ = nullptr;  ///< givens of the present run

  ReducedSystem system_;
  std::vector<std::int32_t> active_, listed_;  ///< listed: nodes whose images are asked for
  std::vector<std::uint8_t> is_active_;
  LawScales scales_;
  std::vector<double> frozen_[3];  ///< images of the tractions that the current part holds fixed
  bool has_frozen_ = false;
  bool images_fresh_ = false;  ///< images come from a step of this run
  std::vector<double> next_[3], next_image_[3];
  MotionValues next_motion_{};
  std::vector<double> known_[3], b_, x_, correction_, jx_, product_;
  std::vector<double> merits_;
  double last_worst_ = 0, last_merit_ = 0, eta_ = 0;  ///< values of the step before
  bool rows_changed_ = true;
  Best best_;
};

}  // namespace rollcon
