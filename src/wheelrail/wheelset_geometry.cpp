#include "wheelrail/wheelset_geometry.hpp"

#include <cmath>

#include "support/error.hpp"
#include "wheelrail/false_position.hpp"

namespace rollcon {

WheelsetGeometry::WheelsetGeometry(WheelRail& left, WheelRail& right) : wheel_{&left, &right} {
  if (left.side() >= 0) fail(Status::err_argument, "left is a wheel on the right; allowed: one made with ROLLCON_LEFT");
  if (right.side() <= 0)
    fail(Status::err_argument, "right is a wheel on the left; allowed: one made with ROLLCON_RIGHT");
  left.require_dimensions();
  right.require_dimensions();
  radius_ = 0.5 * (left.radius() + right.radius());
}

// Returns by how much deeper the wheelset's centre is where the right wheel touches.
double WheelsetGeometry::rise(double shift, Height height, double roll, Standing& standing) {
  standing.roll = roll;
  standing.y = shift + (height == Height::rails ? radius_ * std::sin(roll) : 0);
  for (std::size_t i = 0; i < 2; ++i) {
    standing.touch[i] = wheel_[i]->touch(standing.y, roll);
    standing.touch[i].height += radius_ - wheel_[i]->radius();  // from a wheelset of the mean radius
  }
  standing.z = 0.5 * (standing.touch[0].height + standing.touch[1].height);
  return standing.touch[1].height - standing.touch[0].height;
}

WheelsetGeometry::Standing WheelsetGeometry::at(double shift, Height height) {
  Standing standing;
  constexpr double most_roll = 0.25, rounding = 1e-15;
  double from = roll_, value = rise(shift, height, from, standing);
  const double base = std::abs(standing.touch[1].y - standing.touch[0].y);
  double step = 1.5 * value / base, to = from, other = value;
  while (std::isfinite(other) && other * value > 0 && std::abs(to) < most_roll) {
    from = to;
    value = other;
    to = from + step;
    other = rise(shift, height, to, standing);
    step *= 2;
  }
  if (!std::isfinite(value) || !std::isfinite(other) || other * value > 0) {
    roll_ = 0;
    fail(Status::err_argument, "the shift is %g: no roll brings both wheels on their rails; allowed: less", shift);
  }
  const double enough = rounding * radius_;
  if (value != 0 && other != 0)
    false_position(
        from, value, to, other, [&](double roll) { return rise(shift, height, roll, standing); },
        [&](double f) { return std::abs(f) <= enough; });
  roll_ = standing.roll;
  return standing;
}

KinematicMotion WheelsetGeometry::motion(double amplitude, double& wavelength) {
  if (!(amplitude > 0)) fail(Status::err_argument, "the amplitude is %g; allowed: > 0", amplitude);
  const KinematicMotion motion =
      kinematic_motion([this](double y) { return at(y, Height::rails).difference(); }, amplitude);
  const Standing middle = at(motion.middle, Height::rails);
  const double mean = 0.5 * (middle.touch[0].rolling_radius + middle.touch[1].rolling_radius);
  wavelength = motion.wavelength() * std::sqrt(mean * (middle.touch[1].y - middle.touch[0].y));
  return motion;
}

}  // namespace rollcon
