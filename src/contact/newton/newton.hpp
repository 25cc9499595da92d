#pragma once
/// Exact semismooth Newton iteration for frictional rolling contact (docs/theory.md, section 6)
/// with a non-monotone line search and fallbacks.

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "contact/linear/linear_solver.hpp"
#include "contact/linear/reduced_system.hpp"
#include "contact/newton/friction_limit.hpp"
#include "contact/newton/prediction.hpp"
#include "contact/newton/total_sliding.hpp"
#include "contact/problem/problem.hpp"
#include "contact/scene/procedure.hpp"

namespace rollcon {

/// What one iteration looked like; residuals are relative to the largest pressure and to the
/// largest tangential traction.
struct StepRecord {
  Part part = Part::normal;
  std::int64_t iteration = 0;
  double residual_normal = 0, residual_tangential = 0;
  double merit = 0;  ///< error function Psi: half the squared norm of the relative residuals
  double step = 0;
  std::int64_t contact = 0, sliding = 0;
};

/// Told of every iteration; true asks to stop.
struct Monitor {
  virtual ~Monitor() = default;
  virtual bool step(const StepRecord& record) = 0;
  /// True once a stop was asked for; of work that has no iterations to tell of.
  virtual bool cancelled() const { return false; }
};

enum class Outcome { converged, not_converged, cancelled, no_contact, no_solution };

/// What is tried where the full step gets stuck.
enum class Rung {
  approach_of_pressures,  ///< a bracket of the approach, for the normal part alone
  cold,                   ///< a warm start left for a cold one
  bracket_creep,
  relax,
  search_creep,
  bracket_approach,
  rescale_slip,
  friction_from_above,
  alternate,
  friction_from_below,
};
inline constexpr std::size_t rungs = 10;

struct NewtonReport {
  Outcome outcome = Outcome::not_converged;
  std::int64_t normal_iterations = 0, tangential_iterations = 0, full_iterations = 0;
  double residual_normal = 0, residual_tangential = 0;
  double residual_load = 0;  ///< greatest relative error of a prescribed load
  FrictionShare share;       ///< where the loads were found to be beyond friction
  std::int64_t fallbacks = 0;
  std::array<std::int64_t, rungs> saved{};  ///< solves (parts) that a rung brought to its end
  std::int64_t refuted = 0;        ///< successes of a part that the last guard did not let pass
  std::int64_t predictions = 0;    ///< parts that began from a predicted iterate
  std::int64_t sliding_steps = 0;  ///< of total sliding; 0: the scene did not give that

  /// Iterations of an earlier part of the same solve.
  void add(const NewtonReport& earlier) {
    normal_iterations += earlier.normal_iterations;
    tangential_iterations += earlier.tangential_iterations;
    full_iterations += earlier.full_iterations;
    fallbacks += earlier.fallbacks;
    for (std::size_t k = 0; k < rungs; ++k) saved[k] += earlier.saved[k];
    refuted += earlier.refuted;
    predictions += earlier.predictions;
    sliding_steps += earlier.sliding_steps;
  }
};

class Newton {
 public:
  LinearSolver linear;
  Procedure procedure;           ///< tolerances of the linear systems
  bool predict = true;           ///< warm starts look along the line of the last change
  bool look_for_sliding = true;  ///< total sliding needs no linear systems

  /// Solves from the given iterate (all zero: cold start; the approach is then guessed when the
  /// load is a force). frictionless: mu is zero at every node.
  /// The problem's scales, friction and loads are changed by fallbacks and restored on return.
  NewtonReport solve(Problem& problem, Iterate& iterate, bool frictionless, double tolerance,
                     std::int64_t max_iterations, Monitor& monitor);
  /// The part whose convergence ends a solve: all unknowns at once unless the normal problem stands
  /// alone.
  static Part goal(const Problem& problem, bool frictionless);
  /// The system of a part linearised at a solution, for its rates. The laws' own[i][2] is mu e_i at
  /// sliding nodes even where pressures are given.
  ReducedSystem& linearise(Problem& problem, Iterate& iterate, Part part);
  /// The next iterate is not one that this class found.
  void forget_prediction() { prediction_.forget(); }
  /// Approaches count from a datum that is further by so much.
  void move_datum(double change) { prediction_.move_datum(change); }
  /// To be called when the operators or scales were assembled anew.
  void operators_changed() {
    operators_changed_ = true;
    sliding_.operators_changed();
    prediction_.forget();
    linear.forget();
  }
  std::size_t bytes() const;

