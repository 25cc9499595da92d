#pragma once
/// Solves lists of positions of a wheel on its rail over threads.

#include <cstdint>

#include "wheelrail/wheel_rail.hpp"

namespace rollcon {

struct PositionList {
  std::int64_t cases = 0;
  const double* position = nullptr;  ///< [cases][6]
  const double* velocity = nullptr;  ///< [cases][6]
};

/// Count of totals: force and moment on the wheel in the track, z, vertical force, frictional power.
inline constexpr std::int64_t position_totals = 9;

/// Solves each position by itself from nothing, as after a reset, with what else the wheel was given: results do not
/// depend on the other positions, their order, or the number of threads. totals [cases][position_totals], NaN where
/// there are none; status [cases], may be null. The wheel stays as it is. Returns the worst status.
Status solve_positions(WheelRail& wheel, const PositionList& list, double* totals, std::int32_t* status);

/// Asks for the wear of a list of positions.
struct WearOfPositions {
  const WearLaw& law;
  const double* weight = nullptr;  ///< [cases]; null: each 1 / cases
  std::int64_t points = 0;         ///< number of points at equal arc lengths along each profile
  double* wheel = nullptr;         ///< [points], depth per pass; may be null
  double* rail = nullptr;          ///< [points], depth per pass; may be null
  double* volume = nullptr;        ///< volume per length rolled, of each body; may be null
};

/// Solves the positions as solve_positions() does, and adds what they take off either profile, times their weights, in
/// their order. Positions without a solution add nothing.
Status find_wear(WheelRail& wheel, const PositionList& list, const WearOfPositions& wear, std::int32_t* status);

}  // namespace rollcon
