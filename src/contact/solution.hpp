#pragma once
/// What one contact keeps between calls: caches keyed by the scene's revisions, the solution, and statistics.

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bodies/pair.hpp"
#include "contact/heat/flash_temperature.hpp"
#include "contact/newton/frictionless_share.hpp"
#include "contact/newton/newton.hpp"
#include "contact/problem/past.hpp"
#include "contact/problem/problem.hpp"
#include "contact/problem/settled_friction.hpp"
#include "contact/scene/enumerators.hpp"
#include "contact/scene/procedure.hpp"
#include "contact/scene/scene.hpp"
#include "mesh/lattice.hpp"
#include "mesh/vec3.hpp"

namespace rollcon {

struct Timings {
  double compliance = 0, convection = 0, newton = 0, linear = 0, total = 0;
};

/// Work done since the contact was made.
struct Work {
  std::int64_t bodies = 0;       ///< prepared by a solve of this contact
  std::int64_t frames = 0;       ///< weights, axes, normals
  std::int64_t compliances = 0;  ///< of the pair
  std::int64_t stencils = 0;     ///< of the convective scheme
  std::int64_t gaps = 0, frictions = 0, slips = 0, scales = 0;
  std::int64_t applications = 0;                                        ///< of the compliance, without rows
  std::int64_t fields = 0, laws = 0, displacements = 0, estimates = 0;  ///< asked for
};

/// Relative, and of the forces that go with the motions of the solution.
struct ErrorEstimate {
  bool known = false;
  double normal = 0;      ///< normal force, over itself
  double tangential = 0;  ///< tangential force, over the integral of |tangential traction|
  double tractions = 0;   ///< L2 norm; of pressures or of tangential tractions, whichever is worse
  double seconds = 0;     ///< what finding it took

  /// NaN where either is.
  double worst() const { return tangential <= normal || normal != normal ? normal : tangential; }
};

/// What results on two frames of a family tend to (contact/results/extrapolation.hpp).
struct Extrapolated {
  Vec3 force{}, moment{};  ///< on body 1, about the origin, in the axes
  MotionValues motion{};   ///< by Motion; the approach from no approach on
  double area = 0;         ///< in contact
  double left_over = 0;    ///< of the difference of the frames, by which the finer one is off
};

/// Derivatives of results (contact/results/sensitivity.hpp), per unit of a parameter, in the axes.
struct Rates {
  Vec3 force{}, moment{};  ///< on body 1, about the origin
  MotionValues motion{};   ///< by Motion
};

/// What scene, poses and velocities prescribe at the nodes of a frame, or how fast that changes.
struct NodeGivens {
  std::vector<double> gap;      ///< at the approach that is prescribed
  std::vector<double> slip[2];  ///< rigid slip over speed, motions included
  std::vector<double> mu;
};

struct Sensitivities {
  static constexpr std::size_t parameters = 7;
  std::array<bool, parameters> known{};  ///< by Parameter, minus one
  std::array<Rates, parameters> rates{};

  // Work done since the last solve.
  std::int64_t right_sides = 0, factorizations = 0, linear_iterations = 0;
  double seconds = 0;

  // Storage kept for the next.
  std::vector<double> lambda[3];  ///< rates of the tractions
  std::vector<double> gap, slip[2], bound[2], b, x;

  void forget();
  void reserve(std::size_t nodes);
};

struct SolverState;

/// One of the published procedures (src/procedures/), which solves in place of Newton's iteration.
class PublishedSolver {
 public:
  virtual ~PublishedSolver() = default;
  /// Solves the prepared scene from state.iterate; fills the report and counters of the last solve. Throws Error as the
  /// systems of the steps do.
  virtual void run(SolverState& state, const Options& options, Monitor& monitor) = 0;
  virtual std::size_t bytes() const = 0;
};

/// What a solve stands on: made from the scene by prepare(), not changed by a solve, shared by the cases of a list.
struct Prepared {
  Frame frame;
  FrameSource frame_source;  ///< as far as the body still has these faces
  bool placed = false;       ///< a frame at a place of its own, which solves may change
  bool in_steps = false;     ///< likewise, its shapes are a few that come again
  FramePlace place;
  bool ends_at_edge = false;               ///< the contact covers the frame, nodes on its rim carry nothing
  PairOfBodies pair;                       ///< where the bodies stood
  std::shared_ptr<Compliance> compliance;  ///< of the pair
  std::array<MeshOnFrame, 2> meshes;
  double bears = INFINITY;  ///< length, thickness or radius, of which an approach makes sense up to the half
  double accuracy = 0;
  Scheme scheme = Scheme::characteristic;
  /// From displacements of the bodies without any contact traction; empty: none.
  std::vector<double> offset_depth, offset_slip[2];
  /// The frame as a regular grid; nothing: see no_lattice.
  std::optional<Lattice> lattice;
  std::string no_lattice;  ///< why there is none: a clause
  bool table = false;      ///< dense rows are copied from a table of one node's influence
  Problem problem;
  double speed = 1;     ///< slip velocity per unit of slip: V, or 1 / dt in a time step
  double distance = 0;  ///< that material travels in a time step
  StepKind step = StepKind::steady;
  BothHeats heat;
};

/// What was prepared before a solve, in the same call of the caller.
struct PreparedAhead {
  bool known = false;
  Work work_before;
  std::int64_t assemblies_before = 0;
  Timings timings;
  double seconds = 0;
};

struct Preparation;  // contact/prepare/preparation.hpp

struct SolverState {
  Work work;
  std::shared_ptr<const Prepared> prepared;  ///< null: nothing was prepared yet
  /// Makes it; null where it is shared.
  std::shared_ptr<Preparation> preparation;
  std::unique_ptr<Compliance> body_compliance[2];  ///< made when displacements are asked for
  bool frictionless = false;

