#pragma once
/// One pair of bodies in rolling contact: scene in, solution out.

#include <array>
#include <atomic>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bodies/body.hpp"
#include "contact/results/equivalent_ellipse.hpp"
#include "contact/scene/enumerators.hpp"
#include "contact/scene/procedure.hpp"
#include "contact/scene/scene.hpp"
#include "support/error.hpp"

namespace rollcon {

struct CaseHost;       // contact/cases/solve_many.hpp
struct CaseList;       // contact/cases/solve_many.hpp
struct KeptSolution;   // contact/kept_solution.hpp
struct CaseResults;    // contact/cases/solve_many.hpp
struct FrictionShare;  // contact/newton/friction_limit.hpp
struct FrameFamily;    // contact/results/extrapolation.hpp
class KnownGap;        // contact/scene/known_gap.hpp
struct NodeGivens;     // contact/solution.hpp
struct Rates;          // contact/solution.hpp
class WearLaw;         // contact/laws/wear_law.hpp
struct SolverState;    // solution, caches and workspaces; contact/solution.hpp

class Contact;

/// Solves contacts whose frame nobody gave, on frames that it makes (src/framing/).
class FrameMaker {
 public:
  virtual ~FrameMaker() = default;
  /// As Contact::solve.
  virtual Status solve(Contact& contact) = 0;
  /// Forgets warm starts, and what was before a time step.
  virtual void reset() = 0;
  /// As Contact's.
  virtual void end_step(Status status) = 0;
  virtual void repeat_step() = 0;
};
using MakeFrameMaker = std::unique_ptr<FrameMaker> (*)();

class Contact {
 public:
  /// published: makes the published procedures; null where the build has none. frames: null: the scene has one.
  Contact(std::shared_ptr<Context> context, std::shared_ptr<Body> body1, std::shared_ptr<Body> body2,
          MakePublished published = nullptr, MakeFrameMaker frames = nullptr);
  ~Contact();

  Scene scene;  ///< setters live here

  /// Takes the faces of body `which` (1 or 2) with a tag for the frame, as they are now. err_state: the body has no
  /// mesh; err_argument: no such faces.
  void frame_from_body(std::int32_t which, std::int32_t tag);

  void set_progress(ProgressFunction function, void* user);
  /// Stops the solve that is running, if one is. Any thread.
  void request_cancel() noexcept { cancel_->store(true); }
  /// Requests from before a solve do not count; solve does this itself, solve_on_frame does not.
  void forget_cancel() { cancel_->store(false); }

