#pragma once
/// What a body with a mesh does under tractions on its surface, and the fields inside of it that follow.

#include <cstdint>
#include <vector>

#include "mesh/surface_mesh.hpp"

namespace rollcon {

/// In the body's axes; lengths and tractions in the caller's units.
struct SurfaceState {
  std::vector<double> u;  ///< displacement of every node, [3 * node + c]
  // Boundary elements: tractions on the body. Those on its own faces by entry of the mesh's connectivity, [3 * k + c];
  // those of a frame that is laid on the surface by the frame's nodes.
  std::vector<double> traction;
  SurfaceMesh layer;
  std::vector<double> layer_traction;
};

/// Fields of a body that has elements on its surface alone.
class SurfaceFields {
 public:
  virtual ~SurfaceFields() = default;
  /// displacement[3 * p + c]; stress[6 * p + c]: 11, 22, 33, 12, 13, 23; either may be null. Points on the surface take
  /// its own fields. err_argument: a point is outside, or a result overflows; nothing is written then.
  virtual void at_points(std::int64_t n, const double* xyz, double* displacement, double* stress,
                         int threads) const = 0;
  /// stress[6 * node + c], averaged over all elements of a node by area, over edges as well.
  virtual void at_nodes(double* stress) const = 0;
};

}  // namespace rollcon
