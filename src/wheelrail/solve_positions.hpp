#pragma once
/// Lists of positions of a wheel on its rail over threads.

#include <cstdint>

#include "wheelrail/wheel_rail.hpp"

namespace rollcon {

struct PositionList {
  std::int64_t cases = 0;
  const double* position = nullptr;  ///< [cases][6]
  const double* velocity = nullptr;  ///< [cases][6]
};

/// Force and moment on the wheel in the track, z, vertical force, frictional power.
inline constexpr std::int64_t position_totals = 9;

/// Solves each position by itself from nothing, as after a reset, with what else the wheel was given: results do not
/// depend on the other positions, their order, or the number of threads. totals [cases][position_totals], NaN where
/// there are none; status [cases], may be null. The wheel stays as it is. Returns ok, or the first that fits of
/// cancelled, not_converged (or failed), derailed, too_deep, rim_contact, coarse, no_contact.
Status solve_positions(WheelRail& wheel, const PositionList& list, double* totals, std::int32_t* status);

}  // namespace rollcon
