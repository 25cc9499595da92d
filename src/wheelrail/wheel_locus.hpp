#pragma once
/// Finds Wang's contact locus: the point of each circle of a wheel at which its surface can touch a rail, one whose
/// normal has no component along x, as the rail's has none.
///
/// With the wheel's axis a, the radius r and the slope m = dr/dy of its profile, d downwards and f forwards at right
/// angles to a (d has no x), that point is at r (cos t d + sin t f) from the axis, where sin t = m a_x / f_x. Seen
/// along x, the locus is the wheel's outline.

#include <array>
#include <cmath>
#include <optional>

#include "geometry/pose.hpp"
#include "wheelrail/visible_profile.hpp"

namespace rollcon {

struct LocusPoint {
  Vec3 x;
  double slope;      ///< dz/dy of the outline
  double forward_y;  ///< dy of the outline by s
};

/// Holds the wheel's curvatures where it can touch, in the tangent plane of x and across it; convex: positive.
struct LocusCurvature {
  double along, twist, across;
};

/// Says where a wheel is: a point of its axis at y = 0 of the profile, its axis, down and ahead at right angles to it,
/// the radius at z = 0.
struct WheelAxes {
  Vec3 centre, axis, down, ahead;
  double radius;
};

class WheelLocus {
 public:
  /// Makes the locus; axis: unit vector of the wheel's axle in space, its y not negative; centre: point on it where the
  /// profile's y is 0; radius: that of the profile's z = 0.
  WheelLocus(const Vec3& centre, const Vec3& axis, double radius);

  /// Returns nullopt where no point of that circle looks down without a component along x.
  std::optional<LocusPoint> at(const VisiblePoint& p) const;
  /// Finds y, z and slope alone, for scans of all of a profile. Returns false where at() returns nullopt.
  bool outline(double y, double z, double slope, std::array<double, 3>& at) const {
    const double s = slope * tilt_, square = s * s, r = axes_.radius + z;
    if (!(square < most_turned)) return false;
    const double c = std::sqrt(1 - square), e_y = c * axes_.down[1] + s * axes_.ahead[1],
                 e_z = c * axes_.down[2] + s * axes_.ahead[2];
    const double down_z = e_z - slope * axes_.axis[2];
    at = {axes_.centre[1] + y * axes_.axis[1] + r * e_y, axes_.centre[2] + y * axes_.axis[2] + r * e_z,
          -(e_y - slope * axes_.axis[1]) / down_z};
    return down_z > 0;
  }
  LocusCurvature curvature(const VisiblePoint& p) const;
  /// Returns points on the same circle, an arc length behind the locus and ahead of it.
  std::array<Vec3, 2> beside(const VisiblePoint& p, double length) const;
  /// Returns y of the unit vector along the circle.
  double sideways(const VisiblePoint& p) const;
  /// Returns what the circle bends away from its tangent, for small steps along the normal of the wheel's surface.
  double bend(const VisiblePoint& p) const { return 1 / ((axes_.radius + p.z) * std::sqrt(1 + p.slope * p.slope)); }
  /// Returns the rounding of the points.
  double rounding() const { return 1e-16 * (axes_.radius + length(axes_.centre)); }
  const WheelAxes& axes() const { return axes_; }

 private:
  static constexpr double most_turned = 0.9999;  ///< limit beyond which a point runs along the wheel's rim without end

  WheelAxes axes_;
  double tilt_ = 0;  ///< a_x / f_x
};

}  // namespace rollcon
