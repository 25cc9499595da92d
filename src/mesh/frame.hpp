#pragma once
/// Defines the contact frame: the mesh on which tractions live. Its nodes are given in space; their projection on the
/// tangent plane of the axes (t1, t2) gives the coordinates x, y of the surface, so a frame may be curved as long as it
/// projects without folding. Half-spaces see the projection alone, or the frame unrolled where it has a section. Bodies
/// with a mesh give every node a local triad (curve_frame).

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "mesh/section_line.hpp"
#include "mesh/strip_layout.hpp"
#include "mesh/surface_mesh.hpp"

namespace rollcon {

/// Holds the origin and the right-handed orthonormal triad (t1 rolling direction, t2, n outward normal of body 1).
struct Axes {
  Vec3 origin{0, 0, 0};
  Vec3 t1{1, 0, 0};
  Vec3 t2{0, 1, 0};
  Vec3 n{0, 0, 1};
};

/// Holds the local directions at a point of the contact surface, right-handed and orthonormal.
struct Triad {
  Vec3 t1, t2, n;
};

/// Makes a triad of the unit normal n, of t1, the rolling direction of the axes projected on the tangent plane, and t2
/// = n x t1. The normal must not be parallel to the rolling direction.
Triad local_triad(const Axes& axes, const Vec3& normal);

struct Frame {
  SurfaceMesh mesh;
  Axes axes;
  std::vector<double> x, y, z;  ///< nodal coordinates in the axes (t1, t2, n)
  /// Holds the integral of N_i over the projected frame, or over the surface itself if curved (may be <= 0).
  std::vector<double> weight;
  std::vector<double> cell_area;   ///< median-dual cell area (curved: on the surface), > 0
  std::vector<std::uint8_t> rim;   ///< 1 for nodes on the frame's boundary
  std::vector<std::uint8_t> ends;  ///< 1 for nodes where a body without a mesh ends; empty: none
  std::vector<std::uint8_t> used;  ///< 1 for nodes that belong to an element and may carry tractions
  double area = 0;                 ///< area of the projected frame, of the surface if curved
  /// Holds the local triads of a curved frame; a flat one leaves them empty and has the axes' triad everywhere.
  std::vector<Vec3> t1, t2, n;
  /// Refers to what a curved frame under half-spaces was laid on; null if bodies with a mesh curve it, or it is flat.
  std::shared_ptr<const SectionLine> section;
  /// Holds the strips on which tractions are interpolated in place of the mesh's elements; null: none.
  std::shared_ptr<strips::StripFrame> strips;

  std::int64_t nodes() const { return mesh.nodes(); }
  std::int64_t elements() const { return mesh.elements(); }
  bool curved() const { return !n.empty(); }
  Triad triad(std::size_t k) const {
    if (curved()) return {t1[k], t2[k], n[k]};
    return {axes.t1, axes.t2, axes.n};
  }
};

/// Projects the mesh, checks it and computes everything above. Throws Error(err_mesh) naming, in the caller's index
/// base, the first offending element and their count: repeated nodes in an element, the same element twice, more than
/// two elements on an edge, degenerate (Jacobian not positive at a checked point), flipped (negative seen from the tip
/// of n). Nodes of no element are allowed (they carry no traction).
Frame build_frame(SurfaceMesh mesh, const Axes& axes);

/// Gives every node its local triad, and replaces weights and areas by those of the surface itself, from the outward
/// normal of body 1 at every node, of any length. Normals that all agree with the axes' leave the frame flat. Throws
/// Error(err_mesh) naming the first node whose normal is more than 60 degrees off the axes' normal, and the number of
/// such nodes.
void curve_frame(Frame& frame, std::span<const Vec3> normal);

/// Returns the area of the median-dual cells in the projection, where convection works.
std::vector<double> projected_cell_area(const Frame& frame);

}  // namespace rollcon
