// Holds a few doubles in one register. This file has no include guard of its own kind: each kernel file compiles it
// once for its instruction set, with internal linkage, so that no code for one processor leaks into another file.
#pragma once

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "quadrature/near_points.hpp"

namespace {

#if defined(__AVX512F__)
using Pack = __m512d;
constexpr int lanes = 8;
inline Pack load(const double* p) {
  return _mm512_loadu_pd(p);
}
inline void store(double* p, Pack a) {
  _mm512_storeu_pd(p, a);
}
inline Pack splat(double a) {
  return _mm512_set1_pd(a);
}
// The masked form is used because the plain one reads an undefined register, of which GCC 12 warns.
inline Pack root(Pack a) {
  return _mm512_maskz_sqrt_pd(0xff, a);
}
inline Pack fma(Pack a, Pack b, Pack c) {
  return _mm512_fmadd_pd(a, b, c);
}
#elif defined(__AVX2__) && defined(__FMA__)
using Pack = __m256d;
constexpr int lanes = 4;
inline Pack load(const double* p) {
  return _mm256_loadu_pd(p);
}
inline void store(double* p, Pack a) {
  _mm256_storeu_pd(p, a);
}
inline Pack splat(double a) {
  return _mm256_set1_pd(a);
}
inline Pack root(Pack a) {
  return _mm256_sqrt_pd(a);
}
inline Pack fma(Pack a, Pack b, Pack c) {
  return _mm256_fmadd_pd(a, b, c);
}
#elif defined(__SSE2__)
using Pack = __m128d;
constexpr int lanes = 2;
inline Pack load(const double* p) {
  return _mm_loadu_pd(p);
}
inline void store(double* p, Pack a) {
  _mm_storeu_pd(p, a);
}
inline Pack splat(double a) {
  return _mm_set1_pd(a);
}
inline Pack root(Pack a) {
  return _mm_sqrt_pd(a);
}
inline Pack fma(Pack a, Pack b, Pack c) {
  return a * b + c;
}
#else
using Pack = double;
constexpr int lanes = 1;
inline Pack load(const double* p) {
  return *p;
}
inline void store(double* p, Pack a) {
  *p = a;
}
inline Pack splat(double a) {
  return a;
}
inline Pack root(Pack a) {
  return __builtin_sqrt(a);
}
inline Pack fma(Pack a, Pack b, Pack c) {
  return a * b + c;
}
#endif

inline double sum(Pack a) {
  double v[lanes];
  store(v, a);
  double s = v[0];
  for (int i = 1; i < lanes; ++i) s += v[i];
  return s;
}

/// Fills the last pack with the last point, weight 0.
inline void pad(rollcon::quadrature::NearPoints& points) {
  for (int q = points.n; q % lanes != 0; ++q) {
    points.xi[q] = points.xi[points.n - 1];
    points.eta[q] = points.eta[points.n - 1];
    points.w[q] = 0;
  }
}

}  // namespace
