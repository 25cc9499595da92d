#pragma once
/// Runs a wheelset's oscillation in the track seen by one of its contacts: wheel load, creepages and spin that change a
/// little from step to step. It is a header only, and uses rollcon.h alone.

#include <rollcon.h>

#include <cmath>
#include <cstdint>
#include <numbers>

namespace rollcon::wheelset_run {

/// The scene is steel (N, mm) on the tread: wheel radius 460, rail crown 300, semi-axes 7.2 and 5.4 at 100 kN.
inline constexpr double young = 210000, poisson = 0.28, friction = 0.3, load = 100000;
inline constexpr double curvature_along = 0.5 / 460, curvature_across = 0.5 / 300;
inline constexpr double half_along = 9, half_across = 6.8;

/// The option `tolerance` gives forces to a millinewton.
inline constexpr double tolerance = 1e-8;

enum class Drive {
  creepage,  ///< longitudinal creepage given
  traction   ///< longitudinal force given
};

/// Holds what is prescribed in one step.
struct Step {
  double load, longitudinal, lateral, spin;
};

/// Returns step i, with 500 steps to a period of the lateral oscillation: a wave of 15 m, 30 m/s, steps of 1 ms. Load
/// and traction have periods of their own, so that no state returns.
inline Step step(std::int64_t i, Drive drive) {
  const double turn = 2 * std::numbers::pi * static_cast<double>(i) / 500;
  Step s{};
  s.load = load * (1 + 0.3 * std::sin(turn / 3.7));
  s.lateral = 2.5e-3 * std::sin(turn);
  s.spin = 1e-4 + 1.5e-4 * std::cos(turn);
  s.longitudinal = drive == Drive::creepage ? 1.5e-3 * std::cos(turn * 1.3)
                                            : 0.6 * friction * load * (1 - 0.3) * std::sin(turn / 2.3);
  return s;
}

/// Sets a step's values; returns the sum of the statuses.
inline std::int32_t prescribe(rollcon_contact* contact, const Step& s, Drive drive) {
  const std::int32_t how = drive == Drive::traction ? ROLLCON_BY_FORCE : ROLLCON_BY_MOTION;
  return rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, s.load) +
         rollcon_contact_prescribe(contact, ROLLCON_LATERAL, ROLLCON_BY_MOTION, s.lateral) +
         rollcon_contact_prescribe(contact, ROLLCON_SPIN, ROLLCON_BY_MOTION, s.spin) +
         rollcon_contact_prescribe(contact, ROLLCON_LONGITUDINAL, how, s.longitudinal);
}

/// Sets a frame of n x n bilinear quadrilaterals, gap, friction and speed; returns the sum of the statuses.
inline std::int32_t set_scene(rollcon_contact* contact, int n) {
  return rollcon_contact_frame_rectangle(contact, ROLLCON_QUAD4, n, n, -half_along, half_along, -half_across,
                                         half_across) +
         rollcon_contact_set_gap_quadratic(contact, curvature_along, curvature_across, 0) +
         rollcon_contact_set_friction(contact, "coulomb", 1, &friction) + rollcon_contact_set_rolling(contact, 30000);
}

}  // namespace rollcon::wheelset_run
