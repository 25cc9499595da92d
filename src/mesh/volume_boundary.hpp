#pragma once
/// Checks of a volume mesh, and its boundary as a surface mesh.

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/surface_mesh.hpp"
#include "mesh/vec3.hpp"
#include "mesh/volume_mesh.hpp"

namespace rollcon {

struct BoundaryFace {
  std::int64_t element = 0;
  std::int32_t side = 0;  ///< see faces_of
};

/// Faces that belong to one element, by element, then side. Never throws for bad shapes: only connectivity is looked
/// at.
std::vector<BoundaryFace> boundary_faces(const VolumeElements& volume);

/// Those faces as surface elements, in their order, looking outwards, all with tag 0. The nodes' places are left empty:
/// they are the volume's, numbers included.
SurfaceMesh boundary_surface(const VolumeElements& volume, std::span<const BoundaryFace> face);

/// Throws Error(err_mesh) naming, in the caller's index base, the first offending elements or nodes and their count, in
/// this order: nodes out of range, a node twice in an element, the same element twice; nodes of no element; elements
/// that are degenerate or turned inside out (Jacobian not positive everywhere: at the nodes and at the points of the
/// rule of the stiffness); different nodes at one place; faces of more than two elements; faces that meet without
/// matching (a quadrilateral on triangles, a quadratic one on linear ones, midside nodes not shared); parts that share
/// no face (a body must be connected).
void check_volume(std::span<const Vec3> node, const VolumeElements& volume, std::int32_t index_base);

}  // namespace rollcon
