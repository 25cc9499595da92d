#pragma once
/// Tells what a solve does: its iterations as they happen, and how it ended.

#include <array>
#include <cstdint>

#include "contact/newton/friction_limit.hpp"
#include "contact/problem/prescribed.hpp"

namespace rollcon {

/// Tells what one iteration looked like; residuals are relative to the largest pressure and to the largest tangential
/// traction.
struct StepRecord {
  Part part = Part::normal;
  std::int64_t iteration = 0;
  double residual_normal = 0, residual_tangential = 0;
  double merit = 0;  ///< error function Psi: half the squared norm of the relative residuals
  double step = 0;
  std::int64_t contact = 0, sliding = 0;
};

/// Hears of every iteration; true asks to stop.
struct Monitor {
  virtual ~Monitor() = default;
  virtual bool step(const StepRecord& record) = 0;
  /// Says whether a stop was asked for, to work that has no iterations to tell of.
  virtual bool cancelled() const { return false; }
};

enum class Outcome { converged, not_converged, cancelled, no_contact, no_solution };

/// Lists what is tried where the full step gets stuck.
enum class Rung {
  approach_of_pressures,  ///< a bracket of the approach, for the normal part alone
  cold,                   ///< a warm start left for a cold one
  follow_loads,
  rescale_slip,
  alternate,
  grow_friction,
};
inline constexpr std::size_t rungs = 6;

struct NewtonReport {
  Outcome outcome = Outcome::not_converged;
  std::int64_t normal_iterations = 0, tangential_iterations = 0, full_iterations = 0;
  double residual_normal = 0, residual_tangential = 0;
  double residual_load = 0;  ///< greatest relative error of a prescribed load
  FrictionShare share;       ///< utilisation where the loads were found to be beyond friction
  std::int64_t fallbacks = 0;
  bool from_nothing = false;                ///< no solution was there to start from, or it was left
  std::array<std::int64_t, rungs> saved{};  ///< solves (parts) that a rung brought to its end
  std::int64_t refuted = 0;                 ///< successes of a part that the last guard did not let pass
  std::int64_t predictions = 0;             ///< parts that began from a predicted iterate

  std::int64_t& iterations_of(Part part) {
    return part == Part::normal       ? normal_iterations
           : part == Part::tangential ? tangential_iterations
                                      : full_iterations;
  }
};

}  // namespace rollcon
