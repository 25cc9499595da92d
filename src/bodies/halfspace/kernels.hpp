#pragma once
/// Declares the inner loops of the half-space integrals, one set of functions per instruction set, chosen at run time.
/// Everything here works on one observer at a time.
///
/// The five integrals of a shape function N, with d = observer - source and r = |d|:
///   0: N/r   1: N dx^2/r^3   2: N dx dy/r^3   3: N dx/r^2   4: N dy/r^2

#include <cstdint>

#include "mesh/element_type.hpp"
#include "quadrature/near_points.hpp"
#include "support/instruction_set.hpp"

namespace rollcon::halfspace {

using quadrature::NearPoints;

inline constexpr int integral_count = 5;
/// Pads arrays of quadrature points to a multiple of this.
inline constexpr int point_padding = 8;
/// Pads rows of a table of shape functions to a multiple of this.
inline constexpr int shape_padding = 8;
inline constexpr int max_shape_stride = 16;
/// Counts the points of the largest rule of the far field.
inline constexpr int far_capacity = 64;

/// Says which integrals are wanted besides 0: bit 0 wants d d^T/r^3, bit 1 wants d/r^2.
enum Terms : int { normal_only = 0, with_shear = 1, with_coupling = 2, all_terms = 3 };

/// Returns the terms that integral k belongs to.
constexpr int integral_terms(int k) {
  return k == 0 ? normal_only : k < 3 ? with_shear : with_coupling;
}

/// Points to one rule on all elements of a group; element e owns entries [e * padded, e * padded + n).
struct FarSources {
  int n = 0, padded = 0;
  const double *x = nullptr, *y = nullptr;
  const double* w = nullptr;      ///< weight times Jacobian
  const double* shape = nullptr;  ///< n rows of the shape functions' values
  int nodes = 0, stride = 0;      ///< values and padded length of a row of shape
};

/// Points to tractions at the far sources: three forces per point (weights included).
struct FarForces {
  int padded = 0, n = 0;
  const double *x = nullptr, *y = nullptr;
  const double* force[3] = {};
};

/// Holds coordinates of an element's nodes relative to the observer.
struct NearElement {
  ElementType type = ElementType::tri3;
  double x[max_element_nodes], y[max_element_nodes];
};

struct Kernels {
  const char* name;
  /// Overwrites integral[k * max_shape_stride + i]; k runs over the wanted integrals only.
  void (*far)(const FarSources& rule, std::int64_t element, double px, double py, int terms, double* integral);
  /// Adds to u the displacement at the observer by the forces of one element; constants: cn, cv, ck.
  void (*push)(const FarForces& rule, std::int64_t element, double px, double py, const double* constants, int terms,
               double* u);
  /// Adds to integral[k * max_shape_stride + i]; points is padded in place.
  void (*near)(const NearElement& element, NearPoints& points, int terms, double* integral);
};

const Kernels& kernels(InstructionSet set);

}  // namespace rollcon::halfspace
