/// Finds where a rigid wheel touches its rigid rail.

#include <cmath>
#include <limits>

#include "wheelrail/wheel_rail.hpp"

namespace rollcon {

// Searches along z of the rail, which may be turned a little from that of the track.
WheelRail::Touch WheelRail::touch(double shift, double roll) {
  require_dimensions();
  prepare_search();
  const Pose rail = rail_pose(in_.deviation);
  WheelsetState position;
  position.y = side_ * shift;
  position.roll = side_ * roll;
  Touch touch;
  constexpr int most = 50;
  const double enough = 1e-15 * radius_;
  for (int i = 0; i < most; ++i) {
    const auto found = search_->touch(relative(rail, wheel_pose(position, touch.height, {})), in_.position.x);
    if (!found) {
      touch.height = std::numeric_limits<double>::infinity();
      return touch;
    }
    touch.height += found->gap;
    const Vec3 x = rail.place(found->x);
    touch.x = x[0];
    touch.y = side_ * x[1];
    touch.z = x[2];
    touch.angle = side_ * (found->angle + in_.deviation.roll);
    touch.wheel_y = found->wheel_y;
    touch.rolling_radius = found->rolling_radius;
    if (in_.deviation.roll == 0 || std::abs(found->gap) <= enough) break;
  }
  return touch;
}

}  // namespace rollcon
