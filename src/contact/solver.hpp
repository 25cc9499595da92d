#pragma once
/// Solves the scenes of one pair of bodies on the frames that they have, whoever made these.

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

/// Force on body 1 and its moment about the origin, in the axes.
struct Loads {
  Vec3 force{}, moment{};
};

class Solver {
 public:
  Solver(Host host, std::shared_ptr<Body> body1, std::shared_ptr<Body> body2, MakePublished published = nullptr);

  Scene scene;  ///< setters live here
  Host host;

  /// Makes a solver of the same bodies for the same host.
  std::unique_ptr<Solver> another() const;
  /// Makes one of an elastic half-space with this E* and a rigid body, whose caveats nobody hears.
  std::unique_ptr<Solver> make_half_space(double modulus) const;
  /// Takes over everything but the frame from the scene of another solver, and its host.
  void take_over(const Solver& other) {
    scene.take_over(other.scene);
    host = other.host;
  }
  /// Makes one for another thread, on what this one prepared and must not change meanwhile.
  std::unique_ptr<Solver> make_worker() const;
  /// Whether workers can serve several threads at once: not with the systems of published procedures.
  bool can_share() const { return solution_.procedure.standard(); }

  /// Solves the scene, warm from the last solution. Returns ok or a status > 0; throws Error for the rest.
  Status solve();
  /// Solves what is prepared with what is given, from the iterate as it is or, unless warm, from nothing.
  Status solve_given(const Prescribed& given, bool frictionless, bool warm, Monitor& monitor);
  /// Brings everything that depends on the scene up to date; if that fails, nothing but the past is left.
  void prepare();
  /// The bodies where they stand, prepared or not.
  PairOfBodies bodies() const { return {{body1_.get(), body2_.get()}, {scene.pose(0), scene.pose(1)}}; }
  /// The bodies, prepared.
  PairOfBodies pair();
  /// Tells what the tangential loads of the scene take of friction under the pressures of its frame without friction;
  /// nothing where those are not known. Prepares the frame for solve(). Throws Cancelled.
  std::optional<FrictionShare> frictionless_share();
  /// solve() takes the tangential loads of the scene times this.
  void scale_tangential_loads(double factor) { load_factor_ = factor; }

  /// Moves the past on after a solve with this status, if it was a time step and succeeded. The last step can be
  /// repeated.
  void end_step(Status status);
  /// The next step starts from where the last one did. err_state: there was none.
  void repeat_step();
  StepHistory& steps() { return steps_; }
  const StepHistory& steps() const { return steps_; }

  /// Forgets the solution; its tractions may still start the next one.
  void forget();
  /// Forgets all but tractions: the next solve does not depend on how they were found.
  void forget_all_but_tractions();
  /// Forgets warm start, solution and past; keeps the scene and what still fits of the preparation.
  void reset();
  /// Goes back to a copy of solution(), the scene being again what it was of; what the solve took is not brought back.
  void return_to(const Solution& solution);
  /// Both solved frames of one family: results become what they tend to. coarse outlives them.
  void extrapolate_from(Solver& coarse, const FrameFamily& family);

  const Solution& solution() const { return solution_; }
  Derived& derived() { return derived_; }
  Effort& effort() { return effort_; }
  Engine& engine() { return engine_; }
  /// Null before the first solve, and for workers that share theirs.
  Preparation* preparation() { return preparation_.get(); }
  std::size_t bytes() const;

  // Results; err_state where there is no solution of the present frame.
  void require_solution() const;
  Loads loads() const;
  MotionValues motions() const;  ///< by Motion; the approach from no approach on
  /// Derivatives of both. err_state: the last solve did not converge, or a tangential load is prescribed without
  /// friction.
  Rates rates(Parameter parameter);
  /// Derivatives where the givens of the nodes change at such rates and the frame stays. err_state, err_singular,
  /// err_unsupported: as for rates().
  Rates rates(const NodeGivens& rate);
  /// Gap, rigid slip and friction at the nodes of a flat frame as the scene, motions all prescribed, has them now. The
  /// last solution has to be gone back to.
  void read_givens(NodeGivens& now);
  double error_estimate();
  /// Displacements of body 1 or 2 alone.
  const Compliance& compliance_of(std::int32_t body);
  /// The dense operators, where only the monolithic form does without them.
  void require_operators();

  /// Tells the host what it should know of the last solve, which ended with that status.
  void tell(Status status) const;
  /// How many threads the BLAS gets in solves on this frame.
  int blas_threads() const;

 private:
  Status solve_scene(bool& whole);
  Status run(Monitor& monitor);
  void clear();
  void prepare_parts();
  void take_changes();
  void take_friction(bool frictionless);
  const Rates& own_rates(Parameter parameter);
  void require_converged() const;

  std::shared_ptr<Body> body1_, body2_;
  std::shared_ptr<Preparation> preparation_;  ///< null: nothing was prepared, or workers share what was
  Solution solution_;
  Derived derived_;
  Effort effort_;
  Engine engine_;
  RateFinder rate_finder_;
  StepHistory steps_;
  std::unique_ptr<FrictionlessShare> frictionless_share_;  ///< made when it is asked for
  std::optional<double> early_;                            ///< seconds that preparing took before the solve
  double load_factor_ = 1;                                 ///< on tangential loads, of a frame maker
  Solver* coarser_ = nullptr;                              ///< that the last results were extrapolated from
};

}  // namespace rollcon
