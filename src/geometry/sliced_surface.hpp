#pragma once
/// Makes surfaces of bodies from profiles that vary along a straight line or round an axis.

#include <memory>

#include "geometry/profile_slices.hpp"
#include "geometry/surface.hpp"

namespace rollcon {

/// Says where a varying profile lies: along a line, where u is the length from the origin, or round an axis, where u is
/// the angle from e_z towards axis x e_z.
struct SlicesPlace {
  bool revolved = false;
  Vec3 origin{0, 0, 0}, axis{1, 0, 0}, e_z{0, 0, 1};  ///< unit vectors at right angles
  double radius = 0;                                  ///< radius at z = 0 of a revolved profile
};

class SlicedSurface final : public Surface {
 public:
  SlicedSurface(std::shared_ptr<const ProfileSlices> slices, const SlicesPlace& place)
      : slices_(std::move(slices)), place_(place), third_(cross(place.axis, place.e_z)) {}

  std::optional<double> distance(const Vec3& from, const Vec3& direction, const Vec3& facing) const override;
  std::optional<double> distance_near(const Vec3& from, const Vec3& direction, const Vec3& facing,
                                      SurfaceHint& hint) const override;
  std::optional<Vec3> normal(const Vec3& from, const Vec3& direction, const Vec3& facing) const override;
  Vec3 normal_met(const Vec3& met, const Vec3& direction, const SurfaceHint& hint) const override;
  Vec3 nearest(const Vec3& point) const override;
  std::array<double, 2> extent(const Vec3& direction) const override;

 private:
  struct Point {
    Vec3 x, u, v;
  };
  struct Hit {
    double t;
    SurfaceHint at;  ///< branch: sheet; parameter: column; place: u
  };
  Point at(std::size_t sheet, double u, double v) const;
  double place_of(const Vec3& point) const;
  Vec3 normal_at(const SurfaceHint& at) const;
  std::optional<Hit> meet(const Vec3& from, const Vec3& direction) const;
  std::optional<Hit> near(const Vec3& from, const Vec3& direction, const SurfaceHint& start) const;

  std::shared_ptr<const ProfileSlices> slices_;
  SlicesPlace place_;
  Vec3 third_;  ///< direction of y of an extruded profile with the sign reversed; of angles of a revolved one
};

/// Returns a point of the section at u; share: 0 to 1 through the sheets that are there, in the order of features.
Vec2 section_of(const ProfileSlices& slices, double u, double share);

}  // namespace rollcon
