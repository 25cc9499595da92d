#include "contact/operators/lattice/cut_hats.hpp"

#include <algorithm>

namespace rollcon {

CutHats::CutHats(const Lattice& lattice, const TranslationKernel& kernel, double delta)
    : lattice_(lattice), kernel_(kernel), delta_(delta) {
  for (HatPiece& piece : hat_pieces(lattice))
    if (!piece.whole()) part_.push_back({std::move(piece), nullptr});
}

void CutHats::add(const double* const (&lambda)[3], double* const (&image)[3], Workspace& w) const {
  const auto loaded = [&](std::int32_t place) {
    const std::int32_t k = lattice_.node[static_cast<std::size_t>(place)];
    for (const double* t : lambda)
      if (t != nullptr && t[k] != 0) return true;
    return false;
  };
  for (Part& part : part_) {
    const std::vector<std::int32_t>& places = part.piece.places;
    if (std::none_of(places.begin(), places.end(), loaded)) continue;
    {
      const std::lock_guard guard(making_);
      if (!part.columns)
        part.columns = std::make_unique<Convolution>(
            lattice_, LatticeEntries(lattice_, kernel_, delta_, part.piece.x, part.piece.y), part.piece);
    }
    if (!w) w = std::make_unique<Convolution::Workspace>(*part.columns);
    part.columns->add(lambda, image, *w);
  }
}

std::size_t CutHats::bytes() const {
  const std::lock_guard guard(making_);
  std::size_t sum = sizeof *this;
  for (const Part& part : part_)
    sum += part.piece.places.size() * sizeof(std::int32_t) + (part.columns ? part.columns->bytes() : 0);
  return sum;
}

}  // namespace rollcon
