#include "linalg/plane_fft.hpp"

#include <algorithm>

namespace rollcon {

template <class Real>
PlaneFft<Real>::PlaneFft(std::int64_t nx, std::int64_t ny, std::int64_t least_x, std::int64_t least_y)
    : nx_(nx),
      ny_(ny),
      px_(fft_size(std::max(nx, least_x))),
      py_(fft_size(std::max(ny, least_y))),
      half_stride_(AlignedArray<Complex>::stride(px_ / 2 + 1)),
      along_(px_),
      across_(py_),
      row_(px_),
      half_(half_stride_ * ny),
      columns_(tile * stride()) {}

template <class Real>
void PlaneFft<Real>::forward(const Real* data, Complex* spectrum) {
  std::fill(row_.data() + nx_, row_.data() + px_, Real{0});
  for (std::int64_t j = 0; j < ny_; ++j) {
    std::copy(data + j * nx_, data + (j + 1) * nx_, row_.data());
    along_.forward(row_.data(), half_.data() + j * half_stride_);
  }
  for (std::int64_t first = 0; first < waves_x(); first += tile) {
    const std::int64_t last = std::min(first + tile, waves_x());
    for (std::int64_t j = 0; j < ny_; ++j)
      for (std::int64_t k = first; k < last; ++k)
        columns_.data()[(k - first) * stride() + j] = half_.data()[j * half_stride_ + k];
    for (std::int64_t k = first; k < last; ++k) {
      Complex* column = columns_.data() + (k - first) * stride();
      std::fill(column + ny_, column + py_, Complex{});
      across_.forward(column, spectrum + k * stride());
    }
  }
}

template <class Real>
void PlaneFft<Real>::backward(Complex* spectrum, Real* data) {
  for (std::int64_t first = 0; first < waves_x(); first += tile) {
    const std::int64_t last = std::min(first + tile, waves_x());
    for (std::int64_t k = first; k < last; ++k)
      across_.inverse(spectrum + k * stride(), columns_.data() + (k - first) * stride());
    for (std::int64_t j = 0; j < ny_; ++j)
      for (std::int64_t k = first; k < last; ++k)
        half_.data()[j * half_stride_ + k] = columns_.data()[(k - first) * stride() + j];
  }
  for (std::int64_t j = 0; j < ny_; ++j) {
    along_.inverse(half_.data() + j * half_stride_, row_.data());
    std::copy(row_.data(), row_.data() + nx_, data + j * nx_);
  }
}

template class PlaneFft<float>;
template class PlaneFft<double>;

}  // namespace rollcon
