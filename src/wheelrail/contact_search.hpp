#pragma once
/// Where a wheel meets a rail that is extruded along x: from profiles and the wheel's pose to patches in which the
/// undeformed surfaces overlap. Lengths are in any unit; axes of the field: x forward, y to the right, z down, the rail
/// on the right. For one on the left the caller mirrors.

#include <memory>
#include <optional>
#include <vector>

#include "geometry/pose.hpp"
#include "wheelrail/overlap_patch.hpp"
#include "wheelrail/profile_gap.hpp"

namespace rollcon {

/// A profile that is revolved: see RevolvedProfile. In the wheel's own axes.
struct WheelShape {
  std::shared_ptr<const ProfileCurve> curve;
  Vec3 centre{0, 0, 0};  ///< on the axis, at y = 0 of the profile
  Vec3 axis{0, 1, 0};    ///< of the profile's y; its z points away from it
  double radius = 0;     ///< of z = 0
};

/// A profile that is extruded along x: see ExtrudedProfile. In the axes of the track.
struct RailShape {
  std::shared_ptr<const ProfileCurve> curve;
  Vec3 origin{0, 0, 0};
  Vec3 along{1, 0, 0};  ///< or (-1, 0, 0), which mirrors the profile
  Vec3 down{0, 0, 1};   ///< of the profile's z, at right angles to it
};

/// Where a rigid wheel touches first.
struct TouchPoint {
  double gap = 0;    ///< how far it may sink until then
  Vec3 x{};          ///< on the rail
  double angle = 0;  ///< of the rail there: atan dz/dy
  double wheel_y = 0, rolling_radius = 0;
};

class ContactSearch {
 public:
  /// Prepares the profiles. Throws err_argument.
  ContactSearch(const WheelShape& wheel, const RailShape& rail);

  /// How far the wheel, its body axes in this pose, may sink along z until it touches the rail; negative where they
  /// overlap, infinite where it is not above the rail. To rounding.
  double first_touch(const Pose& wheel) const;
  /// The point that does; nullopt where it is not above the rail. Of several, or a line, the first by y.
  std::optional<TouchPoint> touch(const Pose& wheel) const;
  /// In the order of y; overwritten. planar: each has one normal. Allocates nothing once it has seen as many patches.
  void find(const Pose& wheel, std::vector<OverlapPatch>& patch, bool planar = true);
  /// Of the rail at y (where it ends: there): atan dz/dy.
  double rail_angle(double y) const;

 private:
  WheelLocus locus_of(const Pose& wheel) const;

  WheelShape shape_;
  double side_;  ///< -1: the profile's y points to the left
  VisibleProfile wheel_, rail_;
  std::vector<Overlap> overlap_;
};

}  // namespace rollcon
