// The kernels are written once and compiled for each instruction set (cmake/RollconKernels.cmake). Linkage is internal
// throughout; only the table of functions leaves the file. somigliana_kernels.hpp has the formulas and names.
#pragma once

#include <numbers>

#include "bodies/bem/somigliana_kernels.hpp"
#include "quadrature/pack.hpp"
#include "quadrature/pack_shape.hpp"

namespace {

using rollcon::max_element_nodes;
using rollcon::bem::LinearField;
using rollcon::bem::LoadedFace;
using rollcon::bem::NearPoints;
using rollcon::bem::somigliana_count;

inline Pack inner(const Pack* a, const Pack* b) {
  return fma(a[0], b[0], fma(a[1], b[1], a[2] * b[2]));
}

/// Gives the place of entry (i, j) of a symmetric tensor 11, 22, 33, 12, 13, 23.
constexpr int entry_of[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};
constexpr int row_of[6] = {0, 1, 2, 0, 0, 1}, column_of[6] = {0, 1, 2, 1, 2, 2};

struct SomiglianaSums {
  Pack total[somigliana_count];
  Pack nu, k, c;

  explicit SomiglianaSums(double poisson)
      : nu(splat(poisson)), k(splat(1 - 2 * poisson)), c(splat(1 / (8 * std::numbers::pi * (1 - poisson)))) {
    for (Pack& t : total) t = splat(0);
  }

  inline void add(const Pack* r, const Pack* m, const Pack* f, const Pack* v) {
    const Pack inverse = splat(1) / root(inner(r, r));
    const Pack e[3] = {r[0] * inverse, r[1] * inverse, r[2] * inverse};
    const Pack a = inner(e, f), b = inner(e, v), d = inner(e, m), w = inner(m, v);
    const Pack first = c * inverse, second = first * inverse, third = splat(2) * second * inverse;

    const Pack of_v = second * k * d, of_m = second * k * b, of_f = splat(0.5) * first * fma(splat(-4), nu, splat(3));
    const Pack of_e = fma(splat(0.5) * first, a, second * fma(splat(3) * d, b, splat(0) - k * w));
    for (int i = 0; i < 3; ++i)
      total[6 + i] = fma(of_f, f[i], fma(of_v, v[i], fma(of_m, m[i], fma(of_e, e[i], total[6 + i]))));
    total[9] = fma(d * inverse, inverse, total[9]);

    const Pack bend = splat(3) * nu * third, pull = second * k, db = d * b;
    Pack p[3];
    for (int i = 0; i < 3; ++i) p[i] = fma(pull, f[i], splat(0) - bend * fma(d, v[i], b * m[i]));
    const Pack q = splat(0) - k * third;
    const Pack ee = fma(splat(3) * second, a, third * fma(splat(15), db, splat(-3) * k * w));
    const Pack all = fma(third, fma(fma(splat(-4), nu, splat(1)), w, splat(-3) * k * db), splat(0) - pull * a);
    for (int s = 0; s < 6; ++s) {
      const int i = row_of[s], j = column_of[s];
      Pack t = fma(p[i], e[j], fma(e[i], p[j], q * fma(m[i], v[j], v[i] * m[j])));
      t = fma(ee * e[i], e[j], t);
      total[s] = total[s] + (i == j ? t + all : t);
    }
  }

  void add_to(double* sums) const {
    for (int i = 0; i < somigliana_count; ++i) sums[i] += sum(total[i]);
  }
};

template <ElementType type>
void face_rule(const LoadedFace& face, const NearPoints& points, const double* x, double poisson,
               const LinearField& linear, double* sum) {
  constexpr int nodes = rollcon::node_count(type);
  Pack node[3][nodes];  // nodes relative to the observer, so that what is close to it loses no digits
  for (int j = 0; j < 3; ++j)
    for (int k = 0; k < nodes; ++k) node[j][k] = splat(face.node[j][k] - x[j]);
  SomiglianaSums sums(poisson);
  for (int q = 0; q < points.n; q += lanes) {
    Pack shape[nodes], d_xi[nodes], d_eta[nodes], r[3], along[3], across[3], m[3], f[3], v[3];
    PackShape<type>::evaluate(load(points.xi + q), load(points.eta + q), shape, d_xi, d_eta);
    for (int j = 0; j < 3; ++j) {
      r[j] = along[j] = across[j] = f[j] = splat(0);
      v[j] = splat(-linear.u[j]);
      for (int k = 0; k < nodes; ++k) {
        r[j] = fma(shape[k], node[j][k], r[j]);
        along[j] = fma(d_xi[k], node[j][k], along[j]);
        across[j] = fma(d_eta[k], node[j][k], across[j]);
        f[j] = fma(shape[k], splat(face.traction[j][k]), f[j]);
        v[j] = fma(shape[k], splat(face.u[j][k]), v[j]);
      }
    }
    for (int j = 0; j < 3; ++j) {
      const int a = (j + 1) % 3, b = (j + 2) % 3;
      m[j] = along[a] * across[b] - along[b] * across[a];
    }
    const Pack weight = load(points.w + q), area = weight * root(inner(m, m));  // weights may be negative
    for (Pack& component : m) component = weight * component;
    for (int j = 0; j < 3; ++j) {
      f[j] = area * f[j];
      for (int i = 0; i < 3; ++i) {
        f[j] = fma(splat(-linear.stress[entry_of[j][i]]), m[i], f[j]);
        v[j] = fma(splat(-linear.gradient[j][i]), r[i], v[j]);
      }
    }
    sums.add(r, m, f, v);
  }
  sums.add_to(sum);
}

void face(const LoadedFace& face, NearPoints& points, const double* x, double poisson, const LinearField& linear,
          double* sum) {
  pad(points);
  for_type(face.type, [&]<ElementType type>() { face_rule<type>(face, points, x, poisson, linear, sum); });
}

}  // namespace

namespace rollcon::bem {

extern const SomiglianaKernels ROLLCON_COMPILED(somigliana);
const SomiglianaKernels ROLLCON_COMPILED(somigliana) = {ROLLCON_SET_NAME, face};

}  // namespace rollcon::bem
