#pragma once
/// Checks a volume mesh, and makes its boundary a surface mesh.

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/surface_mesh.hpp"
#include "mesh/vec3.hpp"
#include "mesh/volume_mesh.hpp"

namespace rollcon {

struct BoundaryFace {
  std::int64_t element = 0;
  std::int32_t side = 0;  ///< number of the side; see faces_of
};

/// Returns the faces that belong to one element, by element, then side. It never throws for bad shapes, because it
/// looks only at connectivity.
std::vector<BoundaryFace> boundary_faces(const VolumeElements& volume);

/// Returns boundary faces as surface elements, in their order, looking outwards, all with tag 0. The places of the
/// nodes are left empty: they are the volume's, numbers included.
SurfaceMesh boundary_surface(const VolumeElements& volume, std::span<const BoundaryFace> face);

/// Throws Error(err_mesh) naming, in the caller's index base, the first offending elements or nodes and their count, in
/// this order: nodes out of range, a node twice in an element, an element twice; nodes of no element; elements
/// that are degenerate or turned inside out (Jacobian not positive everywhere: at the nodes and at the points of the
/// rule of the stiffness); different nodes at one place; faces of more than two elements; faces that meet without
/// matching (a quadrilateral on triangles, a quadratic one on linear ones, midside nodes not shared); parts that share
/// no face (a body must be connected).
void check_volume(std::span<const Vec3> node, const VolumeElements& volume, std::int32_t index_base);

}  // namespace rollcon
