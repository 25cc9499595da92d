#pragma once
/// Computes points, tangents and normals of curved elements.

#include <cstdint>

#include "mesh/shape.hpp"
#include "mesh/surface_mesh.hpp"

namespace rollcon {

struct SurfaceFrame {
  Vec3 x, d_xi, d_eta;  ///< point and derivatives
  Vec3 normal;          ///< d_xi x d_eta, not normalised: its length is the surface Jacobian
};

/// Returns the element's point for these shape functions, relative to `origin`, so that coordinates of a small element
/// far away do not lose digits.
SurfaceFrame combine(const SurfaceMesh& mesh, std::int64_t element, const Shape& shape, const Vec3& origin);
SurfaceFrame evaluate_surface(const SurfaceMesh& mesh, std::int64_t element, double xi, double eta);
/// Returns the unit normal; the zero vector where the Jacobian vanishes.
Vec3 unit_normal(const SurfaceMesh& mesh, std::int64_t element, double xi, double eta);
/// Returns the vector over its length, also where its square over- or underflows; zero stays zero.
Vec3 normalized(const Vec3& v);
/// Returns the angle between two vectors in [0, pi], exact for small angles.
double angle_between(const Vec3& a, const Vec3& b);
/// Returns the angle of the element at its node `local`, in radians: between the edges at a corner, pi at a midside
/// node, 2 pi at the centre.
double angle_at_node(const SurfaceMesh& mesh, std::int64_t element, int local);

/// Returns the area, exact for flat elements, else by a Gauss rule of degree 11.
double element_area(const SurfaceMesh& mesh, std::int64_t element);
/// Returns the signed volume of the cone from the apex to the element, positive when its normal looks away from the
/// apex. It is exact for the mesh's own polynomial geometry.
double cone_volume(const SurfaceMesh& mesh, std::int64_t element, const Vec3& apex);
/// Returns the volume that a closed surface encloses, from cones with their apex near it. It is negative when the
/// normals look inwards.
double enclosed_volume(const SurfaceMesh& mesh);
/// Returns the longest distance between two corners of the element.
double element_diameter(const SurfaceMesh& mesh, std::int64_t element);

}  // namespace rollcon
