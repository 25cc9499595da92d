#pragma once
/// A patch of a wheel on a rail as an ordinary contact: its axes, a lattice that follows it, and its solution.

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "contact/contact.hpp"
#include "geometry/velocity.hpp"
#include "wheelrail/contact_search.hpp"

namespace rollcon {

/// Intervals of the lattice along and across the rolling direction.
struct LatticeSize {
  std::int64_t along = 0, across = 0;
  bool operator==(const LatticeSize&) const = default;
};

/// Of the wheel, in the axes of the rail: x forward, y to the right, z down.
struct WheelMotion {
  Pose pose;
  Velocity velocity, rail;
  double speed = 0;  ///< forward, of the wheelset; not 0
};

class PatchContact {
 public:
  /// Bodies: the wheel and the rail with their profiles in place.
  PatchContact(std::shared_ptr<Context> context, std::shared_ptr<Body> wheel, std::shared_ptr<Body> rail);

  /// The overlap is all that presses, less what the surfaces give way under other patches. Warm where the patch was
  /// solved before.
  Status solve(const OverlapPatch& patch, const WheelMotion& motion, double friction, const LatticeSize& size,
               double give_way);
  void reset();
  /// The frame keeps its shape: forces are smooth functions of what is solved next.
  void hold_shape(bool hold) { hold_ = hold; }

  const OverlapPatch& overlap() const { return patch_; }
  Status status() const { return status_; }
  /// Of the contact: origin in the middle of its frame, t1 along the rolling direction, n into the rail.
  const Axes& axes() const { return axes_; }
  /// Force on the wheel, and moment about the patch's reference.
  const Vec3& force() const { return force_; }
  const Vec3& moment() const { return moment_; }
  /// Longitudinal, lateral, spin: of the wheel's surface relative to the rail's at the reference, over the speed
  /// at which both run through the contact, on average.
  const Vec3& creepages() const { return creepages_; }
  /// Origin and axes of its space are axes().
  const std::shared_ptr<Contact>& contact() const { return contact_; }
  /// Times a frame was too small, and was made larger.
  std::int64_t grown() const { return grown_; }

 private:
  void stand(const WheelMotion& motion);
  void lay_frame(const LatticeSize& size);
  FramePlace place();
  int rim_reached(const LatticeSize& size);
  void take_results(const WheelMotion& motion);

  std::shared_ptr<Contact> contact_;
  OverlapPatch patch_;
  double give_way_ = 0;
  Axes axes_;
  LatticeSize size_;
  static constexpr double usual_margin = 1.05;
  std::array<double, 2> margin_{usual_margin, usual_margin};  ///< of the frame over Hertz's ellipse, along and across
  std::array<bool, 2> whole_{};                               ///< the frame holds all of the overlap there
  std::array<std::int64_t, 2> shape_{};                       ///< of the frame, in steps: length over width, shear
  bool hold_ = false;
  std::vector<double> gap_;
  Vec3 force_{}, moment_{}, creepages_{};
  Status status_ = Status::ok;
  std::int64_t grown_ = 0;
};

}  // namespace rollcon
