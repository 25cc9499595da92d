#pragma once
/// Defines surfaces that a line can hit: where bodies are before they deform. A kind of surface is one file of this
/// folder.

#include <array>
#include <cstddef>
#include <limits>
#include <optional>

#include "mesh/vec3.hpp"

namespace rollcon {

/// Says where a line met a surface, for lines near by; each kind of surface reads its own.
struct SurfaceHint {
  int branch = -1;  ///< -1 if nothing is known
  std::size_t piece = 0;
  double parameter = 0;
  double place = 0;  ///< second parameter of surfaces that need one
};

/// Meets lines from + t * direction (unit) where |t| is least, among the parts that look towards `facing`; the zero
/// vector stands for all parts. Where `facing` is along the line, which it is in contacts, nothing counts beyond the
/// axis of a surface that goes round one.
class Surface {
 public:
  virtual ~Surface() = default;
  /// Returns t where the line meets the surface; none if it misses.
  virtual std::optional<double> distance(const Vec3& from, const Vec3& direction, const Vec3& facing) const = 0;
  /// Returns distance(), found from where a line near by met the surface; a hint that leads nowhere has no effect.
  virtual std::optional<double> distance_near(const Vec3& from, const Vec3& direction, const Vec3& facing,
                                              SurfaceHint&) const {
    return distance(from, direction, facing);
  }
  /// Returns the outward unit normal where the line meets the surface.
  virtual std::optional<Vec3> normal(const Vec3& from, const Vec3& direction, const Vec3& facing) const = 0;
  /// Returns the unit normal, to either side, where distance_near() met the surface last with this hint: at `met`.
  virtual Vec3 normal_met(const Vec3& met, const Vec3& direction, const SurfaceHint&) const {
    return normal(met, direction, direction).value_or(direction);
  }
  virtual Vec3 nearest(const Vec3& point) const = 0;
  /// Returns the least and greatest coordinate along a unit vector, infinite where the surface has no end. The interval
  /// may be wider than the surface, never narrower.
  virtual std::array<double, 2> extent(const Vec3& direction) const;
  /// Returns the direction along which the surface repeats itself without end, if there is one.
  virtual std::optional<Vec3> endless() const { return std::nullopt; }
};

inline std::array<double, 2> Surface::extent(const Vec3&) const {
  return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
}

class Plane final : public Surface {
 public:
  Plane(const Vec3& origin, const Vec3& normal) : origin_(origin), normal_(normal) {}
  std::optional<double> distance(const Vec3& from, const Vec3& direction, const Vec3&) const override {
    return dot(origin_ - from, normal_) / dot(direction, normal_);
  }
  std::optional<Vec3> normal(const Vec3&, const Vec3&, const Vec3&) const override { return normal_; }
  Vec3 nearest(const Vec3& point) const override { return point + dot(origin_ - point, normal_) * normal_; }

 private:
  Vec3 origin_, normal_;
};

}  // namespace rollcon
