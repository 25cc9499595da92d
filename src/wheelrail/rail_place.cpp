#include "wheelrail/rail_place.hpp"

#include <algorithm>
#include <cmath>

#include "bodies/model/body_profile.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

/// Returns s between a and b at which the function is least, to rounding of its values, where it has one valley there.
template <class F>
double valley(double a, double b, F value) {
  const double golden = 0.5 * (std::sqrt(5.0) - 1);
  constexpr int steps = 80;
  double c = b - golden * (b - a), d = a + golden * (b - a), fc = value(c), fd = value(d);
  for (int i = 0; i < steps; ++i) {
    const bool left = fc < fd;
    (left ? b : a) = left ? d : c;
    (left ? d : c) = left ? c : d;
    (left ? fd : fc) = left ? fc : fd;
    double& fresh = left ? c : d;
    fresh = left ? b - golden * (b - a) : a + golden * (b - a);
    (left ? fc : fd) = value(fresh);
  }
  return 0.5 * (a + b);
}

}  // namespace

RailShape place_rail(std::shared_ptr<const ProfileCurve> curve, const TrackGauge& track) {
  const double c = std::cos(track.cant), s = std::sin(track.cant);
  const auto canted = [&](double at) {
    const Vec2 x = curve->at(at).x;
    return Vec2{x[0] * c + x[1] * s, x[1] * c - x[0] * s};
  };
  constexpr int samples = 2000;
  const double step = curve->length() / samples;
  int highest = 0;
  for (int i = 1; i <= samples; ++i)
    if (canted(i * step)[1] < canted(highest * step)[1]) highest = i;
  const double peak = valley(std::max(highest - 1, 0) * step, std::min(highest + 1, samples) * step,
                             [&](double at) { return canted(at)[1]; });
  const double top = canted(peak)[1];
  if (const Vec2& end = canted(peak), inside = canted(std::abs(peak - step));
      (highest == 0 || highest == samples) && std::abs(inside[1] - end[1]) > std::abs(inside[0] - end[0]))
    fail(
        Status::err_argument,
        "the rail's profile is highest at its end (y = %g, z = %g) and steeper than 45 degrees there; allowed: z down, "
        "the running surface between its ends",
        curve->at(peak).x[0], curve->at(peak).x[1]);
  RailShape rail;
  rail.along = {1, 0, 0};
  rail.down = {0, s, c};
  if (track.by_origin || track.height == 0) {
    rail.origin = track.by_origin ? Vec3{0, track.y, track.z} : Vec3{0, 0.5 * track.gauge, 0};
    rail.curve = std::move(curve);
    return rail;
  }
  int below = highest;
  while (below > 0 && canted(below * step)[1] - top < track.height) --below;
  if (canted(below * step)[1] - top < track.height)
    fail(Status::err_argument,
         "gauge_height is %g; allowed: at most %g, where the rail's profile ends on its gauge side, that of lesser y, "
         "or 0, which places it by its profile's origin",
         track.height, canted(0)[1] - top);
  double deep = below * step, shallow = std::max(peak, deep);
  constexpr int halvings = 60;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (deep + shallow);
    (canted(middle)[1] - top < track.height ? shallow : deep) = middle;
  }
  rail.origin = {0, 0.5 * track.gauge - canted(deep)[0], -top};
  rail.curve = std::move(curve);
  return rail;
}

void revolve(RailShape& rail, const TrackGauge& track, double radius) {
  if (track.cant != 0)
    fail(Status::err_argument,
         "cant is %g beside a roller; allowed: 0 (turn the profile itself, or give the rail's deviation a roll)",
         track.cant);
  const double axis = radius + (track.by_origin ? track.z : 0);
  double deepest = 0;
  for (const Vec2& x : rail.curve->points()) deepest = std::max(deepest, rail.origin[2] + x[1] - (axis - radius));
  if (!(deepest < radius))
    fail(Status::err_argument, "radius of the roller is %g; allowed: > %g, how deep its profile is", radius, deepest);
  rail.roller = axis;
}

// Compares both sides of y = 0: what is as high or as deep on both, a roller's crown, says nothing.
void require_wheel_profile(const ProfileCurve& curve, double radius) {
  require_one_side(curve, radius);
  constexpr int samples = 500;
  constexpr double flange = 0.02;  // fraction of the radius; flanges are 6 to 10 percent high
  double low[2] = {0, 0}, high[2] = {0, 0};
  for (int i = 0; i <= samples; ++i) {
    const Vec2 x = curve.at(i * curve.length() / samples).x;
    const int field = x[0] > 0 ? 1 : 0;
    low[field] = std::min(low[field], x[1]);
    high[field] = std::max(high[field], x[1]);
  }
  const double least = flange * radius;
  if ((high[1] > least && high[1] > 2 * high[0]) || (low[0] < -least && low[0] < 2 * low[1]))
    fail(Status::err_argument,
         "the wheel's profile has z from %g to %g at y < 0, %g to %g at y > 0; allowed: z down, the flange at lesser y",
         low[0], high[0], low[1], high[1]);
}

}  // namespace rollcon
