#pragma once
/// What a body with a mesh does under tractions on its surface, and the fields inside of it that follow.

#include <cstdint>
#include <vector>

#include "mesh/surface_mesh.hpp"

namespace rollcon {

/// A state in the body's axes; lengths and tractions in the caller's units.
struct SurfaceState {
  std::vector<double> u;  ///< displacement of every node, [3 * node + c]
  // Boundary elements: tractions on the body. Those on its own faces by entry of the mesh's connectivity, [3 * k + c];
  // those of a frame that is laid on the surface by the frame's nodes.
  std::vector<double> traction;
  SurfaceMesh layer;
  std::vector<double> layer_traction;
};

/// Fields inside of a body. Stresses: 11, 22, 33, 12, 13, 23 of the body's axes. err_argument: a point is outside.
class BodyFields {
 public:
  virtual ~BodyFields() = default;
  /// displacement[3 * p + c]; stress[6 * p + c], smoothed; either may be null. Points on the surface take its own
  /// fields.
  virtual void at_points(std::int64_t n, const double* xyz, double* displacement, double* stress,
                         int threads) const = 0;
  /// stress[6 * node + c]. Finite elements: of polynomials over the elements around nodes inside, or of linear
  /// functions, nearest to each element's own stresses, averaged over the elements of a node by their volumes. Boundary
  /// elements: averages over all elements of a node by area, over edges as well.
  virtual void at_nodes(double* stress, int threads) const = 0;
};

/// Integration points of a body with volume elements. Safe for several threads.
class IntegrationPoints {
 public:
  /// All of them, element by element.
  virtual std::int64_t points() const = 0;
  /// The elements' own stresses there under displacements u[3 * node + c], stress[6 * point + c], and the points'
  /// places; either may be null.
  virtual void at_points(const double* u, double* stress, double* xyz, int threads) const = 0;

 protected:
  ~IntegrationPoints() = default;
};

}  // namespace rollcon
