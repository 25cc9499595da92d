// The kernels are written once and compiled for each instruction set (cmake/RollconKernels.cmake). Linkage is internal
// throughout; only the table of functions leaves the file.
#pragma once

#include <bit>
#include <cstdint>
#include <initializer_list>

#include "bodies/halfspace/strip_kernels.hpp"
#include "quadrature/pack.hpp"

namespace {

using rollcon::strips::KernelJob;

#if defined(__SSE2__)
typedef std::int64_t Bits __attribute__((vector_size(sizeof(Pack))));
#else
using Bits = std::int64_t;
#endif

inline Bits bits(Pack a) {
  return std::bit_cast<Bits>(a);
}
inline Pack number(Bits a) {
  return std::bit_cast<Pack>(a);
}
inline Pack magnitude(Pack a) {
  return number(bits(a) & INT64_MAX);
}
/// Returns a >= 0 with the sign of b.
inline Pack with_sign(Pack a, Pack b) {
  return number(bits(a) | (bits(b) & INT64_MIN));
}

/// Splits a = 2^exponent (1 + rest), 1 + rest from the root of 1/2 to the root of 2.
inline void split(Pack a, Pack* exponent, Pack* rest) {
  constexpr std::int64_t root_half = 0x3fe6a09e667f3bcd, shifter = 0x4338000000000000;
  // An arithmetic shift of 64 bits is slow before AVX-512; exponents are made positive for a logical one.
  constexpr std::int64_t lifted = std::int64_t{1024} << 52;
  const Bits k = ((bits(a) - root_half + lifted) >> 52) - 1024;
  *exponent = number(k + shifter) - splat(std::bit_cast<double>(shifter));
  *rest = number(bits(a) - (k << 52)) - splat(1);
}

/// Returns exponent ln 2 + ln(1 + f) with s = f/(2 + f): ln(1 + f) = f - f^2/2 + s (f^2/2 + R(s^2)).
inline Pack log_of_rest(Pack exponent, Pack f, Pack s) {
  const Pack z = s * s, half = splat(0.5) * f * f;
  Pack r = splat(1.479819860511658591e-01);
  for (const double c : {1.531383769920937332e-01, 1.818357216161805012e-01, 2.222219843214978396e-01,
                         2.857142874366239149e-01, 3.999999999940941908e-01, 6.666666666666735130e-01})
    r = fma(r, z, splat(c));
  return fma(exponent, splat(0.693147180559945309417), f - (half - s * fma(r, z, half)));
}

/// Computes both logarithms with one division.
inline void log_of_both(Pack a, Pack b, Pack* log_a, Pack* log_b) {
  Pack ka, fa, kb, fb;
  split(a, &ka, &fa);
  split(b, &kb, &fb);
  const Pack da = splat(2) + fa, db = splat(2) + fb, inverse = splat(1) / (da * db);
  *log_a = log_of_rest(ka, fa, fa * db * inverse);
  *log_b = log_of_rest(kb, fb, fb * da * inverse);
}

/// Returns the arc tangent of 0 <= t <= 0.4143 (Cephes).
inline Pack small_arc(Pack t) {
  const Pack z = t * t;
  Pack p = splat(-8.750608600031904122785e-1);
  for (const double c :
       {-1.615753718733365076637e1, -7.500855792314704667340e1, -1.228866684490136173410e2, -6.485021904942025371773e1})
    p = fma(p, z, splat(c));
  Pack q = splat(1);
  for (const double c : {2.485846490142306297962e1, 1.650270098316988542046e2, 4.328810604912902668951e2,
                         4.853903996359136964868e2, 1.945506571482613964425e2})
    q = fma(q, z, splat(c));
  return fma(t * z, p / q, t);
}

/// Holds the antiderivative of one kernel and its rates.
struct Primitive {
  Pack value, by_x, by_y;
};
inline Primitive operator*(double a, const Primitive& p) {
  return {splat(a) * p.value, splat(a) * p.by_x, splat(a) * p.by_y};
}
inline Primitive operator+(const Primitive& a, const Primitive& b) {
  return {a.value + b.value, a.by_x + b.by_x, a.by_y + b.by_y};
}

/// Holds a difference of places with what all kernels need of it.
struct Offset {
  Pack x, y, ax, ay, r, lx, ly;  ///< ax, ay: magnitudes; lx, ly: X and Y of the header, with their signs

  Offset(Pack dx, Pack dy) : x(dx), y(dy) {
    // Terms of zero offsets vanish, whatever finite number the logarithm is.
    const Pack tiny = splat(1e-140);
    ax = magnitude(dx) + tiny;
    ay = magnitude(dy) + tiny;
    r = root(fma(dx, dx, fma(dy, dy, tiny * tiny)));
    const Pack inverse = splat(1) / (ax * ay);
    Pack lp, lq;
    log_of_both((ax + r) * ax * inverse, (ay + r) * ay * inverse, &lp, &lq);
    lx = with_sign(magnitude(lp), dx);
    ly = with_sign(magnitude(lq), dy);
  }

