#pragma once
/// From nodal tractions to consistent nodal loads: integrals of products of shape functions, M_ij = int N_i N_j (61),
/// of one surface mesh or of two that lie on one another.

#include <cstdint>
#include <span>
#include <vector>

#include "linalg/sparse_matrix.hpp"
#include "mesh/surface_mesh.hpp"

namespace rollcon {

/// Column r belongs to node `node[r]` of the body, rows to nodes of the mesh that carries the tractions; values are
/// areas.
struct SurfaceCoupling : SparseMatrix {
  std::vector<std::int32_t> node;  ///< ascending
  /// Every element of the layer is a face of the body or has the corners of one: its tractions are among those that the
  /// faces' own shape functions can give.
  bool in_faces = false;
};

/// Faces of one mesh, ascending: columns are its nodes too.
SurfaceCoupling couple_faces(const SurfaceMesh& mesh, std::span<const std::int64_t> face);

/// Faces of a body and a mesh that lies on them (its nodes are on the body's surface, its elements look the same way):
/// M_ij = int N_i N_j over the layer, N_i of the face that lies under the point along the normal of the layer element's
/// mean plane. Integrated over the intersections of both meshes, so that constant tractions give exactly the loads that
/// the body's own faces would (the contact patch test: to rounding on flat meshes with straight sides, also distorted
/// ones; on curved ones to second order). What of the layer lies over no face goes to the nearest one: the sum over i
/// is always int N_j over the layer. Layer elements that are faces of the body, node for node, are coupled as
/// couple_faces does, and linear ones with the corners of a quadratic face over that face. No faces: an empty matrix.
SurfaceCoupling couple_layer(const SurfaceMesh& body, std::span<const std::int64_t> face, const SurfaceMesh& layer);

}  // namespace rollcon
