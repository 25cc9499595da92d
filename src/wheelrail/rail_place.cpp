#include "wheelrail/rail_place.hpp"

#include <cmath>

#include "support/error.hpp"

namespace rollcon {
namespace {

/// s between a and b at which the function is least, to rounding of its values, where it has one valley there.
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
  int below = highest;
  while (below > 0 && canted(below * step)[1] - top < track.height) --below;
  if (canted(below * step)[1] - top < track.height)
    fail(Status::err_argument,
         "gauge_height is %g; allowed: at most %g, where the rail's profile ends on its gauge side, that of lesser y",
         track.height, canted(0)[1] - top);
  double deep = below * step, shallow = std::max(peak, deep);
  constexpr int halvings = 60;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (deep + shallow);
    (canted(middle)[1] - top < track.height ? shallow : deep) = middle;
  }
  RailShape rail;
  rail.origin = {0, 0.5 * track.gauge - canted(deep)[0], -top};
  rail.along = {1, 0, 0};
  rail.down = {0, s, c};
  rail.curve = std::move(curve);
  return rail;
}

}  // namespace rollcon
