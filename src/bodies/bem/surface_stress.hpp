#pragma once
/// Computes the gradient of displacement and the stress on a surface from the displacements along it and the tractions.

#include <cstdint>
#include <vector>

#include "bodies/bem/somigliana_kernels.hpp"
#include "mesh/surface_mesh.hpp"

namespace rollcon::bem {

/// Holds fields on a surface mesh; tractions and stresses are over G.
struct SurfaceValues {
  const SurfaceMesh& mesh;
  std::vector<double> u;         ///< displacements [3 * node + c]
  std::vector<double> traction;  ///< tractions by entry of the connectivity, [3 * k + c]
  double poisson = 0;

  /// Returns the element's own fields at a place on it; `more` is added to the traction of the values.
  LinearField field(std::int64_t element, double xi, double eta, const Vec3& more) const;
  Vec3 traction_at(std::int64_t element, double xi, double eta) const;
};

/// Holds tractions, by entry of the connectivity, that are added to those of the values.
using TractionBesides = std::vector<Vec3>;

/// Returns stresses at the nodes of each element, [6 * entry + c] of the connectivity: averages by area over the
/// elements with the same tag around the node whose normals there are within edge_angle (degrees).
std::vector<double> smoothed_stresses(const SurfaceValues& values, const TractionBesides& more, double edge_angle);

/// Averages the stresses at each node over all its elements, by area.
std::vector<double> stresses_at_nodes(const SurfaceMesh& mesh, const std::vector<double>& smoothed);

/// Interpolates one element's nodal stresses.
void interpolate_stress(const SurfaceMesh& mesh, const std::vector<double>& smoothed, std::int64_t element, double xi,
                        double eta, double* stress);

}  // namespace rollcon::bem
