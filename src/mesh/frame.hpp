#pragma once
/// The contact frame: the mesh on which tractions live. Its nodes are given in space; the
/// half-space sees their projection on the tangent plane of the axes (t1, t2), so a gently curved
/// frame is allowed as long as it projects without folding.

#include <cstdint>
#include <vector>

#include "mesh/surface_mesh.hpp"

namespace rollcon {

/// Origin and right-handed orthonormal triad (t1 rolling direction, t2, n outward normal of body
/// 1).
struct Axes {
  Vec3 origin{0, 0, 0};
  Vec3 t1{1, 0, 0};
  Vec3 t2{0, 1, 0};
  Vec3 n{0, 0, 1};
};

struct Frame {
  SurfaceMesh mesh;
  Axes axes;
  std::vector<double> x, y, z;     ///< nodal coordinates in the axes (t1, t2, n)
  std::vector<double> weight;      ///< integral of N_i over the projected frame (may be <= 0)
  std::vector<double> cell_area;   ///< median-dual cell area, > 0
  std::vector<std::uint8_t> rim;   ///< 1 for nodes on the frame's boundary
  std::vector<std::uint8_t> used;  ///< 1 for nodes that belong to an element
  double area = 0;                 ///< of the projected frame

  std::int64_t nodes() const { return mesh.nodes(); }
  std::int64_t elements() const { return mesh.elements(); }
};

/// Projects the mesh, checks it and computes everything above. Throws Error(err_mesh) naming, in
/// the caller's index base, the first offending element and their count: repeated nodes in an
/// element, the same element twice, more than two elements on an edge, degenerate (Jacobian not
/// positive at a checked point), flipped (negative seen from the tip of n), nodes of no element
/// are allowed (they carry no traction).
Frame build_frame(SurfaceMesh mesh, const Axes& axes);

}  // namespace rollcon
