#pragma once
/// Checks a body's surface mesh before anything is computed on it.

#include "mesh/surface_mesh.hpp"

namespace rollcon {

enum class SurfaceKind {
  closed,  ///< the whole boundary of a solid, cavities included
  open,    ///< a rigid surface to roll on
  /// The boundary of a volume mesh has passed check_volume, and has that one's node numbering.
  boundary,
};

/// Throws Error(err_mesh) naming, in the caller's index base, the first offending elements or nodes and their count, in
/// this order: nodes out of range, a node twice in an element, an element twice; nodes of no element; degenerate
/// elements (coinciding nodes, Jacobian vanishing or turning over within the element; slender ones are allowed);
/// different nodes at one place (within 1e-6 of the distance to the other nodes of their elements); edges of more than
/// two elements; edges whose elements do not share the midside node, and quadratic edges that lie on two shorter ones
/// (types may be mixed where their edges agree); one-sided surfaces. On open surfaces it names elements that look to
/// the other side than most of those they are connected with; on closed ones open edges; parts that touch only at a
/// node; parts that enclose no volume or cross; more than one outer shell (a body must be connected); elements whose
/// normals look into the body (the outer shell encloses positive volume, cavities negative); elements without a common
/// node that cross. On boundaries of volumes it names only edges of more than two faces, which the volume's elements
/// leave where they touch along an edge.
void check_surface(const SurfaceMesh& mesh, SurfaceKind kind);

}  // namespace rollcon
