#include "wheelrail/depth_along.hpp"

#include <algorithm>
#include <cmath>

#include "wheelrail/false_position.hpp"

namespace rollcon {
namespace {

struct Depth {
  double value, rise;  ///< depth, and its change along the lateral axis
};

/// Measures from the rail to a point of the wheel, in axes turned by the angle.
class DepthAlong {
 public:
  DepthAlong(const ProfileGap& gap, double angle)
      : gap_(gap), angle_(angle), c_(std::cos(angle)), s_(std::sin(angle)) {}

  Depth at(const GapPoint& p) const {
    constexpr int most = 6;
    constexpr double enough = 1e-10;
    const double py = p.wheel[1], pz = p.wheel[2];
    double y = py, z = pz + p.gap, slope = p.rail_slope;
    for (int i = 0; i < most; ++i) {
      const double step = -((y - py) * c_ + (z - pz) * s_) / (c_ + s_ * slope);
      if (!(std::abs(step) > enough * std::abs(p.gap))) break;
      y += step;
      if (!gap_.varying()) y = std::clamp(y, gap_.rail().low(), gap_.rail().high());
      const VisiblePoint r = gap_.rail_at(y, p.wheel[0]);
      z = r.z;
      slope = r.slope;
    }
    const double wheel_slope = p.rail_slope - p.rise;
    return {(y - py) * s_ - (z - pz) * c_,
            std::tan(std::atan(wheel_slope) - angle_) - std::tan(std::atan(slope) - angle_)};
  }

 private:
  const ProfileGap& gap_;
  double angle_, c_, s_;
};

}  // namespace

double greatest_depth_along(const ProfileGap& gap, const Overlap& overlap, double angle) {
  constexpr int parts = 8;
  constexpr double enough = 1e-6;
  const DepthAlong along(gap, angle);
  double greatest = along.at(overlap.deepest).value, before = overlap.from.s, rise = along.at(overlap.from).rise;
  Depth last{};
  const auto value = [&](double s) {
    if (const auto p = gap.at(s)) last = along.at(*p);
    greatest = std::max(greatest, last.value);
    return last.rise;
  };
  for (int i = 1; i <= parts; ++i) {
    const double s = overlap.from.s + (overlap.to.s - overlap.from.s) * i / parts, next = value(s);
    if (rise > 0 && next < 0)
      false_position(before, rise, s, next, value, [&](double f) { return std::abs(f) <= enough * (rise - next); });
    before = s;
    rise = next;
  }
  return greatest;
}

}  // namespace rollcon
