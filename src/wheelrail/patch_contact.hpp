#pragma once
/// A patch of a wheel on a rail as an ordinary contact: its axes, a lattice that follows it, and its solution.

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "contact/contact.hpp"
#include "geometry/velocity.hpp"
#include "tables/force_table.hpp"
#include "wheelrail/contact_search.hpp"

namespace rollcon {

/// Intervals of the lattice along and across the rolling direction.
struct LatticeSize {
  std::int64_t along = 0, across = 0;
  bool conformal = false;  ///< the lattice follows the profiles across
  bool operator==(const LatticeSize&) const = default;
};

/// Of the wheel, in the axes of the rail: x forward, y to the right, z down.
struct WheelMotion {
  Pose pose;
  Velocity velocity, rail;
  double speed = 0;  ///< forward, of the wheelset; not 0
};

/// Friction of a patch: one coefficient, or those at points across it, linear between.
struct PatchFriction {
  static constexpr std::size_t most = 33;
  double mu = 0;
  std::size_t points = 0;              ///< 0: mu everywhere
  std::array<double, most> lateral{};  ///< from the patch's reference, ascending
  std::array<double, most> at{};
  /// Not null: forces along the surface are what it has for the patch's equivalent ellipse, with mu.
  const ForceTable* table = nullptr;
  /// With a table: the ellipse is that of the overlap, and no pressures are solved for.
  bool hertzian = false;
};

class PatchContact {
 public:
  /// Bodies: the wheel and the rail with their profiles in place.
  PatchContact(std::shared_ptr<Context> context, std::shared_ptr<Body> wheel, std::shared_ptr<Body> rail);

  /// The overlap is all that presses, less what the surfaces give way under other patches. Warm where the patch was
  /// solved before. What a table does not have is solved in full.
  Status solve(const OverlapPatch& patch, const WheelMotion& motion, const PatchFriction& friction,
               const LatticeSize& size, double give_way);
  void reset();
  /// As if it had never been used, counters included.
  void begin_anew() {
    reset();
    now_.grown = 0;
  }
  /// The frame keeps its shape: forces are smooth functions of what is solved next.
  void hold_shape(bool hold) { now_.hold = hold; }

  /// Everything that a later solve or result depends on.
  struct Kept;
  /// Nothing is allocated where the storage has been used.
  void keep(Kept& kept) const;
  void return_to(const Kept& kept);

  /// A place nearby, a step before or behind that of the last solve.
  struct Nearby {
    OverlapPatch patch;
    WheelMotion motion;
    PatchFriction friction;
  };
  /// Derivatives of force and of the moment about the patch's reference.
  struct Rate {
    Vec3 force{}, moment{};
  };
  /// By what steps over this distance are of, from Newton's system at the solution: gap, slip, friction and axes follow
  /// from what is nearby, the frame keeps its place in the axes. The last solution stays. err_state: it did not
  /// converge, or its forces come from a table.
  Rate rate(const Nearby& before, const Nearby& behind, double distance);
  /// By what the surfaces give way.
  Rate rate_of_giving_way() const;

  const OverlapPatch& overlap() const { return now_.patch; }
  Status status() const { return now_.status; }
  /// Of the contact: origin in the middle of its frame, t1 along the rolling direction, n into the rail.
  const Axes& axes() const { return now_.axes; }
  /// Of the wheel in the axes of the rail.
  const Pose& pose() const { return now_.motion.pose; }
  /// Force on the wheel, and moment about the patch's reference.
  const Vec3& force() const { return now_.force; }
  const Vec3& moment() const { return now_.moment; }
  /// Taken by friction.
  double friction_power() const;
  /// Forces along the surface come from a table, not from the contact, which has no friction then.
  bool by_table() const { return now_.by_table; }
  /// Pressures are those of Hertz for the overlap; the contact has no solution then.
  bool hertzian() const { return now_.hertzian; }
  double max_pressure() const;
  double area() const;
  /// Longitudinal, lateral, spin: of the wheel's surface relative to the rail's at the reference, over the speed
  /// at which both run through the contact, on average.
  const Vec3& creepages() const { return now_.creepages; }
  /// Origin and axes of its space are axes().
  const std::shared_ptr<Contact>& contact() const { return contact_; }
  /// E* of the bodies.
  double modulus() const;
  /// Times a frame was too small, and was made larger.
  std::int64_t grown() const { return now_.grown; }

 private:
  /// All of it but the contact.
  struct State {
    OverlapPatch patch;
    double give_way = 0;
    PatchFriction friction;
    WheelMotion motion;
    Axes axes;
    LatticeSize size;
    FramePlace place;
    std::array<double, 2> margin{usual_margin, usual_margin};  ///< of the frame over Hertz's ellipse, along and across
    std::array<bool, 2> whole{};                               ///< the frame holds all of the overlap there
    std::array<std::int64_t, 2> shape{};                       ///< of the frame, in steps: length over width, shear
    bool shaped = false, hold = false;  ///< the frame has had a shape since the last reset; it keeps it
    Vec3 force{}, moment{}, creepages{};
    Status status = Status::ok;
    std::int64_t grown = 0;
    bool by_table = false, hertzian = false;
    double hertzian_pressure = 0, hertzian_area = 0;
    double table_power = 0;       ///< friction's, by the table
    const void* owner = nullptr;  ///< with the number of its solve: tells whether there was one in between
    std::int64_t solves = 0;
  };
  static constexpr double usual_margin = 1.05;

  void prescribe(double give_way, const PatchFriction& friction);
  Axes axes_of(const OverlapPatch& patch) const;
  void lay_axes();
  void stand(const WheelMotion& motion);
  bool take_hertzian_results(const PatchFriction& friction, double give_way);
  void lay_frame(const LatticeSize& size);
  void put_frame(const LatticeSize& size, const FramePlace& place);
  FramePlace place();
  int rim_reached(const LatticeSize& size);
  void read_nearby(const Nearby& nearby, NodeGivens& givens);
  void solve_on_frame(const LatticeSize& size);
  bool take_table_results(const PatchFriction& friction);
  void take_results(const Vec3& force, const Vec3& moment);
  void take_creepages();

  std::shared_ptr<Body> wheel_, rail_;
  std::shared_ptr<Contact> contact_;
  State now_;
  std::int64_t solves_ = 0;  ///< ever
  std::vector<double> gap_;
  std::unique_ptr<Kept> here_;  ///< storage of rate()
};

struct PatchContact::Kept {
  State state;
  Solution solution;
};

}  // namespace rollcon
