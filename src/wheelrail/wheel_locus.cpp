#include "wheelrail/wheel_locus.hpp"

namespace rollcon {

WheelLocus::WheelLocus(const Vec3& centre, const Vec3& axis, double radius) : axes_{centre, axis, {}, {}, radius} {
  const double flat = std::hypot(axis[1], axis[2]);
  axes_.down = {0, -axis[2] / flat, axis[1] / flat};
  axes_.ahead = cross(axes_.axis, axes_.down);
  tilt_ = axis[0] / axes_.ahead[0];
}

std::optional<LocusPoint> WheelLocus::at(const VisiblePoint& p) const {
  const double s = p.slope * tilt_, square = s * s;
  if (!(square < most_turned)) return std::nullopt;
  const double c = std::sqrt(1 - square), r = axes_.radius + p.z, turn = p.dslope * tilt_ / c;
  const Vec3 e = c * axes_.down + s * axes_.ahead;
  const double down_y = e[1] - p.slope * axes_.axis[1], down_z = e[2] - p.slope * axes_.axis[2];
  const double forward_y = p.dy * axes_.axis[1] + p.dz * e[1] + r * turn * (c * axes_.ahead[1] - s * axes_.down[1]);
  if (!(down_z > 0)) return std::nullopt;
  return LocusPoint{axes_.centre + p.y * axes_.axis + r * e, -down_y / down_z, forward_y};
}

std::array<Vec3, 2> WheelLocus::beside(const VisiblePoint& p, double length) const {
  const double s = p.slope * tilt_, c = std::sqrt(1 - s * s), r = axes_.radius + p.z;
  const double turn_s = std::sin(length / r), turn_c = std::cos(length / r);
  const Vec3 middle = axes_.centre + p.y * axes_.axis + r * turn_c * (c * axes_.down + s * axes_.ahead);
  const Vec3 off = r * turn_s * (c * axes_.ahead - s * axes_.down);
  return {middle - off, middle + off};
}

double WheelLocus::sideways(const VisiblePoint& p) const {
  const double s = p.slope * tilt_;
  return std::sqrt(1 - s * s) * axes_.ahead[1] - s * axes_.down[1];
}

LocusCurvature WheelLocus::curvature(const VisiblePoint& p) const {
  const double s = p.slope * tilt_, steep = std::sqrt(1 + p.slope * p.slope);
  const double around = bend(p), meridian = -p.curvature();
  const double c = axes_.ahead[0] * std::sqrt(1 - s * s),
               m = axes_.axis[0] * steep;  // part of x, around and along the profile
  return {around * c * c + meridian * m * m, (meridian - around) * c * m, around * m * m + meridian * c * c};
}

}  // namespace rollcon
