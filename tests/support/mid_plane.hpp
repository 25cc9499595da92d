#pragma once
/// Reads results off the mid-plane y = 0 of rolling rings, and off their contact zone.

#include <algorithm>
#include <cmath>

#include "support/scene.hpp"

namespace rollcon::scenes {

struct MidPlane {
  double p0 = 0, half_width = 0;
  double side_pressure = 0;  ///< largest pressure at the free sides
  double slip = 0;           ///< largest slip velocity in the zone, its rims left out
  double gap = 0;            ///< largest gap on the mid-plane
};

/// Takes as `zone` the length of the contact zone, as `width` that of the rings.
inline MidPlane mid_plane(const Solution& s, double zone, double width) {
  MidPlane m;
  double xx = 0, pp = 0, x2 = 0, x4 = 0, count = 0;  // sums of the fit p^2 = p0^2 (1 - x^2/a^2)
  for (std::size_t k = 0; k < s.nodes(); ++k) {
    // Godunov's cells end at the outflow rim and double the slip there, well outside the contact.
    if (std::abs(s.x[k]) < 0.45 * zone) m.slip = std::max(m.slip, std::hypot(s.slip[k][0], s.slip[k][1]));
    if (std::abs(std::abs(s.y[k]) - width / 2) < 1e-6) m.side_pressure = std::max(m.side_pressure, s.pressure[k]);
    if (std::abs(s.y[k]) > 1e-6) continue;
    m.gap = std::max(m.gap, s.gap[k]);
    if (!(s.pressure[k] > 0)) continue;
    m.p0 = std::max(m.p0, s.pressure[k]);
    const double q = s.pressure[k] * s.pressure[k], u = s.x[k] * s.x[k];
    xx += u, pp += q, x2 += u * q, x4 += u * u, ++count;
  }
  const double slope = (count * x2 - xx * pp) / (count * x4 - xx * xx);
  m.half_width = std::sqrt((pp - slope * xx) / count / -slope);
  return m;
}

}  // namespace rollcon::scenes
