#pragma once
/// Where a rail lies in the track: canted, its highest point at z = 0, its gauge side where the gauge says.

#include <memory>

#include "wheelrail/contact_search.hpp"

namespace rollcon {

struct TrackGauge {
  double gauge = 0;   ///< between the rails
  double height = 0;  ///< below the rail's top at which it is measured; 0: to the profile's origin, at the rail's top
  double cant = 0;    ///< radian; inwards
};

/// The rail on the right; upright, the profile's y points to the right and its z down. err_argument: on its gauge side
/// the profile does not reach down to the gauge's height, or its z points up.
RailShape place_rail(std::shared_ptr<const ProfileCurve> curve, const TrackGauge& track);

/// Keeps on one side of the axis, z down and the flange, if there is one, at lesser y. err_argument.
void require_wheel_profile(const ProfileCurve& curve, double radius);

}  // namespace rollcon
