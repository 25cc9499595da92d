#pragma once
/// Declares the inner loops of stresses and displacements inside a half-space, one set of functions per instruction
/// set, chosen at run time. Everything here works on one observer at a time.
///
/// Both functions compute nine sums for forces f = (fx, fy, fz) at sources on the surface, with
/// d = observer - source, R = |d|, (a, b, c) = d/R, s = a fx + b fy, t = s + c fz, k = 1/(1 + c), kappa = 1 - 2 nu
/// (Boussinesq and Cerruti; docs/theory.md, inside of half-spaces):
///   2 pi stress = -3 t/R^2 (aa, bb, cc, ab, ac, bc) + kappa/R^2 (h + aa w - 2 kk a fx, h + bb w - 2 kk b fy, 0,
///                 ab w - kk (b fx + a fy), 0, 0),  h = fz (c - k) + s (1 - kk),  w = fz (2 + c) kk + s kk (1 + 2 k)
///   4 pi G u = (f + t (a, b, c))/R + kappa/R (k fx - k a (k s + fz), k fy - k b (k s + fz), k s + fz)

#include <cstdint>

#include "bodies/halfspace/kernels.hpp"

namespace rollcon::halfspace {

/// Counts the sums: stresses xx, yy, zz, xy, xz, yz, then displacements x, y, z.
inline constexpr int interior_count = 9;

/// Holds forces at points of the surface; arrays are padded with zero forces to a multiple of point_padding.
struct InteriorForces {
  int n = 0;
  const double *x = nullptr, *y = nullptr;
  const double* force[3] = {};
};

/// Holds an element with its tractions; coordinates are absolute.
struct InteriorElement {
  ElementType type = ElementType::tri3;
  double x[max_element_nodes], y[max_element_nodes];
  double traction[3][max_element_nodes];
};

/// Holds a point at depth z > 0.
struct InteriorPoint {
  double x, y, z;
};

struct InteriorKernels {
  const char* name;
  /// Adds to sum[interior_count].
  void (*push)(const InteriorForces& forces, const InteriorPoint& at, double kappa, double* sum);
  /// Adds one element to sum[interior_count]; pad_points() has padded its points.
  void (*element)(const InteriorElement& element, const NearPoints& points, const InteriorPoint& at, double kappa,
                  double* sum);
};

const InteriorKernels& interior_kernels(InstructionSet set);

/// Repeats the last point with weight 0 up to a multiple of point_padding, which n does not count.
void pad_points(NearPoints& points);

}  // namespace rollcon::halfspace
