#pragma once
/// Gradient of displacement and stress on a surface, from the displacements along it and the tractions (Hooke's law).

#include <cstdint>
#include <vector>

#include "bodies/bem/somigliana_kernels.hpp"
#include "mesh/surface_mesh.hpp"

namespace rollcon::bem {

/// Fields on a surface mesh; tractions and stresses over G.
struct SurfaceValues {
  const SurfaceMesh& mesh;
  std::vector<double> u;         ///< [3 * node + c]
  std::vector<double> traction;  ///< by entry of the connectivity, [3 * k + c]
  double poisson = 0;

  /// Takes the element's own fields at a place of it. more: traction besides that of the values.
  LinearField field(std::int64_t element, double xi, double eta, const Vec3& more) const;
  Vec3 traction_at(std::int64_t element, double xi, double eta) const;
};

/// more: as above.
using TractionBesides = std::vector<Vec3>;

/// Stresses at the nodes of each element, [6 * entry + c] of the connectivity: averages by area over the elements with
/// the same tag around the node whose normals there are within edge_angle (degrees). more: by entry.
std::vector<double> smoothed_stresses(const SurfaceValues& values, const TractionBesides& more, double edge_angle);

/// Averages at each node over all its elements, by area.
std::vector<double> stresses_at_nodes(const SurfaceMesh& mesh, const std::vector<double>& smoothed);

/// Interpolates one element's nodal stresses.
void interpolate_stress(const SurfaceMesh& mesh, const std::vector<double>& smoothed, std::int64_t element, double xi,
                        double eta, double* stress);

}  // namespace rollcon::bem
