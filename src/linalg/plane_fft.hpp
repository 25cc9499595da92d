#pragma once
/// Transforms real data in two dimensions on a part of their period, in single or double precision.

#include <complex>
#include <cstdint>

#include "linalg/fft.hpp"

namespace rollcon {

template <class Real>
class PlaneFft {
 public:
  using Complex = std::complex<Real>;
  /// Takes data of nx by ny in periods of at least least_x by least_y; the rest of a period is zero.
  PlaneFft(std::int64_t nx, std::int64_t ny, std::int64_t least_x, std::int64_t least_y);

  std::int64_t period_x() const { return px_; }
  std::int64_t period_y() const { return py_; }
  /// Wave numbers kx run from 0 to waves_x() - 1, ky from 0 to period_y() - 1, those above the half being negative.
  std::int64_t waves_x() const { return px_ / 2 + 1; }
  /// Entry (kx, ky) of a spectrum is at kx * stride() + ky.
  std::int64_t stride() const { return AlignedArray<Complex>::stride(py_); }
  AlignedArray<Complex> make_spectrum() const { return AlignedArray<Complex>(waves_x() * stride()); }

  /// Reads data[j * nx + i].
  void forward(const Real* data, Complex* spectrum);
  /// Leaves out the factor 1 / (period_x period_y); the spectrum is overwritten.
  void backward(Complex* spectrum, Real* data);
  std::size_t bytes() const { return row_.bytes() + half_.bytes() + columns_.bytes(); }

 private:
  /// Columns are transposed in tiles, because a column alone would use one number of every cache line.
  static constexpr std::int64_t tile = 8;
  std::int64_t nx_, ny_, px_, py_, half_stride_;
  RealFft<Real> along_;
  ComplexFft<Real> across_;
  AlignedArray<Real> row_;
  AlignedArray<Complex> half_;     ///< [iy][kx]
  AlignedArray<Complex> columns_;  ///< [kx of a tile][ky]
};

}  // namespace rollcon
