#pragma once
/// Makes traction nodes: displacement is single-valued at a node, traction is not, but has one value for each smooth
/// fan of elements around the node.

#include <cstdint>
#include <vector>

#include "mesh/surface_mesh.hpp"

namespace rollcon {

/// Groups elements around nodes. Neighbouring elements are joined across their edge when they carry equal tags and
/// their normals at the middle of the edge differ by at most the given angle; elements around a node that are joined
/// across edges at the node, directly or through others, are one fan. An edge is thus sharp or smooth over its whole
/// length; where a sharp edge ends on a smooth surface, its last node has one fan, reached the other way round.
struct TractionNodes {
  std::vector<std::int32_t> of;     ///< traction node of each entry of the mesh's connectivity
  std::vector<std::int32_t> node;   ///< mesh node of each traction node, ascending
  std::vector<std::int64_t> start;  ///< traction nodes of mesh node i: start[i] to start[i + 1]
  std::vector<Vec3> normal;         ///< unit normal of each fan: the mean, weighted by the angle at the node

  std::int64_t size() const { return static_cast<std::int64_t>(node.size()); }
};

/// Splits nodes at edges sharper than edge_angle, in degrees; angles that exceed it by rounding alone (1e-6 degrees) do
/// not split. The mesh must have passed check_surface. Fans of a node are numbered by their first element.
TractionNodes split_at_edges(const SurfaceMesh& mesh, double edge_angle);

}  // namespace rollcon
