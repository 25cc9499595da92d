#pragma once
/// Holds one pair of bodies in rolling contact: scene in, solution out.

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
#include "geometry/rectangle.hpp"
#include "support/error.hpp"

namespace rollcon {

struct CaseList;       // contact/cases/solve_many.hpp
struct CaseResults;    // contact/cases/solve_many.hpp
class Solver;          // contact/solver.hpp
class StressesInside;  // contact/results/stresses.hpp
class WearLaw;         // contact/laws/wear_law.hpp

/// Solves contacts whose frame nobody gave, on frames that it makes (src/framing/).
class FrameMaker {
 public:
  virtual ~FrameMaker() = default;
  /// Gives solver.scene frames and solves it on them. Returns and throws what Solver::solve does.
  virtual Status solve(Solver& solver) = 0;
  /// Forgets warm starts and the start of a time step.
  virtual void reset() = 0;
  /// Ends or repeats a time step, as Solver's functions of these names do.
  virtual void end_step(Status status) = 0;
  virtual void repeat_step() = 0;
  /// Gives the solver's scene the regular frame of a time step.
  virtual void lay(Solver& solver, const Rectangle& sides, std::int64_t along, std::int64_t across) = 0;
};
using MakeFrameMaker = std::unique_ptr<FrameMaker> (*)();

class Contact {
 public:
  /// Takes makers of published procedures (null: the build has none) and of frames (null: the scene has one).
  Contact(std::shared_ptr<Context> context, std::shared_ptr<Body> body1, std::shared_ptr<Body> body2,
          MakePublished published = nullptr, MakeFrameMaker frames = nullptr);
  ~Contact();

  const std::unique_ptr<Solver> solver;  ///< solves on the frame that the scene has; not null
  Scene& scene;                          ///< solver's scene, where setters live

  /// Takes the faces of body `which` (1 or 2) with a tag for the frame, as they are now. err_state: the body has no
  /// mesh; err_argument: no such faces.
  void frame_from_body(std::int32_t which, std::int32_t tag);

  void set_progress(ProgressFunction function, void* user);
  /// Stops the solve that is running, if one is. Any thread may call it.
  void request_cancel() noexcept;
  /// Forgets requests from before a solve; solve() does this itself.
  void forget_cancel();

  /// Solves the scene, warm from the last solution. Returns ok or a status > 0; throws Error for the rest.
  Status solve();
  /// Makes a contact of the same bodies and scene, without a frame, on one thread and silent, for use by another
  /// thread. This contact has to outlive it and can cancel it.
  std::unique_ptr<Contact> make_worker() const;
  /// Solves the scene with some of what is prescribed replaced, case by case and over threads. Returns the worst status
  /// of the cases (see worse()). The scene stays, and so does the last solution unless something was set since.
  Context& context() const;
  Status solve_many(const CaseList& cases, const CaseResults& results);
  /// Forgets warm start, solution, iteration log and the start of a time step; keeps the scene and the caches that
  /// still fit.
  void reset();
  /// Makes the next time step start from where the last one did. err_state: there was none.
  void repeat_step();
  /// Returns how many numbers, with a header and a checksum, hold what the next time step starts from, and copies them
  /// if capacity is at least that. err_capacity: it is less, but not 0; err_state: no step was made, or the library's
  /// frame changes from step to step.
  std::int64_t past_get(std::int64_t capacity, double* past) const;
  /// Restores what past_get() copied. err_argument: numbers of another kind or frame, and then nothing changes.
  void past_set(std::int64_t n, const double* past);

