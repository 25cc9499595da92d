#pragma once
/// Solves scenes of one pair of bodies on the frames that they have, whoever made these.

#include <memory>
#include <optional>

#include "contact/derived.hpp"
#include "contact/effort.hpp"
#include "contact/host.hpp"
#include "contact/newton/frictionless_share.hpp"
#include "contact/prepare/preparation.hpp"
#include "contact/problem/past.hpp"
#include "contact/results/sensitivity.hpp"
#include "contact/scene/scene.hpp"
#include "contact/settle/solve_prepared.hpp"
#include "contact/solution.hpp"

namespace rollcon {

struct FrameFamily;  // contact/results/extrapolation.hpp

/// Holds the force on body 1 and its moment about the origin, in the contact's axes.
struct Loads {
  Vec3 force{}, moment{};
};

/// Knows derivatives of what was solved on a frame that moves with the contact.
class MovingFrame {
 public:
  virtual ~MovingFrame() = default;
  /// Returns false where it does not know them; errors are those of Solver::rates().
  virtual bool rates(Parameter parameter, Rates& found) = 0;
};

class Solver {
 public:
  Solver(Host host, std::shared_ptr<Body> body1, std::shared_ptr<Body> body2, MakePublished published = nullptr);

  Scene scene;  ///< setters live here
  Host host;

  /// Makes a solver of the same bodies for the same host.
  std::unique_ptr<Solver> another() const;
  /// Makes a solver of an elastic half-space with this E* on a rigid body, or where a body creeps of half-spaces of the
  /// bodies' own materials at the scene's speed; its caveats go to nobody.
  std::unique_ptr<Solver> make_half_space(double modulus) const;
  /// Takes over the host, and everything but the frame from the scene, of another solver.
  void take_over(const Solver& other) {
    scene.take_over(other.scene);
    host = other.host;
  }
  /// Makes a solver for another thread; it uses what this one prepared, which must not change meanwhile.
  std::unique_ptr<Solver> make_worker() const;
  /// Says whether workers can serve several threads at once; they cannot with the systems of published procedures.
  bool can_share() const { return solution_.procedure.standard(); }

  /// Solves the scene, warm from the last solution. Returns ok or a status > 0; throws Error for the rest.
  Status solve();
  /// Prepares the scene, and returns the iterate that the next solve starts from, for the caller to fill in: tractions
  /// at the nodes, and motions, of which the approach counts from the problem's datum. seconds: time that finding them
  /// took, which the solve counts, too. Throws Cancelled.
  Iterate& start(double seconds);
  /// Takes derivatives of the last solution from a frame that moves with the contact and outlives it.
  void follow(MovingFrame& frame) { moving_ = &frame; }
  /// Solves what is prepared with these givens, from the present iterate or, unless warm, from nothing.
  Status solve_given(const Prescribed& given, bool frictionless, bool warm, Monitor& monitor);
  /// Brings everything that depends on the scene up to date; if that fails, nothing but the time step's start is left.
  void prepare();
  /// Returns the bodies where they stand, prepared or not.
  PairOfBodies bodies() const { return {{body1_.get(), body2_.get()}, {scene.pose(0), scene.pose(1)}}; }
  /// Prepares the bodies and returns them where they stand.
  PairOfBodies pair();
  /// Returns how much of friction the tangential loads of the scene use under the pressures of its frame without
  /// friction; nothing where those are not known. Prepares the frame for solve(). Throws Cancelled.
  std::optional<FrictionShare> frictionless_share();
  /// Makes solve() multiply the tangential loads of the scene by this factor.
  void scale_tangential_loads(double factor) { load_factor_ = factor; }

  /// Makes a time step that succeeded with this status the start of the next one; repeat_step() takes that back.
  void end_step(Status status);
  /// Makes the next step start from where the last one did. err_state: there was none.
  void repeat_step();
  StepHistory& steps() { return steps_; }
  const StepHistory& steps() const { return steps_; }

  /// Forgets the solution; its tractions may still start the next one.
  void forget();
  /// Forgets all but tractions, so that the next solve does not depend on how they were found.
  void forget_all_but_tractions();
  /// Forgets warm start, solution and past steps; keeps the scene and what still fits of the preparation.
  void reset();
  /// Goes back to a copy of solution(); the scene has to be again what it was then. Times and counts stay.
  void return_to(const Solution& solution);
  /// Replaces the results by what they and those of a coarser frame of the same family tend to; coarse outlives them.
  void extrapolate_from(Solver& coarse, const FrameFamily& family);

  const Solution& solution() const { return solution_; }
  Derived& derived() { return derived_; }
  Effort& effort() { return effort_; }
  Engine& engine() { return engine_; }
  /// Returns null before the first solve, and in workers, which use another solver's.
  Preparation* preparation() { return preparation_.get(); }
  std::size_t bytes() const;

  // Results follow; they throw err_state where the present frame has no solution.
  void require_solution() const;
  Loads loads() const;
  MotionValues motions() const;  ///< indexed by Motion; the approach counts from the gap as given
  /// Returns the derivatives of loads and motions. err_state: the last solve did not converge, or a tangential load is
  /// prescribed without friction.
  Rates rates(Parameter parameter);
  /// Returns the derivatives where the nodes' givens change at these rates and the frame stays. Errors: those of
  /// rates() and err_unsupported.
  Rates rates(const NodeGivens& rate);
  /// Reads gap, rigid slip and friction at the nodes of a flat frame from the scene, whose motions are all prescribed.
  /// The caller has to go back to the last solution afterwards.
  void read_givens(NodeGivens& now);
  double error_estimate();
  /// Returns the compliance of body 1 or 2 alone.
  const Compliance& compliance_of(std::int32_t body);
  /// Returns the power that a section loses by creeping in each harmonic, from 0 on.
  std::vector<double> power_lost(std::int32_t body);
  /// Makes the dense operators where they are missing, as in the monolithic form.
  void require_operators();

  /// Notes as caveats what the context should hear about the last solve, which ended with that status.
  void tell(Status status) const;
  /// Returns how many threads the BLAS gets in solves on this frame.
  int blas_threads() const;

 private:
  Status solve_scene(bool& whole);
  void clear();
  void prepare_parts();
  void take_changes();
  void take_friction(bool frictionless);
  const Rates& own_rates(Parameter parameter);
  void require_converged() const;

  std::shared_ptr<Body> body1_, body2_;
  std::shared_ptr<Preparation> preparation_;  ///< null: nothing was prepared, or a worker uses another solver's
  Solution solution_;
  Derived derived_;
  Effort effort_;
  Engine engine_;
  RateFinder rate_finder_;
  StepHistory steps_;
  std::unique_ptr<FrictionlessShare> frictionless_share_;  ///< made when it is asked for
  std::optional<double> early_;                            ///< seconds that preparing took before the solve
  double load_factor_ = 1;                                 ///< factor on the tangential loads, set by a frame maker
  MovingFrame* moving_ = nullptr;                          ///< null: the frame stays where it is
  Solver* coarser_ = nullptr;                              ///< solver whose results the last extrapolation used
};

}  // namespace rollcon
