#pragma once
/// Recomputes the contact laws from the published results alone, without the solver's own residuals.

#include <algorithm>
#include <cmath>

#include "validation/scenes.hpp"

namespace rollcon::validation {

struct LawErrors {
  double tension = 0;          ///< largest -p over p0
  double penetration = 0;      ///< largest -gap over the approach
  double complementarity = 0;  ///< largest p gap over p0 approach
  double bound = 0;            ///< largest |q| - mu p over mu p0
  double direction = 0;        ///< slip nodes: largest |q + mu p s/|s|| over mu p0, times |s| over its scale
  double stick = 0;            ///< stick nodes: largest |s| over the scale of slip
  double equilibrium = 0;      ///< sum of weight times traction less the resultant, over the load
};

/// Takes a typical slip velocity, for example V |creepage|, as slip_scale.
inline LawErrors check_laws(const Solution& s, double mu, double slip_scale) {
  LawErrors e;
  const double p0 = *std::max_element(s.pressure.begin(), s.pressure.end());
  const double length = std::max(std::abs(s.approach), 1e-300);
  double sum[3] = {};
  for (std::size_t k = 0; k < s.nodes(); ++k) {
    const double p = s.pressure[k], g = s.gap[k];
    const double qx = s.traction[k][0], qy = s.traction[k][1];
    const double sx = s.slip[k][0], sy = s.slip[k][1];
    const double slip = std::hypot(sx, sy);
    for (std::size_t i = 0; i < 3; ++i) sum[i] += s.weight[k] * s.traction[k][i];
    e.tension = std::max(e.tension, std::max(-p, s.traction[k][2]) / p0);
    e.penetration = std::max(e.penetration, -g / length);
    e.complementarity = std::max(e.complementarity, std::abs(p * g) / (p0 * length));
    if (mu > 0) e.bound = std::max(e.bound, (std::hypot(qx, qy) - mu * p) / (mu * p0));
    // The direction of a slip known to some absolute accuracy is the less certain the smaller it is.
    if (s.state[k] == ROLLCON_SLIP && slip > 0)
      e.direction = std::max(e.direction, std::min(1.0, slip / slip_scale) *
                                              std::hypot(qx + mu * p * sx / slip, qy + mu * p * sy / slip) / (mu * p0));
    if (s.state[k] == ROLLCON_STICK) e.stick = std::max(e.stick, slip / slip_scale);
  }
  for (std::size_t i = 0; i < 3; ++i)
    e.equilibrium = std::max(e.equilibrium, std::abs(sum[i] - s.force[i]) / std::abs(s.force[2]));
  return e;
}

inline void expect_laws(const std::string& name, const LawErrors& e, double bound = 1e-7) {
  expect_error(name + ": tension", e.tension, 1e-12);
  expect_error(name + ": penetration", e.penetration, bound);
  expect_error(name + ": pressure times gap", e.complementarity, bound);
  expect_error(name + ": friction beyond the bound", e.bound, bound);
  expect_error(name + ": friction not against slip", e.direction, bound);
  expect_error(name + ": slip in the stick zone", e.stick, bound);
  expect_error(name + ": resultant", e.equilibrium, 1e-9);
}

}  // namespace rollcon::validation
