#pragma once
/// Fields inside of a body with volume elements, under given displacements of its nodes.

#include <cstdint>

#include "mesh/vec3.hpp"

namespace rollcon {

/// Stresses: 11, 22, 33, 12, 13, 23 of the body's axes. u[3 * node + c] of all nodes. Safe for several threads.
class BodyInterior {
 public:
  virtual ~BodyInterior() = default;
  /// Integration points of all elements, element by element.
  virtual std::int64_t points() const = 0;
  /// Of the elements' own stresses there, stress[6 * point + c], and the points' places; either may be null.
  virtual void at_points(const double* u, double* stress, double* xyz, int threads) const = 0;
  /// Smoothed: of polynomials over the elements around nodes inside, or of linear functions, nearest to each element's
  /// own stresses, averaged over the elements of a node by their volumes. stress[6 * node + c].
  virtual void at_nodes(const double* u, double* stress, int threads) const = 0;
  /// u, and smoothed stresses at nodes, interpolated by the elements' shape functions. Arrays may be null. False: the
  /// point is outside, nothing is written.
  virtual bool interpolate(const Vec3& x, const double* u, const double* node_stress, double* displacement,
                           double* stress) const = 0;
};

}  // namespace rollcon
