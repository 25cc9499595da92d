#pragma once
/// Computes displacements and stresses inside a boundary-element body by Somigliana's identities (docs/theory.md,
/// inside of boundary elements):
///
///   u(x) = integral U t - integral T u,   stress(x) = integral D t - integral S u
///
/// over the surface that the body's equations are written on, with the linear field of the nearest surface point taken
/// away from u and t and added again.

#include <memory>
#include <vector>

#include "bodies/bem/far_field.hpp"
#include "bodies/bem/lifted_surface.hpp"
#include "bodies/bem/surface_stress.hpp"
#include "bodies/model/surface_state.hpp"
#include "geometry/surface_search.hpp"
#include "quadrature/near_field.hpp"

namespace rollcon::bem {

/// Holds a surface and the rules of its elements, in units of the mesh's size. The mesh must outlive it.
class SomiglianaSurface {
 public:
  SomiglianaSurface(const SurfaceMesh& mesh, double size, double accuracy);
  /// Returns loaded faces with u over size and tractions over G.
  std::vector<LoadedFace> faces(const double* u, const double* traction) const;

  struct Workspace {
    NearWorkspace near;
    NearPoints points;
  };
  /// Adds the integrals over all faces, seen from x in units of size.
  void add(const std::vector<LoadedFace>& faces, const Vec3& x, double poisson, const LinearField& linear, Workspace& w,
           double* sum) const;

 private:
  const SurfaceMesh& mesh_;
  double size_, tolerance_;
  std::vector<ElementGeometry> geometry_;
  FarField far_;
  FarField::PackFactors factors_{1};
};

/// Holds the surface of a body with what does not depend on its loads.
struct SomiglianaBody {
  SomiglianaBody(const LiftedSurface& surface, double shear, double poisson, double accuracy, double edge_angle);
  const LiftedSurface& lifted;
  double shear, poisson, accuracy, edge_angle;
  double size;
  SurfaceSearch search;
  SomiglianaSurface surface;
  std::vector<double> bulge;  ///< distance of lifted from straight sides of linear elements
};

class Somigliana final : public BodyFields {
 public:
  /// Takes a state, whose tractions belong to the connectivity of mesh `surface`.
  Somigliana(std::shared_ptr<const SomiglianaBody> body, const SurfaceMesh& surface, const SurfaceState& state);

  void at_points(std::int64_t n, const double* xyz, double* displacement, double* stress, int threads) const override;
  void at_nodes(double* stress, int threads) const override;

 private:
  struct Result;
  bool evaluate(const Vec3& x, SomiglianaSurface::Workspace& w, Result& result) const;
  Vec3 layer_traction(const Vec3& x, double reach) const;

  std::shared_ptr<const SomiglianaBody> body_;
  std::int64_t nodes_;
  SurfaceValues values_;
  std::vector<double> smoothed_;
  std::vector<LoadedFace> faces_;
  SurfaceMesh layer_;
  SurfaceValues layer_values_;
  std::unique_ptr<SurfaceSearch> layer_search_;
  std::unique_ptr<SomiglianaSurface> layer_surface_;
  std::vector<LoadedFace> layer_faces_;
};

}  // namespace rollcon::bem