  Prescribed given;
  Iterate iterate;
  StepHistory steps;
  SettledFriction settled_friction;  ///< where friction follows the whole solution
  Newton newton;
  MakePublished make_published = nullptr;                 ///< null: they are not part of this build
  std::unique_ptr<FrictionlessShare> frictionless_share;  ///< made when it is asked for
  PreparedAhead ahead;
  double load_factor = 1;                             ///< on the tangential loads of the last solve
  std::unique_ptr<PublishedSolver> published;         ///< made when one is asked for
  mutable std::vector<std::uint8_t> edge_of_contact;  ///< workspace of nodes_inside()
  bool images_known = false;                          ///< of the solution, at all nodes, slip included

  // The last solve.
  bool solved = false;
  std::int64_t number = 0;    ///< no other solution in this process has it
  int threads = 1;            ///< that the BLAS had
  Revisions revision_solved;  ///< of the scene, when the last solve read it
  std::int64_t options_solved = -1;
  bool settled = false;  ///< caches are whole: nothing was interrupted
  bool warm_usable = false;
  Outcome outcome = Outcome::not_converged;
  NewtonReport report;
  Timings timings;
  Procedure procedure;
  std::vector<double> history;                            ///< rows of 8
  std::vector<double> merit;                              ///< error function of each row
  std::int64_t system_unknowns = 0, system_nonzeros = 0;  ///< of the last linear system
  std::int64_t assemblies = 0;
  std::int64_t assemblies_before = 0;  ///< the last solve
  Work work_before;
  std::size_t peak_bytes = 0;
  std::int64_t linear_iterations = 0, factorizations = 0, right_sides = 0;  ///< of the last solve

  // Computed when asked for.
  bool derived = false;
  std::vector<double> slip[2];  ///< slip velocity
  std::vector<double> gap;      ///< deformed gap
  std::vector<std::int32_t> status;
  Sensitivities sensitivities;
  ErrorEstimate error_estimate;
  std::optional<Extrapolated> extrapolated;
  bool laws_checked = false;
  std::array<double, 4> laws{};  ///< normal, friction, slip, equilibrium

  std::size_t bytes() const;
};

/// Forgets all that is known of the last solution; its tractions may still start the next one.
void forget_solution(SolverState& state);
/// As the first solve with them does. Throws Error naming the body.
void prepare_bodies(SolverState& state, Body& body1, Body& body2);
/// Brings everything that depends on the scene up to date; only what changed is done again.
void prepare(SolverState& state, const Scene& scene, Body& body1, Body& body2, int threads);
/// The dense operators, which the monolithic form leaves out: for what needs them after a solve.
void require_operators(SolverState& state);

/// Solves the prepared scene from state.iterate; fills report and counters. Throws Error as the linear systems do.
void solve_prepared(SolverState& state, const Options& options, Monitor& monitor);

/// err_load if a frictionless problem prescribes what only friction can carry.
void refuse_tangential_loads(const Prescribed& given);
/// err_load if a normal load and moments act beside the nodes of a flat frame.
void refuse_load_beside_frame(const SolverState& state);
/// err_argument, with the node, where the gaps and motions of the prepared scene go beyond what double precision can
/// calculate with.
void refuse_overflow(const SolverState& state);
/// Of the outcome; err_load where there is no steady solution.
Status status_of(const SolverState& state);
/// Nodes in contact on the rim of the frame.
std::int64_t nodes_at_rim(const SolverState& state);

/// Fills slip, gap and status of the last solution.
void derive_fields(SolverState& state);
/// Deformed gap of the last solution alone, at every node.
void derive_gap(SolverState& state, double* gap);

/// Recomputes the residuals of every law from matrix-free displacements, independently of the solver's operators:
/// complementarity, friction bound, slip direction, loads; each relative.
void check_laws(SolverState& state);

std::string describe_plan(const SolverState& state, const Scene& scene, const Body& body1, const Body& body2);

}  // namespace rollcon
