#pragma once
/// Surfaces that a line can hit: where bodies are before they deform. A kind of surface is one file of this folder.

#include <array>
#include <cstddef>
#include <limits>
#include <optional>

#include "mesh/vec3.hpp"

namespace rollcon {

/// Where a line met a surface, for lines near by; each kind of surface reads its own.
struct SurfaceHint {
  int branch = -1;  ///< -1: nothing is known
  std::size_t piece = 0;
  double parameter = 0;
};

/// Lines are from + t * direction (unit). They meet the surface where |t| is least, among the parts that look towards
/// `facing`; the zero vector: all parts. Where `facing` is along the line, as in contacts, nothing counts beyond the
/// axis of a surface that goes round one.
class Surface {
 public:
  virtual ~Surface() = default;
  /// t there; none if the line misses the surface.
  virtual std::optional<double> distance(const Vec3& from, const Vec3& direction, const Vec3& facing) const = 0;
  /// The same, found from where a line near by met the surface; where that leads nowhere, as if there was no hint.
  virtual std::optional<double> distance_near(const Vec3& from, const Vec3& direction, const Vec3& facing,
                                              SurfaceHint&) const {
    return distance(from, direction, facing);
  }
  /// Outward unit normal there.
  virtual std::optional<Vec3> normal(const Vec3& from, const Vec3& direction, const Vec3& facing) const = 0;
  virtual Vec3 nearest(const Vec3& point) const = 0;
  /// Least and greatest coordinate along a unit vector, infinite where the surface has no end. Not less than what is
  /// there.
  virtual std::array<double, 2> extent(const Vec3& direction) const;
  /// Direction in which the surface is the same without end, if there is one.
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
