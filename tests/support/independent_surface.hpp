#pragma once
/// Computes local axes and integrals of curved frames once more, written from their description (docs/theory.md,
/// section 11) for the tests alone.

#include <array>
#include <vector>

#include "mesh/surface_mesh.hpp"

namespace rollcon::laws {

/// Holds in rows the rolling direction in the tangent plane, across, and normal.
using Axes3 = std::array<Vec3, 3>;
Axes3 axes_of(const Vec3& rolling, const Vec3& normal);

/// Returns local (t1, t2, n) of every node of a surface whose faces are smooth all over, as rows in the axes: normals
/// of the elements at the node, in mean by the angle there, inclined along the rolling direction like the axes' normal
/// (the surface at the origin has that one).
std::vector<Axes3> surface_triads(const SurfaceMesh& mesh, const Axes3& axes);

/// Integrates every shape function N over the surface itself, N x and N y, from the origin along the axes.
std::vector<std::array<double, 3>> surface_integrals(const SurfaceMesh& mesh, const Vec3& origin, const Axes3& axes);

}  // namespace rollcon::laws