  /// Returns ok or a status > 0; throws Error for the rest. Warm start from the last solution.
  Status solve();
  /// The same, but requests to stop that came before count.
  Status solve_unless_cancelled();
  /// The same on the scene's frame, whoever made it; for frame makers.
  Status solve_on_frame();
  /// After a solve, whose status is given: what a time step starts from moves on if it was one and succeeded. solve()
  /// does this itself, solve_on_frame does not.
  void end_step(Status status);
  /// Whether a solve with this status leaves a state that a step can start from.
  static bool is_answer(Status status);
  /// The next time step starts from where the last one did. err_state: there was none.
  void repeat_step();
  /// What the next time step starts from, as numbers with a header and a checksum; returns how many. Copies if capacity
  /// >= that, else err_capacity; none are wanted where capacity is 0. err_state: the library makes the frame.
  std::int64_t save_past(std::int64_t capacity, double* past) const;
  /// Back to that, on the same frame. err_argument: these are not such numbers, or of another frame; all stays then.
  void restore_past(std::int64_t n, const double* past);
  /// Of the same bodies, for solve_on_frame() as part of a solve of this contact, which outlives it.
  std::unique_ptr<Contact> make_follower() const;
  /// Of the same bodies and scene, without a frame, on one thread and silent; for another thread. This outlives it.
  std::unique_ptr<Contact> make_twin() const;
  /// Likewise, of an elastic half-space with this E* and a rigid body; it logs no warning.
  std::unique_ptr<Contact> make_half_space(double modulus) const;
  /// Takes over everything but the frame from the scene of the lead.
  void follow(const Contact& lead);
  /// Both are solved on frames of one family: results become what they tend to. coarse outlives them.
  void extrapolate_from(const Contact& coarse, const FrameFamily& family);
  /// What the tangential loads of the scene take of friction under the pressures of its frame without friction; nothing
  /// where those are not known. Prepares the frame for solve_on_frame(). Throws Cancelled.
  std::optional<FrictionShare> frictionless_share();
  /// solve_on_frame() takes the tangential loads of the scene times this.
  void scale_tangential_loads(double factor) { load_factor_ = factor; }
  /// err_load, with what friction cannot carry.
  [[noreturn]] void refuse_loads(const FrictionShare& share) const;
  /// E* and Dundurs' beta of the pair; prepare the bodies.
  double modulus();
  double dundurs_beta();
  bool knows_gap_between_nodes() const;
  /// As known_gap(); prepares the bodies.
  std::unique_ptr<KnownGap> gap_between_nodes();
  /// Whether one of the bodies has a mesh.
  bool meshed() const;
  /// Half-spaces, one perhaps rigid, and no mesh: Hertz's solution holds.
  bool half_spaces() const;
  /// Whether what ends over the contact deforms there: all surfaces are meshes of elastic bodies.
  bool surfaces_deform() const;
  /// As the statistic error_estimate of the last solve.
  double error_estimate() const;
  /// Somebody asked this solve to stop.
  bool cancelled() const noexcept { return cancel_->load(); }
  void log(LogLevel level, const char* text) const;
  void caveat(Status status, const char* text) const;  ///< see Context::caveat
  /// Tells what a caller should know of the last solve, which ended with that status. solve() does this itself,
  /// solve_on_frame does not.
  void tell(Status status) const;
  /// Solves the scene with some of what is prescribed replaced, case by case and over threads. Returns the worst status
  /// of the cases (see worse()). The scene stays, and so does the last solution unless something was set since.
  Status solve_many(const CaseList& cases, const CaseResults& results);
  /// The next solve on a frame depends on the scene and the last tractions alone, not on how they were found.
  void forget_all_but_tractions();
  /// The last solution on a frame; nothing is allocated where the storage has been used.
  void keep(KeptSolution& kept) const;
  /// Back to it, the scene being again what it was of; counters and history are not brought back.
  void return_to(const KeptSolution& kept);
  /// Forgets warm start, solution, history and what was before a time step; keeps the scene and the caches that still
  /// fit.
  void reset();

  // Results of the last solve; err_state before one, err_capacity (naming the need) when too small.
  std::int64_t nodes() const;  ///< frame nodes given so far; no solve needed
  std::int64_t elements() const;
  void tractions(InAxes axes, std::int64_t capacity, double* t) const;  // capacity in nodes
  /// Number of doubles of a field (3, 2 or 1 per node); copies if capacity >= that.
  std::int64_t field(Field field, InAxes axes, std::int64_t capacity, double* v) const;
  void node_status(std::int64_t capacity, std::int32_t* status) const;
  void resultant(InAxes axes, double* force, double* moment) const;
  /// tilts: rotations about t1 and t2. Any pointer may be null.
  void motion(double* approach, double* creep, double* tilts = nullptr) const;
  /// Derivatives of what resultant(local) and motion() give; any pointer may be null. err_state: the last solve did not
  /// converge, or a tangential load is prescribed without friction.
  void sensitivity(Parameter parameter, double* force, double* moment, double* approach, double* creep) const;
  /// Gap, rigid slip and friction at the nodes of a flat frame as the scene, motions all prescribed, has them now. The
  /// last solution has to be gone back to (return_to()).
  void read_givens(NodeGivens& now);
  /// Derivatives of the last solution's force and moment (local axes) where these givens change at such rates and the
  /// frame stays. err_state, err_singular, err_unsupported: as sensitivity().
  void rates_by_givens(const NodeGivens& rate, double* force, double* moment) const;
  /// Displacement of body 1 or 2 at any points of the contact surface, by (t1, t2) pairs; on a curved frame in the
  /// local directions there.
  void displacements_at(std::int32_t body, std::int64_t n, const double* xy, double* u) const;
  /// Inside body 1 or 2, a half-space, at points (t1, t2, n): six stresses and three displacements a point; either may
  /// be null. See rollcon_contact_get_stresses_at.
  void stresses_at(std::int32_t body, std::int64_t n, const double* xyz, double* stress, double* u) const;
  // Of body 1 or 2, of finite or boundary elements, in its axes: under the contact's tractions and the body's own
  // loads. err_unsupported: another kind.

