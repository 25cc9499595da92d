#pragma once
/// Treats a mesh as a surface. Linear faces stand for a smooth one, because no smooth displacement fits into the edges
/// of facets, and their distance from it would come out as ripples of the pressure.

#include "geometry/surface.hpp"
#include "geometry/surface_search.hpp"
#include "mesh/traction_nodes.hpp"

namespace rollcon {

class MeshSurface final : public Surface {
 public:
  /// Takes fans without division by tags as smooth_fans. All three arguments must outlive this object.
  MeshSurface(const SurfaceMesh& mesh, const TractionNodes& smooth_fans, const SurfaceSearch& search)
      : mesh_(mesh), fans_(smooth_fans), search_(search) {}

  /// Measures to the smooth surface: half the mean, by the shape functions, of the heights of the tangent planes at the
  /// facet's nodes is added at a point of a facet, which is exact for quadratic surfaces. Quadratic faces are smooth
  /// enough.
  std::optional<double> distance(const Vec3& from, const Vec3& direction, const Vec3& facing) const override;
  /// Interpolates the mean normals of the fans at the element's nodes; at a sharp edge, it takes the mean of the faces
  /// that meet there.
  std::optional<Vec3> normal(const Vec3& from, const Vec3& direction, const Vec3& facing) const override;
  std::array<double, 2> extent(const Vec3& direction) const override;
  Vec3 nearest(const Vec3& point) const override { return search_.nearest(point).x; }

 private:
  Vec3 smooth_normal(const SurfacePoint& point) const;
  double height_over_facet(const SurfacePoint& point, const Vec3& along) const;

  const SurfaceMesh& mesh_;
  const TractionNodes& fans_;
  const SurfaceSearch& search_;
};

}  // namespace rollcon
