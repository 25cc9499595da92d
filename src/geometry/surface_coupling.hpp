#pragma once
/// Turns nodal tractions into consistent nodal loads by integrals of products of shape functions, M_ij = int N_i N_j
/// (61), over one surface mesh or two that lie on one another.

#include <cstdint>
#include <span>
#include <vector>

#include "linalg/sparse_matrix.hpp"
#include "mesh/surface_mesh.hpp"

namespace rollcon {

/// Column r belongs to node `node[r]` of the body, rows to nodes of the mesh that carries the tractions; values are
/// areas.
struct SurfaceCoupling : SparseMatrix {
  std::vector<std::int32_t> node;  ///< nodes of the body, ascending
  /// True if every element of the layer is a face of the body or has the corners of one; the faces' own shape functions
  /// can then give its tractions.
  bool in_faces = false;
};

/// Couples faces of one mesh, in ascending order; the columns are its nodes, too.
SurfaceCoupling couple_faces(const SurfaceMesh& mesh, std::span<const std::int64_t> face);

/// Couples faces of a body with a mesh that lies on them (its nodes are on the body's surface, its elements look the
/// same way): M_ij = int N_i N_j over the layer, with N_i of the face that lies under the point along the normal of the
/// layer element's mean plane. Integrates over the intersections of both meshes, so that constant tractions give
/// exactly the loads that the body's own faces would (the contact patch test: to rounding on flat meshes with straight
/// sides, also distorted ones; on curved ones to second order). Parts of the layer that lie over no face go to the
/// nearest one: the sum over i is always int N_j over the layer. Layer elements that are faces of the body, node for
/// node, are coupled as couple_faces does, and linear ones with the corners of a quadratic face over that face. No
/// faces give an empty matrix.
SurfaceCoupling couple_layer(const SurfaceMesh& body, std::span<const std::int64_t> face, const SurfaceMesh& layer);

}  // namespace rollcon
