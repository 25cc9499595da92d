#pragma once
/// Computes discrete Fourier transforms (FFTW). Without FFTW in the build every constructor fails with err_unsupported.
/// Transforms may run in several threads at once, on different data; plans are made one at a time, under a lock of the
/// library's own.

#include <complex>
#include <cstddef>
#include <cstdint>
#include <new>
#include <utility>

namespace rollcon {

/// Returns false in a build without FFTW.
bool has_fft();

/// Returns the fastest length from `least` to a third more: even, a product of powers of 2, 3, 5 and 7.
std::int64_t fft_size(std::int64_t least);

/// Provides storage that is aligned for the transforms and not initialised.
template <class T>
class AlignedArray {
 public:
  static constexpr std::size_t alignment = 64;
  /// Returns the number of entries after which an aligned row may follow another of n.
  static std::int64_t stride(std::int64_t n) {
    constexpr auto step = static_cast<std::int64_t>(alignment / sizeof(T));
    return (n + step - 1) / step * step;
  }
  AlignedArray() = default;
  explicit AlignedArray(std::int64_t n)
      : size_(n),
        data_(static_cast<T*>(::operator new(static_cast<std::size_t>(n) * sizeof(T), std::align_val_t(alignment)))) {}
  ~AlignedArray() { ::operator delete(data_, std::align_val_t(alignment)); }
  AlignedArray(AlignedArray&& other) noexcept : size_(other.size_), data_(other.data_) {
    other.data_ = nullptr, other.size_ = 0;
  }
  AlignedArray& operator=(AlignedArray&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    return *this;
  }
  T* data() { return data_; }
  const T* data() const { return data_; }
  std::int64_t size() const { return size_; }
  std::size_t bytes() const { return static_cast<std::size_t>(size_) * sizeof(T); }

 private:
  std::int64_t size_ = 0;
  T* data_ = nullptr;
};

/// Transforms n real numbers to n / 2 + 1 complex ones and back, n even, with T double or float. All arrays are aligned
/// like AlignedArray.
template <class T>
class RealFft {
 public:
  explicit RealFft(std::int64_t n);
  ~RealFft();
  RealFft(const RealFft&) = delete;
  RealFft& operator=(const RealFft&) = delete;
  /// Leaves `in` unchanged.
  void forward(const T* in, std::complex<T>* out) const;
  /// Leaves out the factor 1/n; `in` is overwritten.
  void inverse(std::complex<T>* in, T* out) const;

 private:
  void *forward_ = nullptr, *inverse_ = nullptr;
};

/// Transforms n complex numbers from one array to another, which takes two thirds of the time of one array: FFTW's
/// plans for that allocate buffers at each call. `in` is overwritten.
template <class T>
class ComplexFft {
 public:
  explicit ComplexFft(std::int64_t n);
  ~ComplexFft();
  ComplexFft(const ComplexFft&) = delete;
  ComplexFft& operator=(const ComplexFft&) = delete;
  void forward(std::complex<T>* in, std::complex<T>* out) const;
  /// Leaves out the factor 1/n.
  void inverse(std::complex<T>* in, std::complex<T>* out) const;

 private:
  void *forward_ = nullptr, *inverse_ = nullptr;
};

}  // namespace rollcon
