#pragma once
/// Smooths the tractions on a frame finer than the faces of finite elements, which feel only what varies over some
/// faces: a field s with
///   (M + L) s = B t,   M_ij = int N_i N_j,   L_ij = share^2 int d N_i . d N_j,
/// where d are derivatives over the face's own size. Uniform tractions stay as they are, forces are kept, and what
/// varies from node to node, which finite elements answer badly, is left to a half-space (docs/theory.md, section 10).

#include <cstdint>
#include <span>
#include <vector>

#include "bodies/model/surface_response.hpp"
#include "geometry/surface_coupling.hpp"
#include "linalg/dense.hpp"
#include "linalg/sparse_factor.hpp"
#include "mesh/traction_nodes.hpp"

namespace rollcon {

struct FeltTractions {
  std::vector<std::int32_t> node;  ///< nodes of the faces, ascending
  RowMatrix<double> traction;      ///< s at these nodes for each column of the coupling; empty: s is t
  RowMatrix<double> load;          ///< M s

  /// Moves s to where compliances look for it.
  void tell(SurfaceOutline& outline) {
    if (traction.rows() == 0) return;
    outline.seen_node = std::move(node);
    outline.seen = std::move(traction);
  }
};

/// Returns the coupling as a dense matrix with a row for each of its nodes; column: its columns, ascending.
RowMatrix<double> columns_of(const SurfaceCoupling& coupling, std::span<const std::int32_t> column);

/// Returns the share of each face: 0 under a frame as coarse as the body, whose tractions are felt as they are, growing
/// to the spacing of the face's nodes over its size under a much finer one. Faces at sharp edges of the body, near
/// which it is no half-space, have 0, too.
std::vector<double> smoothing_shares(const SurfaceMesh& surface, const TractionNodes& fans,
                                     std::span<const std::int64_t> face, const SurfaceCoupling& coupling);

/// Solves for s. coupling: B, all of whose nodes belong to the faces; column: its columns, in this order; share: by
/// face, where 0 makes s the projection of t.
FeltTractions felt_tractions(const SurfaceMesh& surface, std::span<const std::int64_t> face,
                             std::span<const double> share, const SurfaceCoupling& coupling,
                             std::span<const std::int32_t> column);

}  // namespace rollcon