  Primitive one_over_r() const {
    const Pack half = splat(0.5), xx = x * lx, yy = y * ly, x2 = x * x, y2 = y * y;
    return {half * (x2 * yy + y2 * xx) - r * (x2 + y2) * splat(1.0 / 6), x * yy + half * (y2 * lx - x * r),
            y * xx + half * (x2 * ly - y * r)};
  }
  Primitive xx_over_r3() const {
    const Pack half = splat(0.5), x2 = x * x, y2 = y * y, e = x * lx - r;
    return {r * (x2 + y2) * splat(1.0 / 6) + half * y2 * e, half * (x * r + y2 * lx), y * e};
  }
  Primitive xy_over_r3() const {
    const Pack half = splat(-0.5), x2 = x * x, y2 = y * y;
    return {splat(-1.0 / 6) * (splat(2) * x * y * r + x * x2 * ly + y * y2 * lx), half * (y * r + x2 * ly),
            half * (x * r + y2 * lx)};
  }
  /// Computes the logarithm of r and the arc tangent of ay / ax, for coupling.
  void turn(Pack* log_r, Pack* arc) const {
    const Bits steep = ay > ax;
    const Pack less = steep ? ax : ay, more = steep ? ay : ax;
    const Pack small = splat(2) * small_arc(less / (more + r));
    *arc = steep ? splat(1.57079632679489661923) - small : small;
    Pack exponent, rest;
    split(r, &exponent, &rest);
    *log_r = log_of_rest(exponent, rest, rest / (splat(2) + rest));
  }
  static Primitive along(Pack x, Pack y, Pack log_r, Pack a, Pack b) {
    const Pack half = splat(0.5), sixth = splat(1.0 / 6), x2 = x * x, y2 = y * y, xy = x * y;
    return {sixth * x * (splat(3) * y2 - x2) * log_r + half * x2 * y * a + sixth * y * y2 * b,
            (y2 - x2) * (half * log_r + sixth) + xy * a, xy * (log_r + splat(1.0 / 3)) + half * (x2 * a + y2 * b)};
  }
  void over_r2(Primitive* x_over_r2, Primitive* y_over_r2) const {
    Pack log_r, arc;
    turn(&log_r, &arc);
    const Pack sign = with_sign(splat(1), number(bits(x) ^ bits(y)));
    const Pack a = sign * arc, b = sign * (splat(1.57079632679489661923) - arc);
    *x_over_r2 = along(x, y, log_r, a, b);
    const Primitive turned = along(y, x, log_r, b, a);
    *y_over_r2 = {turned.value, turned.by_y, turned.by_x};
  }
};

template <bool slip, bool coupling>
inline void primitives(const Offset& d, const KernelJob& job, Primitive* p) {
  const Primitive one = d.one_over_r();
  if constexpr (slip) {
    const Primitive xx = d.xx_over_r3();
    p[0] = job.cn * one + job.cv * xx;
    p[1] = job.cv * d.xy_over_r3();
    p[2] = (job.cn + job.cv) * one + (-job.cv) * xx;
    if constexpr (coupling) {
      d.over_r2(&p[3], &p[4]);
      p[3] = (-job.ck) * p[3];
      p[4] = (-job.ck) * p[4];
    }
  } else {
    p[0] = job.cn * one;
    if constexpr (coupling) {
      d.over_r2(&p[1], &p[2]);
      p[1] = job.ck * p[1];
      p[2] = job.ck * p[2];
    }
  }
}

template <bool slip, bool coupling, bool rates>
void run(const KernelJob& job) {
  constexpr int kinds = (slip ? 3 : 1) + (coupling ? 2 : 0);
  const Pack x = splat(job.x), y = splat(job.y);
  for (int n = 0; n < job.count; n += lanes) {
    const Pack dx = x - load(job.place + n);
    Pack value[kinds] = {}, by_x[kinds] = {}, by_y[kinds] = {}, by_width[kinds] = {};
    for (int f = 0; f < 3; ++f) {
      const Pack w = load(job.weight[f] + n);
      Primitive p[kinds];
      primitives<slip, coupling>(Offset(dx, y - load(job.foot[f] + n)), job, p);
      for (int k = 0; k < kinds; ++k) {
        value[k] = fma(w, p[k].value, value[k]);
        if constexpr (rates) {
          by_x[k] = fma(w, p[k].by_x, by_x[k]);
          by_y[k] = fma(w, p[k].by_y, by_y[k]);
          by_width[k] = fma(load(job.turn[f] + n), p[k].by_y, by_width[k]);
        }
      }
    }
    for (int k = 0; k < kinds; ++k) {
      double* out = job.values + (rates ? 4 * k : k) * job.count + n;
      store(out, value[k]);
      if constexpr (rates) {
        store(out + job.count, by_x[k]);
        store(out + 2 * job.count, by_y[k]);
        store(out + 3 * job.count, by_width[k]);
      }
    }
  }
}

}  // namespace

namespace rollcon::strips {

extern const StripKernels ROLLCON_COMPILED(kernels);
const StripKernels ROLLCON_COMPILED(kernels) = {
    {{run<false, false, false>, run<false, false, true>}, {run<false, true, false>, run<false, true, true>}},
    {{run<true, false, false>, run<true, false, true>}, {run<true, true, false>, run<true, true, true>}}};

}  // namespace rollcon::strips
