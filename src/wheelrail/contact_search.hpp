#pragma once
/// Finds where a wheel meets a rail that runs along x, or a roller: from profiles and the wheel's pose to patches in
/// which the undeformed surfaces overlap. Lengths are in any unit; axes: x forward, y to the right, z down, the rail on
/// the right. For one on the left the caller mirrors.

#include <memory>
#include <optional>
#include <vector>

#include "geometry/pose.hpp"
#include "wheelrail/overlap_patch.hpp"
#include "wheelrail/profile_gap.hpp"

namespace rollcon {

/// Holds a profile that is revolved (see RevolvedProfile), in the wheel's own axes.
struct WheelShape {
  std::shared_ptr<const ProfileCurve> curve;
  Vec3 centre{0, 0, 0};  ///< point of the axis at y = 0 of the profile
  Vec3 axis{0, 1, 0};    ///< direction of the profile's y; its z points away from the axis
  double radius = 0;     ///< radius of the profile's z = 0
  std::shared_ptr<const ProfileSlices> slices = nullptr;  ///< null: the same all round
};

/// Holds a profile that is extruded along x (see ExtrudedProfile), or revolved, in the axes of the track.
struct RailShape {
  std::shared_ptr<const ProfileCurve> curve;
  Vec3 origin{0, 0, 0};
  Vec3 along{1, 0, 0};                                    ///< (-1, 0, 0) mirrors the profile
  Vec3 down{0, 0, 1};                                     ///< direction of the profile's z, at right angles to `along`
  std::shared_ptr<const ProfileSlices> slices = nullptr;  ///< null: the same all along
  std::optional<double> roller = std::nullopt;            ///< z of the axis along y about which it is revolved
};

/// Tells where a rigid wheel touches first.
struct TouchPoint {
  double gap = 0;    ///< way that the wheel may sink until then
  Vec3 x{};          ///< point of the rail
  double angle = 0;  ///< inclination of the rail there: atan dz/dy
  double wheel_y = 0, rolling_radius = 0;
};

class ContactSearch {
 public:
  /// Prepares the profiles. Throws err_argument.
  ContactSearch(const WheelShape& wheel, const RailShape& rail);

  /// Returns how far the wheel, its body axes in this pose, may sink along z until it touches the rail; negative where
  /// they overlap, infinite where it is not above the rail. Exact to rounding.
  /// along: place of a rail that varies, or distance from a roller's axis, where x is 0.
  double first_touch(const Pose& wheel, double along = 0) const;
  /// Returns the point that touches, the first by y of several or of a line; nullopt where none is above the rail.
  std::optional<TouchPoint> touch(const Pose& wheel, double along = 0) const;
  /// Finds patches in the order of y, overwriting `patch`. Once it has seen as many
  /// patches it allocates nothing.
  void find(const Pose& wheel, std::vector<OverlapPatch>& patch, const MergeRule& rule = {}, double along = 0);
  /// Returns how the wheel's profile varies; null: it does not.
  const ProfileSlices* wheel_slices() const { return shape_.slices.get(); }
  /// Returns the inclination of the rail at y (where it ends: there): atan dz/dy.
  double rail_angle(double y) const;

 private:
  /// Calls use(gap) with the gap of the wheel in this pose.
  template <class Use>
  auto with_gap(const Pose& wheel, double along, Use use) const;

  WheelShape shape_;
  double side_;                   ///< -1: the profile's y points to the left
  std::optional<double> roller_;  ///< see RailShape
  VisibleProfile wheel_, rail_;
  std::optional<SliceHeights> wheel_heights_, rail_heights_;
  std::vector<Overlap> overlap_;
};

}  // namespace rollcon
