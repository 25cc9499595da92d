#pragma once
/// Makes dense operators of small lattices, without integration.

#include "bodies/model/translation.hpp"
#include "contact/operators/dense_operators.hpp"
#include "mesh/lattice.hpp"

namespace rollcon {

/// Fills the blocks of all nodes as assemble_operators does for bodies with this kernel, cut hats included, to
/// rounding. The convection of the characteristic scheme must have the same step at all nodes (so it has on 3 x 3 nodes
/// or more). Blocks that are there are filled again.
void fill_lattice_operators(const Lattice& lattice, const TranslationKernel& kernel, const Convection& convection,
                            bool want_tangential, DenseOperators& op);

}  // namespace rollcon
