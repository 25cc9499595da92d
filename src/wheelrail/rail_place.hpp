#pragma once
/// Places a rail in the track: canted, its highest point at z = 0, its gauge side where the gauge says.

#include <memory>

#include "wheelrail/contact_search.hpp"

namespace rollcon {

struct TrackGauge {
  double gauge = 0;        ///< distance between the rails
  double height = 0;       ///< depth below the rail's top where it counts; 0: to the profile's origin, at the top
  double cant = 0;         ///< angle in radian, inwards
  bool by_origin = false;  ///< the profile's origin lies at (y, z), and gauge and height count for nothing
  double y = 0, z = 0;
};

/// Returns the rail on the right; upright, the profile's y points to the right and its z down. err_argument: on its
/// gauge side the profile does not reach down to the gauge's height, or its z points up.
RailShape place_rail(std::shared_ptr<const ProfileCurve> curve, const TrackGauge& track);

/// Makes the rail a roller with this radius where z is 0 or, if the rail is placed by its origin, the profile's z is.
/// err_argument: the track has cant, or the profile reaches the roller's axis.
void revolve(RailShape& rail, const TrackGauge& track, double radius);

/// Throws err_argument unless the profile keeps on one side of the axis, z points down and a flange lies at lesser y.
void require_wheel_profile(const ProfileCurve& curve, double radius);

}  // namespace rollcon
