#pragma once
/// Describes how a rigid body moves.

#include "mesh/vec3.hpp"

namespace rollcon {

/// Its point at x has the velocity linear + angular x (x - point).
struct Velocity {
  Vec3 linear{0, 0, 0}, angular{0, 0, 0}, point{0, 0, 0};

  bool operator==(const Velocity&) const = default;
  Vec3 at(const Vec3& x) const { return linear + cross(angular, x - point); }
};

}  // namespace rollcon
