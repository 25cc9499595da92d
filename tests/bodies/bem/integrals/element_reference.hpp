#pragma once
/// Integrates Kelvin's solution over one element by brute force: the element is cut until every part is small against
/// its distance (or, seen from a point on it, until every triangle is well shaped), then plain Gauss rules follow. It
/// also makes elements to try them on.

#include <array>
#include <cstdint>
#include <vector>

#include "bodies/bem/kelvin.hpp"
#include "mesh/surface_mesh.hpp"

namespace rollcon::element_reference {

struct Reference {
  double xi, eta;
};

/// Holds at t[3 * c + i][k] and u[3 * c + i][k] the entry (i, c) of T and U against shape function k.
struct Integrals {
  double t[9][max_element_nodes] = {};
  double u[9][max_element_nodes] = {};
  std::int64_t points = 0;
};

/// Returns T_ij and U_ij times G, in that order, row by row.
std::array<double, 18> kelvin(const Vec3& r, const Vec3& normal, double poisson);

/// Integrates for a point off the element.
Integrals integrate(const SurfaceMesh& element, const Vec3& point, double poisson);
/// Integrates for a point of the element, T against N_k(y) - N_k(x).
Integrals integrate_on(const SurfaceMesh& element, Reference at, double poisson);

/// Both have the library evaluate these integrals, in the same layout and with the same meaning.
Integrals from_library(const SurfaceMesh& element, const Vec3& point, double poisson, double tolerance_t,
                       double tolerance_u);
Integrals from_library_on(const SurfaceMesh& element, Reference at, double poisson, double tolerance_t,
                          double tolerance_u);

/// Applies the rule that the far field chooses for a pack of one point, for one kernel alone (bem::Terms); points = 0
/// when it leaves the element to the near field.
Integrals from_far_field(const SurfaceMesh& element, const Vec3& point, double poisson, int terms, double tolerance);

/// Returns the largest entry; below, the largest difference.
double largest(const double (&a)[9][max_element_nodes]);
double difference(const double (&a)[9][max_element_nodes], const double (&b)[9][max_element_nodes]);

/// Makes a mesh of one element with a longest side of about 2, stretched to aspect : 1, its nodes moved at random by up
/// to `distortion` of their distance within the plane, bent by `curvature` (height of the middle over the half-length),
/// and turned.
SurfaceMesh one_element(ElementType type, double aspect, double distortion, double curvature, std::uint32_t seed);
/// Returns position and normal (not normalised) at a reference point.
Vec3 position(const SurfaceMesh& element, Reference at);
Vec3 normal(const SurfaceMesh& element, Reference at);

}  // namespace rollcon::element_reference
