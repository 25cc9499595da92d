#include "wheelrail/wheel_locus.hpp"

namespace rollcon {

WheelLocus::WheelLocus(const Vec3& centre, const Vec3& axis, double radius)
    : centre_(centre), axis_(axis), radius_(radius) {
  const double flat = std::hypot(axis[1], axis[2]);
  down_ = {0, -axis[2] / flat, axis[1] / flat};
  ahead_ = cross(axis_, down_);
  tilt_ = axis[0] / ahead_[0];
}

std::optional<LocusPoint> WheelLocus::at(const VisiblePoint& p) const {
  const double s = p.slope * tilt_, square = s * s;
  if (!(square < most_turned)) return std::nullopt;
  const double c = std::sqrt(1 - square), r = radius_ + p.z, turn = p.dslope * tilt_ / c;
  const Vec3 e = c * down_ + s * ahead_;
  const double down_y = e[1] - p.slope * axis_[1], down_z = e[2] - p.slope * axis_[2];
  const double forward_y = p.dy * axis_[1] + p.dz * e[1] + r * turn * (c * ahead_[1] - s * down_[1]);
  if (!(down_z > 0)) return std::nullopt;
  return LocusPoint{centre_ + p.y * axis_ + r * e, -down_y / down_z, forward_y};
}

std::array<Vec3, 2> WheelLocus::beside(const VisiblePoint& p, double length) const {
  const double s = p.slope * tilt_, c = std::sqrt(1 - s * s), r = radius_ + p.z;
  const double turn_s = std::sin(length / r), turn_c = std::cos(length / r);
  const Vec3 middle = centre_ + p.y * axis_ + r * turn_c * (c * down_ + s * ahead_);
  const Vec3 off = r * turn_s * (c * ahead_ - s * down_);
  return {middle - off, middle + off};
}

double WheelLocus::sideways(const VisiblePoint& p) const {
  const double s = p.slope * tilt_;
  return std::sqrt(1 - s * s) * ahead_[1] - s * down_[1];
}

LocusCurvature WheelLocus::curvature(const VisiblePoint& p) const {
  const double s = p.slope * tilt_, steep = std::sqrt(1 + p.slope * p.slope);
  const double around = bend(p), meridian = -p.curvature();
  const double c = ahead_[0] * std::sqrt(1 - s * s), m = axis_[0] * steep;  // part of x, around and along the profile
  return {around * c * c + meridian * m * m, (meridian - around) * c * m, around * m * m + meridian * c * c};
}

}  // namespace rollcon
