#pragma once
/// Describes what a body with a mesh does under tractions on its surface, and the fields inside of it that follow.

#include <cstdint>
#include <vector>

#include "mesh/surface_mesh.hpp"

namespace rollcon {

/// Holds a state in the body's axes; lengths and tractions are in the caller's units.
struct SurfaceState {
  std::vector<double> u;  ///< displacement of every node, [3 * node + c]
  // Boundary elements also have tractions: on their own faces by entry of the mesh's connectivity, [3 * k + c], and on
  // a frame that is laid on the surface by the frame's nodes.
  std::vector<double> traction;
  SurfaceMesh layer;
  std::vector<double> layer_traction;  ///< sections: forces on the stretches of their surface
  bool loads_alone = false;            ///< true: sections need not find displacements
  // Sections that creep:
  double rate = 0;            ///< angle per time at which they pass by
  std::vector<double> power;  ///< power lost in each harmonic, from 0 on
};

/// Gives fields inside of a body; stresses are 11, 22, 33, 12, 13, 23 in its axes. err_argument: a point is outside.
class BodyFields {
 public:
  virtual ~BodyFields() = default;
  /// Returns displacement[3 * p + c] and smoothed stress[6 * p + c]; either may be null. Points on the surface take its
  /// own fields.
  virtual void at_points(std::int64_t n, const double* xyz, double* displacement, double* stress,
                         int threads) const = 0;
  /// Returns stress[6 * node + c]. Finite elements take it from polynomials over the elements around nodes inside, or
  /// from linear functions, nearest to each element's own stresses, averaged over the elements of a node by their
  /// volumes. Boundary elements average over all elements of a node by area, over edges as well.
  virtual void at_nodes(double* stress, int threads) const = 0;
};

/// Gives stresses at the integration points of a body with volume elements. Safe for several threads.
class IntegrationPoints {
 public:
  /// Returns the number of all points, which are numbered element by element.
  virtual std::int64_t points() const = 0;
  /// Returns the elements' own stress[6 * point + c] under displacements u[3 * node + c], and the points' places;
  /// either may be null.
  virtual void at_points(const double* u, double* stress, double* xyz, int threads) const = 0;
  virtual ~IntegrationPoints() = default;
};

}  // namespace rollcon
