#pragma once
/// Holds what is prescribed of motions and loads, apart from the problem: a case of a list has its own, and strategies
/// try others on a copy.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "contact/scene/enumerators.hpp"

namespace rollcon {

constexpr bool changes_gap(int m) {
  return m == approach || m >= tilt1;
}

/// Says which tractions are unknown: the normal ones, the tangential ones under a given bound, or all.
enum class Part : std::int32_t { normal = 2, tangential = 3, full = 4 };

inline bool has_normal(Part part) {
  return part != Part::tangential;
}
inline bool has_tangential(Part part) {
  return part != Part::normal;
}
/// Says whether motion m (or its load) is the part's.
inline bool has_motion(Part part, int m) {
  return changes_gap(m) ? has_normal(part) : has_tangential(part);
}

/// Friction below which it counts as none: squares of its tractions vanish.
inline constexpr double least_friction = 1e-100;

struct Prescribed {
  std::array<bool, motion_count> by_force{};  ///< motion is unknown, conjugate load given
  MotionValues value{};                       ///< load (on body 1) where by force, else motion
  double full_approach = 0;                   ///< prescribed approach as it was given, counted from the gap as given
  double friction = 1;                        ///< factor on the nodes' coefficients
  double falling = 1;                         ///< factor on the slip speed that friction falls with; 0: as at rest
  double slip_scale = 1;                      ///< factor on the nodes' scales of slip: another path, same solution
  /// Factor on the coefficient of each node, where friction follows the whole solution; empty: 1.
  std::vector<double> utilisation{};

  /// Returns the coefficient of node k, from those that the problem has.
  double coefficient(const std::vector<double>& mu, std::size_t k) const {
    return friction * mu[k] * (utilisation.empty() ? 1 : utilisation[k]);
  }

  bool tangential_load() const { return by_force[xi1] || by_force[xi2] || by_force[spin]; }
  /// Prescribes the normal direction: a load, or an approach that counts from the gap as given.
  void prescribe_normal(bool force, double v, double datum) {
    by_force[approach] = force;
    full_approach = v;
    value[approach] = force ? v : v - datum;
  }
  /// Returns the approach of an iterate from the gap as given; a prescribed one exactly as it was given.
  double approach_of(const MotionValues& motion, double datum) const {
    return by_force[approach] ? motion[approach] + datum : full_approach;
  }
};

}  // namespace rollcon
