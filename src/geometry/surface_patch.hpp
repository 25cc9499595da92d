#pragma once
/// Represents one element as a polynomial of its reference coordinates: where a line meets it, and which of its points
/// is nearest.

#include <array>
#include <optional>
#include <vector>

#include "mesh/shape.hpp"
#include "mesh/surface_mesh.hpp"

namespace rollcon {

/// Holds a part of the reference element, with its own triangle or square at `corner` and sides of (signed) length h.
/// Linear elements are one part, quadratic ones four; each is a start for Newton's method.
struct PatchPart {
  ReferencePoint corner;
  double h;
};

class SurfacePatch {
 public:
  SurfacePatch(const SurfaceMesh& mesh, std::int64_t element);

  /// Holds a point relative to origin(), and its derivatives.
  struct Derivatives {
    Vec3 x, u, v, uu, uv, vv;
  };
  Derivatives at(double xi, double eta) const;
  const Vec3& origin() const { return origin_; }
  /// Returns the coefficient of xi^i eta^j, i and j up to 2, relative to origin().
  const Vec3& coefficient(int i, int j) const { return c_[i][j]; }
  double size() const { return size_; }  ///< longest distance of a node from the first
  bool triangle() const { return triangle_; }
  int parts() const { return quadratic_ ? 4 : 1; }
  PatchPart part(int i) const;
  /// Returns the corners of a box, relative to origin(), that holds the part.
  std::array<Vec3, 2> box(const PatchPart& part) const;
  /// Returns the point of the reference element nearest to (xi, eta).
  ReferencePoint clamp(ReferencePoint p) const;

  /// Intersects the line through `from` (relative to origin()), normal to the unit vectors a and b, near the part:
  /// finds all points in it, maybe others, each within `beyond` of the element and moved onto it.
  void meet(const PatchPart& part, const Vec3& from, const Vec3& a, const Vec3& b, double beyond,
            std::vector<ReferencePoint>& found) const;

  /// Returns the point nearest to `point` (relative to origin()) of those that descents reach from the part and from
  /// its portion of the element's edges.
  ReferencePoint nearest(const PatchPart& part, const Vec3& point) const;

 private:
  std::optional<ReferencePoint> newton(ReferencePoint start, const Vec3& from, const Vec3& a, const Vec3& b) const;
  ReferencePoint descend(ReferencePoint start, const Vec3& point) const;
  ReferencePoint descend_on_edge(const ReferencePoint& p, const ReferencePoint& q, double start,
                                 const Vec3& point) const;
  ReferencePoint inside(const PatchPart& part, double s, double t) const {
    return {part.corner.xi + s * part.h, part.corner.eta + t * part.h};
  }

  ReferencePoint middle(const PatchPart& part) const {
    const double s = triangle_ ? 1.0 / 3 : 0.5;
    return inside(part, s, s);
  }
  /// Says whether the normal's component along the direction changes sign on a lattice over the part.
  bool turns_over(const PatchPart& part, const Vec3& direction) const;
  bool holds(const PatchPart& part, const ReferencePoint& p) const;

  Vec3 origin_;
  double size_ = 0;
  bool triangle_, quadratic_;
  Vec3 c_[3][3]{};  ///< coefficients of xi^i eta^j
};

}  // namespace rollcon
