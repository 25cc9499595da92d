#pragma once
/// Convolves nodal fields on a lattice with the operators' entries, by FFT. Sources are the nodes with one shape of
/// hat, targets all nodes.

#include <complex>
#include <cstdint>
#include <vector>

#include "contact/operators/lattice/hat_pieces.hpp"
#include "contact/operators/lattice/lattice_entries.hpp"
#include "contact/operators/lattice/spectrum_product.hpp"
#include "linalg/fft.hpp"
#include "mesh/lattice.hpp"

namespace rollcon {

/// Serves several threads, as it never changes; the lattice must outlive it.
class Convolution {
 public:
  /// Prepares a convolution with the entries of the sources' hats.
  Convolution(const Lattice& lattice, const LatticeEntries& entries, const HatPiece& sources);

  /// Holds what one thread needs.
  class Workspace {
   public:
    explicit Workspace(const Convolution& owner);
    std::size_t bytes() const;

   private:
    friend class Convolution;
    AlignedArray<double> row;                   ///< one padded row
    AlignedArray<std::complex<double>> waves;   ///< transform of that row
    AlignedArray<std::complex<double>> half;    ///< [component][block of kx][iy][kx]: rows transformed
    AlignedArray<std::complex<double>> column;  ///< [component][kx of a block][ky]
    AlignedArray<std::complex<double>> sum;     ///< [kx of a block][ky]
    AlignedArray<std::complex<double>> line;    ///< one column before its transform
    std::vector<std::uint8_t> loaded[3];        ///< rows with any source
  };

  /// Computes image[r], at all nodes that have a place: the sum over c of the entries times lambda[c] at the sources;
  /// both in the frame's numbering. Null lambda: zero. Null image: not wanted.
  void apply(const double* const (&lambda)[3], double* const (&image)[3], Workspace& w) const {
    run(lambda, image, w, false);
  }
  /// Adds what apply() computes to the images.
  void add(const double* const (&lambda)[3], double* const (&image)[3], Workspace& w) const {
    run(lambda, image, w, true);
  }

  std::size_t bytes() const;

 private:
  using Complex = std::complex<double>;
  static constexpr std::int64_t block = 8;  ///< columns transformed together
  /// Returns where block k of component c begins in Workspace::half.
  std::int64_t tile(int c, std::int64_t k) const { return (c * blocks_ + k) * lattice_.ny * block; }
  void run(const double* const (&lambda)[3], double* const (&image)[3], Workspace& w, bool add) const;
  void fill_rows(const LatticeEntries& entries);
  void transform_spectra();
  bool transform_rows(int c, const double* lambda, Workspace& w) const;
  void convolve_columns(std::int64_t first, const bool (&source)[3], const bool (&target)[3], Workspace& w) const;
  bool multiply(int r, std::int64_t kx, const bool (&source)[3], const Complex* fields, Complex* sum) const;

  const Lattice& lattice_;
  std::int64_t reach_x_, reach_y_;    ///< largest offsets between a source and a node
  std::vector<std::int32_t> source_;  ///< frame's node at each place that is a source; -1: none
  std::int64_t px_, py_;              ///< padded lengths
  std::int64_t columns_;              ///< px / 2 + 1
  bool mirrored_;                     ///< spectra at -ky are those at ky up to the sign: half of them is stored
  std::int64_t kept_;                 ///< number of values of ky stored
  std::int64_t blocks_, column_stride_, kept_stride_;
  RealFft<double> along_;
  ComplexFft<double> across_;
  SpectrumProducts products_;
  EntryKinds kinds_;
  std::vector<int> mirror_;                      ///< sign at -ky of each kind
  std::vector<AlignedArray<Complex>> spectrum_;  ///< spectrum of each kind: [kx][ky], times 1 / (px py)
};

}  // namespace rollcon
