#pragma once
/// Solves a patch of a wheel on a rail: its axes, strips that fit it, and its solution as that of an ordinary contact.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "contact/contact.hpp"
#include "framing/step_frames.hpp"
#include "framing/strip_frames.hpp"
#include "geometry/velocity.hpp"
#include "tables/force_table.hpp"
#include "wheelrail/contact_search.hpp"
#include "wheelrail/hertzian_patch.hpp"
#include "wheelrail/patch_calibration.hpp"
#include "wheelrail/patch_past.hpp"

namespace rollcon {

struct NodeGivens;  // contact/derived.hpp

/// Holds intervals of the lattice along and across the rolling direction.
struct LatticeSize {
  std::int64_t along = 0, across = 0;
  bool conformal = false;  ///< the lattice follows the profiles across
  bool operator==(const LatticeSize&) const = default;
};

/// Says how finely a patch is solved: on strips that fit it, or on a lattice where these do not.
struct Fineness {
  strips::StripCounts strips;  ///< 0: a lattice is wanted
  strips::StripCounts finer;   ///< what those that do not fit give way to
  LatticeSize lattice;
  bool patient = true;  ///< strips are sought from all starts
};

/// Describes the wheel's motion in the axes of the rail: x forward, y to the right, z down.
struct WheelMotion {
  Pose pose;
  Velocity velocity, rail;
  double speed = 0;           ///< forward speed of the contact
  double onward = 0;          ///< speed at which the contact moves on over the rail's material; not 0
  bool by_creepages = false;  ///< slip is that of the creepages at the reference of each patch
  double along = 0;           ///< place of a rail that varies, or distance from a roller's axis, where x is 0
};

/// Returns the speed at which both surfaces run through a patch, on average, along its direction forwards.
double speed_through(const OverlapPatch& patch, const WheelMotion& motion);

/// Holds the friction of a patch: a law with one greatest coefficient, or those at points across it, linear between.
struct PatchFriction {
  static constexpr std::size_t most = 33;
  std::shared_ptr<const FrictionGiven> law;  ///< null: none
  double mu = 0;
  std::size_t points = 0;              ///< 0: mu everywhere
  std::array<double, most> lateral{};  ///< distances from the patch's reference, ascending
  std::array<double, most> at{};
  /// Table of forces along the surface, for the patch's calibrated ellipse with mu; null: they are solved for.
  const ForceTable* table = nullptr;
  PatchCalibration calibration{};
  double trust = 0;  ///< weight of the table's results; the others are solved for
  /// The table's ellipse is that of the overlap, and no pressures are solved for.
  bool hertzian = false;
};

/// Says what step in time a patch is solved for.
struct PatchStep {
  StepKind kind = StepKind::steady;
  double dt = 0, accuracy = 0;
  std::shared_ptr<const WheelPast> past;  ///< start of the step; null where it is steady
};

/// Holds the bodies that take the place of a wheel and a rail as half-spaces, and their poses in the axes of these.
struct WholeBodies {
  std::array<std::shared_ptr<Body>, 2> body;
  std::array<Pose, 2> place{};
};

class PatchContact {
 public:
  /// Takes the wheel and the rail as bodies with their profiles in place. whole: see solve_whole(); null: they are all.
  PatchContact(std::shared_ptr<Context> context, std::shared_ptr<Body> wheel, std::shared_ptr<Body> rail,
               const WholeBodies* whole = nullptr);
  PatchContact(PatchContact&& other) noexcept;
  ~PatchContact();

  /// Solves with the overlap as approach, less what the surfaces give way under other patches. Starts warm where the
  /// patch was solved before, which does not show in the results. What a table does not have is solved in full.
  Status solve(const OverlapPatch& patch, const WheelMotion& motion, const PatchFriction& friction,
               const Fineness& fineness, double give_way, const PatchStep& step = {});
  /// Returns what the last solve, a step in time, leaves.
  PatchPast past() const;
  /// Returns what the last solve, a steady one, is on the regular grid of a step; solves it there.
  PatchPast steady_past(double accuracy);
  /// Solves the contact of the whole bodies under a normal force, about where solve() found the half-spaces, on a frame
  /// that fits it. The results are this contact's then. Starts from nothing. alone: no other patch is near, and the
  /// frame may be an automatic one; else it is a lattice over the overlap.
  Status solve_whole(double normal, bool alone);
  /// Returns how much farther than the overlap the whole bodies have come together along the normal.
  double farther() const { return now_.farther; }
  /// Returns how far the forces of solve_whole() move the bodies apart at another patch, along its normal.
  double parts(const OverlapPatch& there) const;
  void reset();  ///< forgets everything solved before

  /// Holds everything that a later solve or result depends on.
  struct Kept;
  /// Copies the state, without allocating where the storage has been used.
  void keep(Kept& kept) const;
  void return_to(const Kept& kept);

  /// Holds a place nearby, a step before or behind that of the last solve.
  struct Nearby {
    OverlapPatch patch;
    WheelMotion motion;
    PatchFriction friction;
  };
  /// Holds derivatives of force and of the moment about the patch's reference.
  struct Rate {
    Vec3 force{}, moment{};
  };
  /// Returns derivatives by what the steps over this distance change, from Newton's system at the solution: gap, slip,
  /// friction and axes follow from what is nearby. Strips move with the contact; a lattice keeps its place in the axes.
  /// The last solution stays. err_state: it did not converge, or its forces come from a table.
  Rate rate(const Nearby& before, const Nearby& behind, double distance);
  /// Finds how a table's ellipse follows from the patch, for a wheel that rolls forward; nullopt where the patch has
  /// two parts, is cut or has no strips. Nothing solved before counts.
  std::optional<PatchCalibration> calibration(const OverlapPatch& patch, WheelMotion motion, const ForceTable& table);
  /// Returns derivatives by what the surfaces give way.
  Rate rate_of_giving_way();

