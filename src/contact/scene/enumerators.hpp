#pragma once
/// Lists what callers of a contact name by number; the numbers are those of rollcon.h and never change.

#include <array>
#include <cstddef>
#include <cstdint>

namespace rollcon {

/// Holds what a progress callback may read.
struct Event {
  std::int32_t phase = 0;      ///< Phase enumerators of rollcon.h
  std::int64_t iteration = 0;  ///< within the phase, from 0
  double residual = 0;         ///< relative residual of the iterate
  double seconds = 0;          ///< since the solve began
};

enum class Phase : std::int32_t { compliance = 1, normal = 2, tangential = 3, full = 4, cases = 5 };
enum class Field : std::int32_t {
  point = 1,
  traction = 2,
  gap = 3,
  slip = 4,
  displacement1 = 5,
  displacement2 = 6,
  area = 7,
  friction = 8,
  pressure = 9,
  rigid_slip = 10,
  friction_power = 11,
  weight = 12,
  temperature = 13,
};
enum class NodeStatus : std::int32_t { open = 0, stick = 1, slip = 2, excluded = 3 };
/// Lists what results may be differentiated by: the value prescribed in a direction (Direction's numbers), or a factor
/// on the friction coefficient of every node.
enum class Parameter : std::int32_t {
  longitudinal = 1,
  lateral = 2,
  normal = 3,
  spin = 4,
  friction = 5,
  tilt1 = 6,
  tilt2 = 7
};
enum class InAxes : std::int32_t { local = 0, global = 1 };

/// Says what a solve is: a steady state, or one step in time of a contact that rolls or whose bodies are shifted.
enum class StepKind : std::int32_t { steady = 0, rolling = 1, shift = 2 };

/// Numbers motions and their conjugate loads: creepages, approach and spin, and rotations of body 1 about t1 and t2
/// through the origin, whose loads are moments on it.
enum Motion : int { xi1 = 0, xi2 = 1, approach = 2, spin = 3, tilt1 = 4, tilt2 = 5 };
constexpr std::size_t motion_count = 6;
using MotionValues = std::array<double, motion_count>;
/// Returns the motion of a Direction or Parameter, whose numbers have friction between spin and tilts.
template <class Number>
constexpr std::size_t motion_of(Number number) {
  const auto n = static_cast<std::size_t>(number);
  return n > 5 ? n - 2 : n - 1;
}

using ProgressFunction = std::int32_t (*)(const Event& event, void* user);

}  // namespace rollcon
