#pragma once
/// Declares the inner loops of Somigliana's identities for displacement and stress inside a body, one set of functions
/// per instruction set, chosen at run time. They take one observer x at a time and packs of quadrature points y.
///
/// With r = |y - x|, e = (y - x)/r, the area vector m (outward), force f = t dA and displacement v of y, G = 1,
/// c = 1/(8 pi (1 - nu)), k = 1 - 2 nu, and a = e.f, b = e.v, d = e.m, w = m.v:
///   u      = c/(2r) ((3 - 4 nu) f + a e) + c/r^2 (d (k v + 3 b e) + k (b m - w e))
///   stress = P e^T + e P^T + Q (m v^T + v m^T) + E e e^T + D I,
///   P = c k/r^2 f - 6 nu c/r^3 (d v + b m),   Q = -2 c k/r^3,   E = 3 c a/r^2 - 2 c/r^3 (3 k w - 15 d b),
///   D = -c k a/r^2 - 2 c/r^3 (3 k d b - (1 - 4 nu) w)
/// A linear field, which satisfies both identities by itself, is taken away from f and v first: what is left vanishes
/// at the point of the surface whose field it is, and the integrands are weakly singular there.

#include "mesh/element_type.hpp"
#include "quadrature/near_points.hpp"
#include "support/instruction_set.hpp"

namespace rollcon::bem {

using quadrature::NearPoints;

/// Counts the sums: stresses 11, 22, 33, 12, 13, 23, three displacements, and the solid angle, integral d/r^2.
inline constexpr int somigliana_count = 10;

/// Describes a face under load; tractions are over G, and all lengths have one unit.
struct LoadedFace {
  ElementType type = ElementType::tri3;
  double node[3][max_element_nodes], u[3][max_element_nodes], traction[3][max_element_nodes];
};

/// Holds u at the observer, its gradient [i][j] = du_i/dx_j, and the stress over G.
struct LinearField {
  double u[3] = {}, gradient[3][3] = {}, stress[6] = {};
};

struct SomiglianaKernels {
  const char* name;
  /// Adds a face to sum[somigliana_count]; points is padded in place.
  void (*face)(const LoadedFace& face, NearPoints& points, const double* x, double poisson, const LinearField& linear,
               double* sum);
};

const SomiglianaKernels& somigliana_kernels(InstructionSet set);

}  // namespace rollcon::bem
