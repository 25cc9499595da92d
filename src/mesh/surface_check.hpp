#pragma once
/// Checks of a body's surface mesh before anything is computed on it.

#include "mesh/surface_mesh.hpp"

namespace rollcon {

enum class SurfaceKind {
  closed,  ///< the whole boundary of a solid, cavities included
  open,    ///< a rigid surface to roll on
};

/// Throws Error(err_mesh) naming, in the caller's index base, the first offending elements or nodes
/// and their count: different nodes at one place, nodes of no element, a node twice in an element,
/// the same element twice, degenerate elements (Jacobian vanishing or turning over within the
/// element; slender ones are allowed), edges of more than two elements, neighbours of opposite
/// orientation (flipped), and for closed surfaces: open edges, shells whose normals point the wrong
/// way (the outer shell encloses positive volume, cavities negative; the count of elements to flip
/// is given), and more than one outer shell (a body must be connected).
void check_surface(const SurfaceMesh& mesh, SurfaceKind kind);

}  // namespace rollcon
