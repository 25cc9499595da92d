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
/// two elements; edges whose elements do not share the midside node (types may be mixed where their edges agree). Open
/// surfaces: elements that look to the other side than most of those they hang together with. Closed ones: open edges;
/// parts that enclose no volume; more than one outer shell (a body must be connected); elements whose normals look into
/// the body (the outer shell encloses positive volume, cavities negative). Boundaries of volumes: only edges of more
/// than two faces, which the volume's elements leave where they touch along an edge.
void check_surface(const SurfaceMesh& mesh, SurfaceKind kind);

}  // namespace rollcon
