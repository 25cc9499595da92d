#pragma once
/// Sorts hats of a lattice's nodes by their shape: whole where all four cells around a node are there, else a sum of
/// halves and quarters.

#include <cstdint>
#include <vector>

#include "bodies/model/translation.hpp"
#include "mesh/lattice.hpp"

namespace rollcon {

/// Lists the nodes that have this piece.
struct HatPiece {
  Hat x, y;
  std::vector<std::int32_t> places;  ///< ascending
  bool whole() const { return x == Hat::whole && y == Hat::whole; }
};

/// Returns the pieces, whole hats first; pieces of no node are left out.
std::vector<HatPiece> hat_pieces(const Lattice& lattice);

}  // namespace rollcon