 private:
  struct Residual {
    double normal = 0, tangential = 0, load = 0;          ///< relative maxima
    double normal_rounding = 0, tangential_rounding = 0;  ///< what rounding leaves of them
    double merit = 0;
    double pressure = 0, traction = 0;  ///< the largest
    std::int64_t contact = 0, sliding = 0;
    double worst(Part part) const;
    /// Within the tolerance, or within what rounding leaves.
    bool within(Part part, double tolerance) const;
  };

  /// Of what gaps and slips are summed from.
  static constexpr double rounding_of_terms = 8 * std::numeric_limits<double>::epsilon();

  Outcome run(Part part, double tolerance, std::int64_t max_iterations, std::int64_t& iterations);
  Outcome fall_back(double tolerance, std::int64_t max_iterations);
  Outcome guarded(Outcome outcome, double tolerance, std::int64_t max_iterations);
  bool holds(double tolerance);
  Residual normal_laws();
  void start_anew();
  Outcome bracket_creep(double tolerance, std::int64_t max_iterations);
  Outcome search_creep(double tolerance, std::int64_t max_iterations);
  Outcome bracket_approach(Part part, double tolerance, std::int64_t max_iterations);
  Outcome bracket(int motion, Part part, double from, double scale, double tolerance,
                  std::int64_t max_iterations);
  double creep_scale(int motion) const;
  Outcome rescale_slip(double tolerance, std::int64_t max_iterations);
  Outcome alternate(double tolerance, std::int64_t max_iterations);
  Outcome relax(double tolerance, std::int64_t max_iterations);
  void sweep_along_flow();
  Outcome continue_in_friction(bool from_above, double tolerance, std::int64_t max_iterations);
  bool beyond_friction(Part part, std::int64_t iteration, double residual_normal);
  bool beyond_sliding(double by);
  FrictionShare slide_against_loads();
  void remember_best(Part part, double worst);
  void return_to_best();
  std::int64_t& iterations_of(Part part) {
    return part == Part::normal       ? report_.normal_iterations
           : part == Part::tangential ? report_.tangential_iterations
                                      : report_.full_iterations;
  }
  Residual evaluate(Part part);
  void begin_prediction();
  bool start_predicted(Part part);
  void freeze_other_part(Part part);
  void take_step_field(Part part);
  TangentialLaw law_of(Part part, std::int32_t node, bool bound_follows) const;
  bool take_product(Part part);
  bool newton_step(Part part, double forcing);
  void advance(Part part, double alpha);
  double line_search(Part part, double merit);
  double trial_merit(Part part, double alpha) const;
  double load_residual(Part part, double alpha) const;
  void fit_approach();
  void reserve(std::size_t nodes);
  Outcome attempt(bool cold, double tolerance, std::int64_t max_iterations);

  Problem* problem_ = nullptr;
  Iterate* iterate_ = nullptr;
  Monitor* monitor_ = nullptr;
  NewtonReport report_;
  Part goal_ = Part::normal;  ///< the part whose convergence ends the solve
  struct {
    double worst = 0, residual_normal = 0, residual_tangential = 0, residual_load = 0;
    std::vector<double> lambda[3];
    std::array<double, 4> motion{};
  } best_;
  std::vector<double> judged_;  ///< pressures that the normal part converged to
  double judged_approach_ = 0;  ///< likewise
  std::int64_t iterations_left_ = 0;
  bool compared_ = false;  ///< with sliding against the loads, in this solve
  FrictionShare slides_;   ///< what that gave

  TotalSliding sliding_;
  Prediction prediction_;
  double prediction_ratio_ = 0;  ///< 0: none (any more) in this solve
  ReducedSystem system_;
  std::vector<std::int32_t> active_;
  std::vector<std::uint8_t> is_active_;
  std::vector<double> frozen_[3];  ///< images of the tractions that the current part holds fixed
  bool has_frozen_ = false;
  bool images_fresh_ = false;  ///< from a step of this run
  std::vector<double> next_[3], next_image_[3];
  std::array<double, 4> next_motion_{};
  std::vector<double> known_[3], b_, x_, correction_, jx_, product_;
  std::vector<double> merits_;
  bool pressures_found_ = false;  ///< the normal part converged
  bool continuing_ = false;       ///< the problem is not yet the one to be solved
  bool stick_first_ = false;      ///< the next step takes every node with friction for sticking
  int free_steps_ = 0;            ///< steps still to be taken without line search
  double pressure_scale_ = 1, traction_scale_ = 1;
  bool operators_changed_ = true;
};

}  // namespace rollcon
