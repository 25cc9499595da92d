#include "bodies/model/body_profile.hpp"

#include <algorithm>
#include <limits>

#include "geometry/profile_surface.hpp"
#include "support/error.hpp"

namespace rollcon {

std::unique_ptr<Surface> surface_of(const BodyProfile& p) {
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
