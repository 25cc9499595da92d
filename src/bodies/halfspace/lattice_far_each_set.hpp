// The loop is written once and compiled for each instruction set (cmake/RollconKernels.cmake). Linkage is internal
// throughout; only one function's address leaves the file.
#pragma once

#include "bodies/halfspace/lattice_far.hpp"
#include "quadrature/pack.hpp"
#include "quadrature/pack_shape.hpp"

namespace {

using namespace rollcon::halfspace;

template <int terms>
void far_pack(const LatticeFar& job, const double* x, Pack* total) {
  constexpr int count = 1 + 2 * (terms & with_shear) + (terms & with_coupling);
  for (int k = 0; k < count; ++k) total[k] = splat(0);
  const Pack ox = load(x);
  for (int q = 0; q < job.ny; ++q) {
    const double dy = job.y - job.py[q];
    const Pack d22 = splat(dy * dy);
    Pack part[count];
    for (Pack& p : part) p = splat(0);
    for (int p = 0; p < job.nx; ++p) {
      const Pack d1 = ox - splat(job.px[p]);
      const Pack d11 = d1 * d1;
      const Pack inverse = splat(1) / root(d11 + d22);
      const Pack w = splat(job.wx[p]);
      const Pack f = w * inverse;
      part[0] = part[0] + f;
      const Pack g = f * inverse;  // w/r^2
      int k = 1;
      if constexpr ((terms & with_shear) != 0) {
        const Pack h = g * inverse;
        part[k] = fma(h, d11, part[k]);
        part[k + 1] = fma(h, d1, part[k + 1]);
        k += 2;
      }
      if constexpr ((terms & with_coupling) != 0) {
        part[k] = fma(g, d1, part[k]);
        part[k + 1] = part[k + 1] + g;
      }
    }
    const Pack w = splat(job.wy[q]), wd = splat(job.wy[q] * dy);
    int k = 0;
    total[k] = fma(w, part[k], total[k]);
    if constexpr ((terms & with_shear) != 0) {
      total[k + 1] = fma(w, part[k + 1], total[k + 1]);
      total[k + 2] = fma(wd, part[k + 2], total[k + 2]);
      k += 2;
    }
    if constexpr ((terms & with_coupling) != 0) {
      total[k + 1] = fma(w, part[k + 1], total[k + 1]);
      total[k + 2] = fma(wd, part[k + 2], total[k + 2]);
    }
  }
}

template <int terms>
void far_row(const LatticeFar& job) {
  constexpr int first_coupling = 3;
  constexpr int count = 1 + 2 * (terms & with_shear) + (terms & with_coupling);
  int target[count];
  int k = 0;
  target[k++] = 0;
  if constexpr ((terms & with_shear) != 0) target[k++] = 1, target[k++] = 2;
  if constexpr ((terms & with_coupling) != 0) target[k++] = first_coupling, target[k++] = first_coupling + 1;
  Pack total[count];
  std::int64_t i = 0;
  for (; i + lanes <= job.count; i += lanes) {
    far_pack<terms>(job, job.x + i, total);
    for (int m = 0; m < count; ++m) store(job.integral[target[m]] + i, total[m]);
  }
  if (i == job.count) return;
  double x[lanes], value[lanes];
  const int rest = static_cast<int>(job.count - i);
  for (int m = 0; m < lanes; ++m) x[m] = job.x[m < rest ? i + m : job.count - 1];
  far_pack<terms>(job, x, total);
  for (int m = 0; m < count; ++m) {
    store(value, total[m]);
    for (int n = 0; n < rest; ++n) job.integral[target[m]][i + n] = value[n];
  }
}

inline void far_any(const LatticeFar& job, int terms) {
  for_number<normal_only, with_shear, with_coupling, all_terms>(terms, [&]<int t>() { far_row<t>(job); });
}

}  // namespace

namespace rollcon::halfspace {

extern const LatticeFarFunction ROLLCON_COMPILED(lattice_far);
const LatticeFarFunction ROLLCON_COMPILED(lattice_far) = far_any;

}  // namespace rollcon::halfspace
