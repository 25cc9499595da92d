#include "bodies/model/body_profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "geometry/profile_surface.hpp"
#include "geometry/sliced_surface.hpp"
#include "support/error.hpp"

namespace rollcon {

const std::shared_ptr<const ProfileCurve>& BodyProfile::nominal() const {
  const ProfileSlice* nearest = nullptr;
  for (const ProfileSlice& s : slice)
    if (!nearest || std::abs(s.u) < std::abs(nearest->u)) nearest = &s;
  return nearest ? nearest->curve : curve;
}

std::shared_ptr<const ProfileSlices> slices_of(const BodyProfile& p, bool smooth) {
  if (!p.varies()) return nullptr;
  const bool round = p.place == ProfilePlace::revolved;
  const double turn = 2 * std::numbers::pi;
  double most = 0;
  for (const ProfileWave& w : p.wave) {
    most += std::abs(w.amplitude);
    constexpr double rounding = 1e-9;
    const double order = turn / w.length;
    if (round && std::abs(order - std::round(order)) > rounding * order)
      fail(Status::err_argument,
           "a wave round an axis has length %.10g, so that %.10g fit into a turn; allowed: 2 pi "
           "over a whole number",
           w.length, order);
  }
  std::vector<ProfileSlice> slice = p.slice;
  if (slice.empty()) slice.push_back({0, p.curve, {}});
  if (round)
    for (const ProfileSlice& s : slice) {
      require_one_side(*s.curve, p.radius);
      for (const Vec2& x : s.curve->points())
        if (most > 0 && !(p.radius + x[1] > most))
          fail(Status::err_argument, "waves of %g reach the axis, %g from the profile; allowed: less", most,
               p.radius + x[1]);
    }
  return std::make_shared<const ProfileSlices>(std::move(slice), p.wave, smooth, round ? turn : 0);
}

std::unique_ptr<Surface> surface_of(const BodyProfile& p, bool smooth) {
  if (auto slices = slices_of(p, smooth)) {
    const bool round = p.place == ProfilePlace::revolved;
    SlicesPlace place{round, p.origin, p.axis, p.z, p.radius};
    if (round) {
      // Angles count from the body's z, or its x where the axis is nearer to that.
      const Vec3 from = std::abs(p.axis[2]) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
      const Vec3 off = from - dot(from, p.axis) * p.axis;
      place.e_z = (1 / length(off)) * off;
    }
    return std::make_unique<SlicedSurface>(std::move(slices), place);
  }
  if (p.place == ProfilePlace::extruded) return std::make_unique<ExtrudedProfile>(p.curve, p.origin, p.axis, p.z);
  return std::make_unique<RevolvedProfile>(p.curve, p.origin, p.axis, p.radius);
}

void require_one_side(const ProfileCurve& curve, double radius) {
  constexpr double rounding = 1e-12;
  double least = std::numeric_limits<double>::infinity(), y = 0;
  for (const Vec2& x : curve.points())
    if (x[1] < least) {
      least = x[1];
      y = x[0];
    }
  if (radius + least < -rounding * std::max(radius, -least))
    fail(Status::err_argument,
         "with radius %g the profile crosses its axis: its least z is %g, at y %g; allowed: a radius from %g on",
         radius, least, y, 0.0 - least);
}

}  // namespace rollcon
