// The products are written once and compiled for each instruction set (cmake/RollconKernels.cmake). Linkage is internal
// throughout; only tables of functions leave the file.
#pragma once

#include <cstring>
#include <utility>

#include "contact/operators/lattice/spectrum_product.hpp"

namespace {

#if defined(__AVX512F__)
constexpr int vector_bytes = 64;
#elif defined(__AVX2__)
constexpr int vector_bytes = 32;
#else
constexpr int vector_bytes = 16;
#endif

constexpr int lane_count = vector_bytes / static_cast<int>(sizeof(double));
typedef double Vector __attribute__((vector_size(vector_bytes)));
using Indices = std::make_integer_sequence<int, lane_count>;

Vector load(const double* p) {
  Vector v;
  std::memcpy(&v, p, sizeof v);
  return v;
}

/// Returns part 0 (real) or 1 (imaginary) of each number at both its places; reversed: in descending order.
template <int part, bool reversed, class V, int... i>
V spread(V v, std::integer_sequence<int, i...>) {
  constexpr int last = static_cast<int>(sizeof...(i)) - 2;
  return __builtin_shufflevector(v, v, (reversed ? last - i / 2 * 2 + part : i / 2 * 2 + part)...);
}
template <class V, int... i>
V exchange(V v, std::integer_sequence<int, i...>) {
  return __builtin_shufflevector(v, v, (i ^ 1)...);
}
template <class V, int... i>
V signs(std::integer_sequence<int, i...>) {
  return V{(i % 2 == 0 ? -1 : 1)...};
}

template <int terms, bool reversed>
void multiply(const rollcon::SpectrumProduct& job) {
  const Indices lanes;
  constexpr std::int64_t step = lane_count;
  const std::int64_t size = 2 * job.count;
  const Vector alternating = signs<Vector>(lanes);
  std::int64_t k = 0;
  for (; k + step <= size; k += step) {
    Vector even{}, odd{};  // real and imaginary parts of the spectrum times the field
    for (int m = 0; m < terms; ++m) {
      const Vector s = load(job.spectrum[m] + (reversed ? size - step - k : k));
      const Vector f = load(job.field[m] + k) * job.factor[m];
      even += spread<0, reversed>(s, lanes) * f;
      odd += spread<1, reversed>(s, lanes) * exchange(f, lanes);
    }
    const Vector sum = even + alternating * odd;
    std::memcpy(job.sum + k, &sum, sizeof sum);
  }
  for (; k < size; k += 2) {
    double re = 0, im = 0;
    for (int m = 0; m < terms; ++m) {
      const double* s = job.spectrum[m] + (reversed ? size - 2 - k : k);
      const double* f = job.field[m] + k;
      re += job.factor[m] * (s[0] * f[0] - s[1] * f[1]);
      im += job.factor[m] * (s[0] * f[1] + s[1] * f[0]);
    }
    job.sum[k] = re;
    job.sum[k + 1] = im;
  }
}

template <bool reversed>
void any(const rollcon::SpectrumProduct& job) {
  switch (job.terms) {
    case 1:
      return multiply<1, reversed>(job);
    case 2:
      return multiply<2, reversed>(job);
    default:
      return multiply<3, reversed>(job);
  }
}

}  // namespace

namespace rollcon {

extern const SpectrumProducts ROLLCON_COMPILED(products);
const SpectrumProducts ROLLCON_COMPILED(products) = {any<false>, any<true>};

}  // namespace rollcon
