#pragma once
/// Makes surfaces of bodies from profiles: moved along a straight line, or turned about an axis. They have no inside:
/// their normals look where those of the contact do, and the nearest point on a line counts.

#include <memory>

#include "geometry/profile_curve.hpp"
#include "geometry/surface.hpp"

namespace rollcon {

/// Holds the points origin + y e_y + z e_z + any multiple of `along`, with along, e_y, e_z right-handed.
class ExtrudedProfile final : public Surface {
 public:
  /// Takes unit vectors at right angles.
  ExtrudedProfile(std::shared_ptr<const ProfileCurve> curve, const Vec3& origin, const Vec3& along, const Vec3& e_z)
      : curve_(std::move(curve)), origin_(origin), along_(along), y_(cross(e_z, along)), z_(e_z) {}

  std::optional<double> distance(const Vec3& from, const Vec3& direction, const Vec3& facing) const override;
  std::optional<double> distance_near(const Vec3& from, const Vec3& direction, const Vec3& facing,
                                      SurfaceHint& hint) const override;
  std::optional<Vec3> normal(const Vec3& from, const Vec3& direction, const Vec3& facing) const override;
  Vec3 normal_met(const Vec3& met, const Vec3& direction, const SurfaceHint& hint) const override;
  Vec3 nearest(const Vec3& point) const override;
  std::array<double, 2> extent(const Vec3& direction) const override;
  std::optional<Vec3> endless() const override { return along_; }

 private:
  struct Hit {
    double t;
    ProfilePoint point;
    SurfaceHint at;
  };
  std::optional<Hit> meet(const Vec3& from, const Vec3& direction) const;

  std::shared_ptr<const ProfileCurve> curve_;
  Vec3 origin_, along_, y_, z_;
};

/// Holds the points at y along the axis from the origin and radius + z away from it. The profile stays on one side of
/// the axis.
class RevolvedProfile final : public Surface {
 public:
  /// Takes a unit vector as axis.
  RevolvedProfile(std::shared_ptr<const ProfileCurve> curve, const Vec3& origin, const Vec3& axis, double radius)
      : curve_(std::move(curve)), origin_(origin), axis_(axis), radius_(radius) {}

  std::optional<double> distance(const Vec3& from, const Vec3& direction, const Vec3& facing) const override;
  std::optional<double> distance_near(const Vec3& from, const Vec3& direction, const Vec3& facing,
                                      SurfaceHint& hint) const override;
  std::optional<Vec3> normal(const Vec3& from, const Vec3& direction, const Vec3& facing) const override;
  Vec3 normal_met(const Vec3& met, const Vec3& direction, const SurfaceHint& hint) const override;
  Vec3 nearest(const Vec3& point) const override;
  std::array<double, 2> extent(const Vec3& direction) const override;

 private:
  struct Hit {
    double t;
    ProfilePoint point;
    SurfaceHint at;
  };
  std::optional<Hit> meet(const Vec3& from, const Vec3& direction, const Vec3& facing) const;
  /// Returns the unit vector away from the axis.
  Vec3 outward(const Vec3& point) const;

  std::shared_ptr<const ProfileCurve> curve_;
  Vec3 origin_, axis_;
  double radius_;
};

}  // namespace rollcon
