#pragma once
/// Carries values at the nodes of one regular grid to those of another.

#include <span>
#include <vector>

#include "mesh/lattice.hpp"

namespace rollcon {

/// Carries values of bilinear fields between grids without holes that lie along the axes. They are carried exactly if
/// the other grid's nodes include the first one's, and keep their integral if its cells are a whole number of times as
/// large. Values beyond the other grid are left out.
void carry_to_lattice(const Lattice& from, std::span<const double> value, const Lattice& to,
                      std::vector<double>& carried);

/// Says whether a grid has no holes and lies along the axes.
bool lies_along_axes(const Lattice& lattice);

}  // namespace rollcon
