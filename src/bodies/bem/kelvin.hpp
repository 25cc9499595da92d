#pragma once
/// Declares the inner loops of the integrals of Kelvin's solution, one set of functions per instruction set, chosen at
/// run time.
///
/// far() takes up to eight collocation points at once, one per lane, which share the quadrature points of an element.
/// near() takes one collocation point and eight quadrature points at once.

#include <cstdint>

#include "mesh/element_type.hpp"
#include "quadrature/near_points.hpp"
#include "support/instruction_set.hpp"

namespace rollcon::bem {

using quadrature::near_capacity;
using quadrature::NearPoints;

/// Counts the collocation points of one call of far().
inline constexpr int pack_points = 8;
/// Pads arrays of quadrature points to a multiple of this.
inline constexpr int point_padding = 8;
/// Counts the quadrature points of the largest rule of the far field, padding included.
inline constexpr int far_capacity = 64;
/// Says whether integrals of T (double layer), of U (single layer), or of both are wanted.
enum Terms : int { double_layer = 1, single_layer = 2, both_layers = 3 };

/// Holds the factors of U_ij = iso d_ij/r + single r_i r_j/r and
/// T_ij = skew (dn d_ij - r_i n_j + r_j n_i)/r^2 + triple dn r_i r_j/r^2; r_i unit, dn = dr/dn.
struct KelvinConstants {
  double skew, triple, iso, single;
  explicit KelvinConstants(double poisson);
};

/// Points to values of the shape functions and their derivatives at the points of a rule, value[k * padded + q];
/// padding repeats the last point with weight 0.
struct RuleTable {
  int n = 0, padded = 0;
  const double *value = nullptr, *d_xi = nullptr, *d_eta = nullptr, *w = nullptr;
};

/// Holds the points of one rule on one element.
struct FarPoints {
  alignas(64) double y[3][far_capacity];
  alignas(64) double n[3][far_capacity];  ///< outward normal times weight times Jacobian
  alignas(64) double w[far_capacity];     ///< weight times Jacobian
};

/// Holds collocation points x[component][lane]; lanes with mask 0 get nothing, but their x must lie off the element,
/// too.
struct PointPack {
  alignas(64) double x[3][pack_points];
  alignas(64) double mask[pack_points];
};

/// Holds the nodes of an element relative to the collocation point: node[component][k].
struct NearElement {
  ElementType type = ElementType::tri3;
  double node[3][max_element_nodes];
};

/// Holds integrals over one element seen from one point: entry (c, i) of T with shape function k is t[3 * c + i][k],
/// and u[.][k] are entries (0,0) (0,1) (0,2) (1,1) (1,2) (2,2) of U.
struct NearIntegrals {
  double t[9][max_element_nodes];
  double u[6][max_element_nodes];
};

struct Kernels {
  const char* name;
  /// Places the points of a rule on the element with the given nodes (absolute coordinates).
  void (*place)(const RuleTable& rule, int nodes, const double (*node)[max_element_nodes], FarPoints& points);
  /// Adds to h[k] and g[k], blocks of 9 * pack_points doubles for local node k; see BoundaryIntegrals::rows. Blocks of
  /// terms not wanted are not looked at.
  void (*far)(const FarPoints& points, const RuleTable& rule, int nodes, const PointPack& pack,
              const KelvinConstants& constants, int terms, double* const* h, double* const* g);
  /// Adds to the wanted integrals. points is padded in place.
  void (*near)(const NearElement& element, NearPoints& points, const KelvinConstants& constants, int terms,
               NearIntegrals& integrals);
};

const Kernels& kelvin_kernels(InstructionSet set);

}  // namespace rollcon::bem
