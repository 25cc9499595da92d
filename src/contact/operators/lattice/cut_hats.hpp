#pragma once
/// Provides columns of nodes whose hats are cut, on a lattice's rim and beside its holes: a convolution for each shape
/// of hat, made when the first such node carries traction. Few scenes ever ask for one.

#include <memory>
#include <mutex>
#include <vector>

#include "contact/operators/lattice/convolution.hpp"
#include "contact/operators/lattice/hat_pieces.hpp"

namespace rollcon {

/// Serves several threads; lattice and kernel must outlive it.
class CutHats {
 public:
  CutHats(const Lattice& lattice, const TranslationKernel& kernel, double delta);
  /// Holds what one thread needs, made with the first piece: all of them have the same lengths.
  using Workspace = std::unique_ptr<Convolution::Workspace>;
  /// Adds to the wanted images what the tractions of such nodes cause.
  void add(const double* const (&lambda)[3], double* const (&image)[3], Workspace& w) const;
  std::size_t bytes() const;

 private:
  const Lattice& lattice_;
  const TranslationKernel& kernel_;
  double delta_;
  struct Part {
    HatPiece piece;
    std::unique_ptr<const Convolution> columns;
  };
  mutable std::mutex making_;  ///< columns are made when they are first needed
  mutable std::vector<Part> part_;
};

}  // namespace rollcon
