#pragma once
/// Dense operators of small lattices, without integration.

#include "bodies/halfspace/halfspace.hpp"
#include "contact/operators/operators.hpp"
#include "mesh/lattice.hpp"

namespace rollcon {

/// Fills the blocks of all nodes as assemble_operators does for half-spaces with these constants, cut hats included, to
/// rounding. The convection of op must be prepared, for the characteristic scheme with the same step at all nodes (so
/// it is on 3 x 3 nodes or more). Blocks that are there are filled again.
void fill_lattice_operators(const Lattice& lattice, HalfspaceConstants c, bool want_tangential, ContactOperators& op);

}  // namespace rollcon
