#pragma once
/// Points, tangents and normals of curved elements.

#include <cstdint>

#include "mesh/shape.hpp"
#include "mesh/surface_mesh.hpp"

namespace rollcon {

struct SurfaceFrame {
  Vec3 x, d_xi, d_eta;  ///< point and derivatives
  Vec3 normal;          ///< d_xi x d_eta, not normalised: its length is the surface Jacobian
};

SurfaceFrame evaluate_surface(const SurfaceMesh& mesh, std::int64_t element, double xi, double eta);
/// Area and the volume that the surface encloses (divergence theorem); exact for the mesh's own
/// polynomial geometry.
double surface_area(const SurfaceMesh& mesh);
double enclosed_volume(const SurfaceMesh& mesh);
/// Longest distance between two corners of the element.
double element_diameter(const SurfaceMesh& mesh, std::int64_t element);

}  // namespace rollcon
