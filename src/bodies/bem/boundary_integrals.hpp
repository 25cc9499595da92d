#pragma once
/// Computes rows of the boundary integral equation (53)-(57) of an elastic body at collocation points on its surface,
/// with Kelvin's solution:
///
///   c u(x) + integral T(x, y) u(y) dS = integral U(x, y) t(y) dS
///
/// U_ij = ((3-4nu) d_ij + r_i r_j) / (16 pi G (1-nu) r), here times G (tractions enter as t/G); T_ij = -(dr/dn [(1-2nu)
/// d_ij + 3 r_i r_j] - (1-2nu)(r_i n_j - r_j n_i)) / (8 pi (1-nu) r^2), r = y - x, r_i its unit components, n the
/// outward normal at y. The strongly singular integral and the free term c are never formed: by rigid-body motion both
/// together are the sum over all elements of integral T (u(y) - u(x)), whose integrand is weakly singular on elements
/// with x. This holds at smooth points, edges and corners alike.

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>

#include "mesh/surface_mesh.hpp"

namespace rollcon::bem {

/// Names a point at which the equation is written: a node of the mesh (node >= 0), a point inside an element
/// (element >= 0 at xi, eta), or a point in space that is no node of this mesh (both -1; it may lie on, near or far
/// from the mesh; single layer only).
struct CollocationPoint {
  Vec3 x{};
  std::int32_t node = -1;
  std::int32_t element = -1;
  double xi = 0, eta = 0;
};

/// Counts points treated together, which is also the innermost dimension of the rows.
constexpr int lanes = 8;

class BoundaryIntegrals {
 public:
  /// Takes a mesh, which must outlive the object, in any unit of length (1e-60 to 1e60), and the error of each
  /// element's integrals relative to the largest entry of the row: for T the free term of a smooth point, for U the
  /// largest integral of an element whose traction is wanted. Each element gets a fifth of it, so that sums keep it as
  /// well.
  BoundaryIntegrals(const SurfaceMesh& mesh, double poisson, double tolerance);
  ~BoundaryIntegrals();

  /// Overwrites rows at 1 to `lanes` points; unused lanes are left zero. Safe for several threads.
  ///   h (null: not wanted): h[((3 * node + c) * 3 + i) * lanes + p] is component i of the equation at point p, for
  ///     displacement component c of `node`; free term included. 9 * lanes * nodes doubles.
  ///   g (null: not wanted): g[((3 * k + c) * 3 + i) * lanes + p] is component i of the equation at point p, for
  ///     component c of the traction over G of column k = g_column[entry of the mesh's connectivity] < g_columns;
  ///     entries with g_column -1 carry no wanted traction and their elements are skipped when all are -1.
  /// Fails with err_internal on more than `lanes` points, or h at a point that is not on the mesh.
  void rows(std::span<const CollocationPoint> points, double* h, const std::int32_t* g_column, std::int64_t g_columns,
            double* g) const;

  /// Names elements and the columns that their integrals go to; -1: none.
  struct Columns {
    std::span<const std::int32_t> element;  ///< elements, each once
    const std::int32_t* h = nullptr;        ///< by node of the mesh
    std::int64_t h_count = 0;
    const std::int32_t* g = nullptr;  ///< by entry of the mesh's connectivity
    std::int64_t g_count = 0;
  };
  /// Overwrites rows as rows() does, with integrals over some elements alone: column k of h is laid out as node k is in
  /// rows(). The free term is that of the elements with the point.
  void rows_over(std::span<const CollocationPoint> points, const Columns& columns, double* h, double* g) const;
  /// Overwrites 9 * lanes doubles with what the free term still lacks, with opposite sign: the sum of the blocks of all
  /// nodes over the elements without the point.
  void sums(std::span<const CollocationPoint> points, double* total) const;

  /// Returns the number of kernel evaluations (U and T together count once per point and quadrature point).
  std::int64_t kernel_evaluations() const;
  std::size_t bytes() const;

 private:
  struct Data;
  class Rows;
  std::unique_ptr<Data> data_;
};

}  // namespace rollcon::bem
