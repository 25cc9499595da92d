#pragma once
/// Inner loops of the integrals of Kelvin's solution, one set of functions per instruction set, chosen at run time as
/// those of the half-space are.
///
/// far(): up to eight collocation points at once, one per lane, share the quadrature points of an element. near(): one
/// collocation point, eight quadrature points at once.

#include <cstdint>

#include "mesh/element_type.hpp"
#include "quadrature/near_points.hpp"
#include "support/instruction_set.hpp"

namespace rollcon::bem {

using quadrature::near_capacity;
using quadrature::NearPoints;

/// Collocation points of one call of far().
inline constexpr int pack_points = 8;
/// Arrays of quadrature points are padded to a multiple of this.
inline constexpr int point_padding = 8;
/// Quadrature points of the largest rule of the far field, padding included.
inline constexpr int far_capacity = 64;
/// Which integrals are wanted: those of T (double layer), of U (single layer), or both.
enum Terms : int { double_layer = 1, single_layer = 2, both_layers = 3 };

/// Factors of U_ij = iso d_ij/r + single r_i r_j/r and of
/// T_ij = skew (dn d_ij - r_i n_j + r_j n_i)/r^2 + triple dn r_i r_j/r^2; r_i unit, dn = dr/dn.
struct KelvinConstants {
  double skew, triple, iso, single;
  explicit KelvinConstants(double poisson);
};

/// Values of the shape functions and their derivatives at the points of a rule:
/// value[k * padded + q]; padding repeats the last point with weight 0.
struct RuleTable {
  int n = 0, padded = 0;
  const double *value = nullptr, *d_xi = nullptr, *d_eta = nullptr, *w = nullptr;
};

/// The points of one rule on one element.
struct FarPoints {
  alignas(64) double y[3][far_capacity];
  alignas(64) double n[3][far_capacity];  ///< outward normal times weight times Jacobian
  alignas(64) double w[far_capacity];     ///< weight times Jacobian
};

/// Collocation points x[component][lane]; lanes with mask 0 get nothing (their x must lie off the element all the
/// same).
struct PointPack {
  alignas(64) double x[3][pack_points];
  alignas(64) double mask[pack_points];
};

/// Nodes of an element relative to the collocation point: node[component][k].
struct NearElement {
  ElementType type = ElementType::tri3;
  double node[3][max_element_nodes];
};

/// Integrals over one element seen from one point; entry (c, i) of T with shape function k is t[3 * c + i][k]; u
/// likewise, in the order of the entries (0,0) (0,1) (0,2) (1,1) (1,2) (2,2).
struct NearIntegrals {
  double t[9][max_element_nodes];
  double u[6][max_element_nodes];
};

struct Kernels {
  const char* name;
  /// Points of a rule on the element with the given nodes (absolute coordinates).
  void (*place)(const RuleTable& rule, int nodes, const double (*node)[max_element_nodes], FarPoints& points);
  /// h[k], g[k]: blocks of 9 * pack_points doubles of local node k, added to; see BoundaryIntegrals::rows. Those of
  /// terms not wanted are not looked at.
  void (*far)(const FarPoints& points, const RuleTable& rule, int nodes, const PointPack& pack,
              const KelvinConstants& constants, int terms, double* const* h, double* const* g);
  /// Adds to the wanted integrals. points is padded in place.
  void (*near)(const NearElement& element, NearPoints& points, const KelvinConstants& constants, int terms,
               NearIntegrals& integrals);
};

const Kernels& kelvin_kernels(InstructionSet set);

}  // namespace rollcon::bem
