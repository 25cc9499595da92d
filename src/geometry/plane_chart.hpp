#pragma once
/// Sees surface elements along a direction: gives their outlines in a plane, and the element's point over a point of
/// the plane.

#include <vector>

#include "geometry/convex_polygon.hpp"
#include "geometry/surface_patch.hpp"

namespace rollcon {

/// Holds a plane with unit vectors a, b and the normal n = a x b along which is projected.
struct PlaneChart {
  Vec3 origin, a, b, n;

  /// Takes the mean plane of an element, with the origin at its first node.
  PlaneChart(const SurfaceMesh& mesh, std::int64_t element);
  Vec2 operator()(const Vec3& x) const {
    const Vec3 d = x - origin;
    return {dot(a, d), dot(b, d)};
  }
  double height(const Vec3& x) const { return dot(n, x - origin); }
};

/// Returns twice the vector area of the polygon through the element's nodes on its edge.
Vec3 outline_normal(const SurfaceMesh& mesh, std::int64_t element);

/// Computes the element's outline in the plane, with sides of quadratic elements as two chords, as one convex polygon
/// or several that make it up; parts that look away are left out.
void outline(const SurfaceMesh& mesh, std::int64_t element, const PlaneChart& chart, std::vector<Polygon>& part);

/// Represents the element's coordinates in the plane as polynomials of its reference coordinates.
class PlaneMap {
 public:
  PlaneMap(const SurfacePatch& patch, const PlaneChart& chart);

  bool affine() const { return affine_; }
  /// Says whether the element lies in a plane parallel to the chart's.
  bool flat() const { return flat_; }
  /// Finds the reference point over y by Newton's method from p. Stays within a quarter of an element beyond the edge,
  /// where the map may turn over. Returns the Jacobian there.
  double invert(const Vec2& y, ReferencePoint& p) const;
  /// Returns a start for invert().
  ReferencePoint middle() const { return triangle_ ? ReferencePoint{1.0 / 3, 1.0 / 3} : ReferencePoint{0, 0}; }

 private:
  Vec2 c_[3][3];
  double size_;
  bool triangle_, affine_ = true, flat_ = true;
};

}  // namespace rollcon