  const OverlapPatch& overlap() const { return now_.patch; }
  Status status() const { return now_.status; }
  /// Returns the contact's axes: origin in the middle of its frame, t1 along the rolling direction, n into the rail.
  const Axes& axes() const { return now_.axes; }
  /// Returns the pose of the wheel in the axes of the rail.
  const Pose& pose() const { return now_.motion.pose; }
  /// Return the force on the wheel, and its moment about the patch's reference.
  const Vec3& force() const { return now_.force; }
  const Vec3& moment() const { return now_.moment; }
  /// Returns the power that friction takes.
  double friction_power() const;
  /// Says whether forces along the surface come from a table, not from the contact, which then has no friction.
  bool by_table() const { return now_.by_table; }
  /// Says whether pressures are those of Hertz for the overlap; the contact then has no solution.
  bool hertzian() const { return now_.hertzian; }
  double max_pressure() const;
  double area() const;
  /// Returns longitudinal, lateral and spin creepage of the wheel's surface relative to the rail's at the reference,
  /// over the speed at which both run through the contact, on average.
  const Vec3& creepages() const { return now_.creepages; }
  /// Returns the contact with its solution at nodes, which is made when it is asked for; origin and axes of its space
  /// are axes().
  const std::shared_ptr<Contact>& contact() const;
  /// Says whether others hold the contact, who are to see its solution.
  bool held() const { return contact_.use_count() > 1; }
  /// Says whether results are those of the whole bodies.
  bool whole() const { return now_.whole; }
  /// Gives the contact its solution; returns what Solver::solve() does.
  Status show() const;
  /// Forgets requests to cancel.
  void forget_cancel() { contact_->forget_cancel(); }
  /// Returns E* of the bodies.
  double modulus() const;
  /// Says whether the last solve sought strips and did not find them.
  bool unfit() const { return unfit_; }

 private:
  /// Holds all of the patch but the contact.
  struct State {
    OverlapPatch patch;
    double give_way = 0;
    PatchFriction friction;
    WheelMotion motion;
    Axes axes;
    LatticeSize lattice;  ///< size that was asked for
    FramePlace place;
    PatchStep step;
    RectangleCells cells;    ///< grid of a step in time
    bool on_strips = false;  ///< strips fit the patch; the contact is solved when it is asked for
    Vec3 force{}, moment{}, creepages{};
    Vec3 arm{};  ///< from the reference to the centre of the table's ellipse
    Status status = Status::ok;
    bool by_table = false, hertzian = false;
    bool whole = false;              ///< solve_whole() has solved last
    bool alone = true;               ///< what it was told
    double normal = 0, farther = 0;  ///< force that it was given, and what it found
    double hertzian_pressure = 0, hertzian_area = 0;
    double table_power = 0;       ///< power of friction by the table
    const void* owner = nullptr;  ///< tells, with the number of the owner's solve, whether there was one in between
    std::int64_t solves = 0;
  };
  void prescribe(double give_way, const PatchFriction& friction);
  Axes axes_of(const OverlapPatch& patch) const;
  Vec3 middle() const;
  void lay_axes();
  void place_bodies(Scene& scene, const std::array<Pose, 2>& place) const;
  void give_friction(Scene& scene) const;
  Contact& solved() const { return now_.whole ? *whole_ : *contact_; }
  void stand(const WheelMotion& motion);
  Velocity flat_velocity() const;
  bool take_hertzian_results(const PatchFriction& friction, double give_way);
  static void put_frame(Scene& scene, const LatticeSize& size, const FramePlace& place, bool given);
  FramePlace place(bool whole) const;
  Rectangle box() const;
  void stand_nearby(const Nearby& nearby);
  Loads found_loads() const;
  void solve_contact(const Fineness& fineness);
  bool solve_on_strips(const Fineness& fineness);
  void solve_step();
  StepContact step_contact(double accuracy) const;
  bool solve_law_on_strips();
  bool by_law() const { return now_.on_strips && strips_->by_law(); }
  bool take_table_results(const PatchFriction& friction);
  bool find_missing(const ForceTable& table, EquivalentEllipse e, PatchCalibration& c);
  bool take_table_forces(const PatchFriction& friction, const HertzianPatch& h, double load);
  void take_results(const Vec3& force, const Vec3& moment);
  void take_creepages();

  std::shared_ptr<Body> wheel_, rail_;
  std::shared_ptr<Contact> contact_;
  std::shared_ptr<Contact> whole_;  ///< null: there are half-spaces alone
  std::array<Pose, 2> whole_place_{};
  State now_;
  std::unique_ptr<StripFrames> strips_;
  StepFrames frames_;                                   ///< makes grids of steps in time
  std::shared_ptr<const WheelPast> begun_;              ///< start of the step that was tried last
  GridFrame past_frame_;                                ///< grid of that start
  bool unfit_ = false;                                  ///< what unfit() says
  mutable bool shown_ = false;                          ///< the contact has the solution on strips at its nodes
  std::unique_ptr<std::array<StripGivens, 2>> nearby_;  ///< storage of rate()
  std::int64_t solves_ = 0;                             ///< solves so far, resets included
  std::unique_ptr<Kept> here_;                          ///< storage of rate()
};

}  // namespace rollcon
