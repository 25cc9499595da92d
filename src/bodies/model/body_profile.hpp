#pragma once
/// Holds a profile that a body carries as its surface, and how it lies in the body's axes.

#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/profile_fit.hpp"
#include "geometry/profile_slices.hpp"
#include "geometry/surface.hpp"

namespace rollcon {

enum class ProfilePlace : std::int32_t { none = 0, extruded = 1, revolved = 2 };

struct BodyProfile {
  std::shared_ptr<const ProfileCurve> curve;  ///< null: the body has no profile
  ProfilePlace place = ProfilePlace::none;
  Vec3 origin{0, 0, 0};
  Vec3 axis{1, 0, 0};               ///< unit vector along which it is extruded, or about which it is revolved
  Vec3 z{0, 0, 1};                  ///< unit vector of an extruded profile's z, at a right angle to the axis
  double radius = 0;                ///< radius at z = 0 of a revolved profile
  std::vector<ProfileSlice> slice;  ///< empty: the curve is the profile everywhere
  std::vector<ProfileWave> wave;
  FitReport fit;  ///< what became of the points that were given; files do not have it

  bool varies() const { return !slice.empty() || !wave.empty(); }
  /// Returns the curve, or that of the slice nearest to u = 0.
  const std::shared_ptr<const ProfileCurve>& nominal() const;
};

/// Returns the slices of a profile that varies, which has a place; null: it does not. smooth: see ProfileSlices.
std::shared_ptr<const ProfileSlices> slices_of(const BodyProfile& profile, bool smooth);
/// Makes the surface of a profile that has a place.
std::unique_ptr<Surface> surface_of(const BodyProfile& profile, bool smooth);

/// Throws err_argument where a profile revolved with that radius crosses its axis.
void require_one_side(const ProfileCurve& curve, double radius);

}  // namespace rollcon