  /// Displacements of all nodes. Returns how many numbers they are; null: no more than that.
  std::int64_t body_displacements(std::int32_t body, double* u) const;
  /// Three displacements and six stresses at each point; either may be null. err_argument: a point is outside.
  void body_fields_at(std::int32_t body, std::int64_t n, const double* xyz, double* u, double* stress) const;
  /// Its elements and fields as a VTU file. err_io.
  void write_body(std::int32_t body, const char* path) const;
  /// See add_wear, after which it is named.
  double wear(const WearLaw& law, std::span<const double> y, double share, double* volume) const;
  /// Least and greatest t2 of nodes in contact; the first above the second where there is none.
  std::array<double, 2> contact_across() const;
  /// Of the surfaces of both bodies at points (t1, t2). See rollcon_contact_get_temperatures_at.
  void temperatures_at(std::int64_t n, const double* xy, double* temperature) const;
  /// Ekberg, Kabo and Andersson's index of surface fatigue. err_state: no normal force.
  double fatigue_index(double shear_yield) const;
  /// The Hertzian contact that stands for this one.
  EquivalentEllipse equivalent_ellipse() const;
  double stat(const char* name) const;  ///< err_option: unknown name
  /// A statistic of the last solve.
  double number(double (*statistic)(SolverState&)) const { return statistic(*state_); }
  std::size_t bytes() const;
  static std::int64_t stat_count();
  static const char* stat_name(std::int64_t i);
  /// Rows of 8: phase, iteration, normal residual, tangential residual, step length, nodes in contact, nodes in slip,
  /// seconds.
  std::span<const double> history() const;
  /// Error function Psi of each row of history().
  std::span<const double> error_function() const;
  std::string plan() const;
  void write(const char* path) const;  ///< VTU; err_io

 private:
  void require_solution() const;
  SurfaceState surface_state(std::int32_t body) const;
  Status solve_scene();
  Status solve_on_own_frames(const CaseList& cases, const CaseResults& results, const CaseHost& host);
  const Rates& rates(Parameter parameter) const;
  void clear_state();
  /// Prepares what a solution stands on; if that fails, all of the state is gone.
  void prepare_or_clear();
  /// How many threads the BLAS gets in solves on this frame.
  int blas_threads() const;

  std::shared_ptr<Context> context_;
  std::shared_ptr<Body> body1_, body2_;
  std::unique_ptr<SolverState> state_;
  ProgressFunction progress_ = nullptr;
  void* progress_user_ = nullptr;
  std::atomic<bool> cancel_here_{false};
  std::atomic<bool>* cancel_ = &cancel_here_;  ///< the lead's, if there is one
  double load_factor_ = 1;                     ///< on tangential loads, of a frame maker
  bool quiet_ = false;                         ///< statuses are for a frame maker alone
  MakeFrameMaker make_frames_ = nullptr;
  std::unique_ptr<FrameMaker> frames_;  ///< made when a frame is
  const Contact* coarser_ = nullptr;    ///< that the last results were extrapolated from
};

}  // namespace rollcon
