#include "contact/operators/lattice/hat_pieces.hpp"

#include <cstddef>

namespace rollcon {

std::vector<HatPiece> hat_pieces(const Lattice& lattice) {
  // Larger pieces come first: three cells are a half and a quarter.
  struct Kind {
    Hat x, y;
    int cells;
  };
  constexpr int ll = Lattice::low_low, hl = Lattice::high_low, lh = Lattice::low_high, hh = Lattice::high_high;
  constexpr Kind kinds[] = {
      {Hat::whole, Hat::whole, Lattice::all}, {Hat::whole, Hat::before, ll | hl}, {Hat::whole, Hat::after, lh | hh},
      {Hat::before, Hat::whole, ll | lh},     {Hat::after, Hat::whole, hl | hh},  {Hat::before, Hat::before, ll},
      {Hat::after, Hat::before, hl},          {Hat::before, Hat::after, lh},      {Hat::after, Hat::after, hh}};
  std::vector<HatPiece> all;
  for (const Kind& kind : kinds) all.push_back({kind.x, kind.y, {}});
  for (std::size_t at = 0; at < lattice.cells.size(); ++at) {
    int rest = lattice.cells[at];
    for (std::size_t k = 0; k < all.size(); ++k)
      if ((rest & kinds[k].cells) == kinds[k].cells) {
        all[k].places.push_back(static_cast<std::int32_t>(at));
        rest &= ~kinds[k].cells;
      }
  }
  std::erase_if(all, [](const HatPiece& piece) { return piece.places.empty(); });
  return all;
}

}  // namespace rollcon
