#pragma once
/// Measures errors of a rolling contact's answer in all its components. A single component flatters: its error may
/// cross zero while that of another grows.

#include <algorithm>
#include <array>
#include <cmath>

#include "support/scene.hpp"

namespace rollcon::scenes {

/// Holds the tangential force, or what stands for it, in any unit, and the spin moment over mu Fn sqrt(a b), a and b
/// the contact's semi-axes.
struct RollingAnswer {
  std::array<double, 2> force{};
  double moment = 0;
};

struct RollingErrors {
  double force = 0;   ///< |(dFx, dFy)| / |(Fx, Fy)|
  double moment = 0;  ///< |dMz| / (mu Fn sqrt(a b))
};

inline RollingErrors rolling_errors(const RollingAnswer& found, const RollingAnswer& exact) {
  const auto& [x, y] = exact.force;
  return {std::hypot(found.force[0] - x, found.force[1] - y) / std::hypot(x, y), std::abs(found.moment - exact.moment)};
}

/// Returns the worst of several answers, each component by itself.
inline RollingErrors worst(const RollingErrors& one, const RollingErrors& other) {
  return {std::max(one.force, other.force), std::max(one.moment, other.moment)};
}

/// Returns forces over `unit` and the moment over `unit` times `arm`: mu Fn and sqrt(a b).
inline RollingAnswer found_forces(const Solution& s, double unit, double arm) {
  return {{s.force[0] / unit, s.force[1] / unit}, s.moment[2] / (unit * arm)};
}

/// Returns, where the longitudinal force is given, the creepage found, turned like the force, so that a lateral force
/// which should not be there counts as it does among forces.
inline RollingAnswer found_creepage(const Solution& s, double unit, double arm) {
  return {{s.creep[0], s.creep[0] * s.force[1] / s.force[0]}, s.moment[2] / (unit * arm)};
}

}  // namespace rollcon::scenes
