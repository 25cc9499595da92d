#pragma once
/// Says where a body stands: x = rotation * x_body + translation.

#include "mesh/vec3.hpp"

namespace rollcon {

struct Pose {
  std::array<Vec3, 3> rotation{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  ///< rows
  Vec3 translation{0, 0, 0};

  bool operator==(const Pose&) const = default;
  /// Rotates vectors from body axes to space, and back.
  Vec3 turn(const Vec3& v) const { return {dot(rotation[0], v), dot(rotation[1], v), dot(rotation[2], v)}; }
  Vec3 turn_back(const Vec3& v) const { return v[0] * rotation[0] + v[1] * rotation[1] + v[2] * rotation[2]; }
  /// Moves points from body axes to space, and back.
  Vec3 place(const Vec3& x) const { return turn(x) + translation; }
  Vec3 to_body(const Vec3& x) const { return turn_back(x - translation); }
};

/// Returns the pose of b as seen from a.
inline Pose relative(const Pose& a, const Pose& b) {
  Pose pose;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 row{a.rotation[0][i], a.rotation[1][i], a.rotation[2][i]};
    for (std::size_t j = 0; j < 3; ++j)
      pose.rotation[i][j] = dot(row, {b.rotation[0][j], b.rotation[1][j], b.rotation[2][j]});
  }
  pose.translation = a.to_body(b.translation);
  return pose;
}

/// Returns the pose of what has pose b in a body of pose a.
inline Pose composed(const Pose& a, const Pose& b) {
  Pose pose;
  for (std::size_t i = 0; i < 3; ++i) pose.rotation[i] = b.turn_back(a.rotation[i]);
  pose.translation = a.place(b.translation);
  return pose;
}

}  // namespace rollcon