  // Results of the last solve: err_state before one, err_capacity (naming the need) when too small.
  std::int64_t nodes() const { return scene.mesh().nodes(); }  ///< nodes of the frame given so far; no solve is needed
  std::int64_t elements() const { return scene.mesh().elements(); }
  void tractions(InAxes axes, std::int64_t capacity, double* t) const;  // capacity in nodes
  /// Returns the number of doubles of a field (3, 2 or 1 per node); copies them if capacity is at least that.
  std::int64_t field(Field field, InAxes axes, std::int64_t capacity, double* v) const;
  void node_status(std::int64_t capacity, std::int32_t* status) const;  ///< numbers of NodeStatus
  void resultant(InAxes axes, double* force, double* moment) const;     ///< on body 1, about the axes' origin
  /// Returns approach, creepages and tilts, which are rotations about t1 and t2. Any pointer may be null.
  void motion(double* approach, double* creep, double* tilts = nullptr) const;
  /// Returns the derivatives of what resultant(local) and motion() give; any pointer may be null. err_state: the last
  /// solve did not converge, or a tangential load is prescribed without friction.
  void sensitivity(Parameter parameter, double* force, double* moment, double* approach, double* creep) const;
  /// Returns displacements of body 1 or 2 at any points of the contact surface, given as (t1, t2) pairs; on a curved
  /// frame they are in the local directions there.
  void displacements_at(std::int32_t body, std::int64_t n, const double* xy, double* u) const;
  /// Returns three displacements and six stresses at each point inside body 1 or 2; either may be null. Points and
  /// results are in the body's axes, or in (t1, t2, n). err_argument: a point is outside; err_unsupported: a rigid
  /// body.
  void fields_at(std::int32_t body, bool in_body, std::int64_t n, const double* xyz, double* u, double* stress) const;
  // Fields of body 1 or 2 follow, in its axes, under the contact's tractions and its own loads. err_unsupported: it is
  // not of finite or boundary elements.

  /// Returns the largest value of a measure of stress inside a half-space, and its place in the axes. See
  /// rollcon_contact_find_stress.
  double find_stress(std::int32_t body, const char* measure, std::span<const double> parameter, Vec3& place) const;
  /// Copies the displacements of all nodes and returns how many numbers they are; null: copies nothing.
  std::int64_t body_displacements(std::int32_t body, double* u) const;
  /// Returns the power that a viscoelastic section loses in each harmonic, from 0 on. err_unsupported: it is another
  /// body.
  std::vector<double> body_power(std::int32_t body) const;
  /// Writes the body's elements and fields, those of a block of a half-space, as a VTU file. err_io.
  void write_body(std::int32_t body, const char* path) const;
  /// Writes the forces of the last solution on the body's nodes, see nodal_loads and write_loads.
  void write_loads(std::int32_t body, const char* path) const;
  /// Adds worn volumes as add_wear() (contact/results/wear.hpp) does.
  double wear(const WearLaw& law, std::span<const double> y, double share, double* volume) const;
  /// Returns the least and the greatest t2 of nodes in contact; without contact the first is above the second.
  std::array<double, 2> contact_across() const;
  /// Returns the surface temperatures of both bodies at points (t1, t2). See rollcon_contact_get_temperatures_at.
  void temperatures_at(std::int64_t n, const double* xy, double* temperature) const;
  /// Returns Ekberg, Kabo and Andersson's index of surface fatigue. err_state: no normal force.
  double fatigue_index(double shear_yield) const;
  /// Returns the Hertzian contact that stands for this one.
  EquivalentEllipse equivalent_ellipse() const;
  double stat(const char* name) const;  ///< err_option: unknown name
  /// Returns the iteration log in rows of 8: phase, iteration, normal residual, tangential residual, step length, nodes
  /// in contact, nodes in slip, seconds.
  std::span<const double> history() const;
  /// Returns the error function Psi of each row of history().
  std::span<const double> error_function() const;
  std::string plan() const;            ///< text of describe_plan()
  void write(const char* path) const;  ///< VTU; err_io

 private:
  friend class OwnFramesSolver;
  Status solve_unless_cancelled();
  SurfaceState surface_state(std::int32_t body, bool loads_alone) const;
  StressesInside stresses_inside(std::int32_t body) const;
  Status solve_on_own_frames(const CaseList& cases, const CaseResults& results);
  const Body& body(std::int32_t which) const { return which == 1 ? *body1_ : *body2_; }

  std::shared_ptr<Body> body1_, body2_;
  std::atomic<bool> cancel_{false};
  MakeFrameMaker make_frames_ = nullptr;
  std::unique_ptr<FrameMaker> frames_;  ///< null until the contact makes a frame
};

}  // namespace rollcon
