// The kernels are written once and compiled for each instruction set (cmake/RollconKernels.cmake). Linkage is internal
// throughout; only the table of functions leaves the file.
#pragma once

#include "bodies/bem/kelvin.hpp"
#include "quadrature/pack.hpp"
#include "quadrature/pack_shape.hpp"

namespace {

using rollcon::max_element_nodes;
using rollcon::bem::both_layers;
using rollcon::bem::double_layer;
using rollcon::bem::far_capacity;
using rollcon::bem::FarPoints;
using rollcon::bem::KelvinConstants;
using rollcon::bem::near_capacity;
using rollcon::bem::NearElement;
using rollcon::bem::NearIntegrals;
using rollcon::bem::NearPoints;
using rollcon::bem::pack_points;
using rollcon::bem::PointPack;
using rollcon::bem::RuleTable;
using rollcon::bem::single_layer;

constexpr int kernel_count(int terms) {
  return 9 * (terms & 1) + 3 * (terms & 2);
}

/// Computes entries of T (nine, if wanted) and then of U (six, if wanted) at r = y - x, for n and w with the weight in
/// them; `share` scales all of them.
template <int terms>
inline void kelvin(const Pack* r, const Pack* n, Pack w, Pack share, const KelvinConstants& c, Pack* f) {
  const Pack r2 = fma(r[0], r[0], fma(r[1], r[1], r[2] * r[2]));
  const Pack inverse = splat(1) / root(r2);
  const Pack e[3] = {r[0] * inverse, r[1] * inverse, r[2] * inverse};
  const Pack near = share * inverse;
  if constexpr ((terms & double_layer) != 0) {
    const Pack scale = near * inverse;
    const Pack m[3] = {scale * n[0], scale * n[1], scale * n[2]};
    const Pack dn = fma(e[0], m[0], fma(e[1], m[1], e[2] * m[2]));
    const Pack skew = splat(c.skew), b = splat(c.triple) * dn, iso = skew * dn;
    const Pack be[3] = {b * e[0], b * e[1], b * e[2]};
    const Pack s[3] = {skew * e[0], skew * e[1], skew * e[2]};
    // Entry 3 c + i holds T_ic.
    for (int i = 0; i < 3; ++i) f[4 * i] = fma(be[i], e[i], iso);
    constexpr int pair[3][2] = {{0, 1}, {0, 2}, {1, 2}};
    for (const auto& p : pair) {
      const int i = p[0], j = p[1];
      const Pack even = be[i] * e[j], odd = s[i] * m[j] - s[j] * m[i];
      f[3 * j + i] = even - odd;
      f[3 * i + j] = even + odd;
    }
    f += 9;
  }
  if constexpr ((terms & single_layer) != 0) {
    const Pack scale = near * w, iso = splat(c.iso) * scale, single = splat(c.single) * scale;
    const Pack s[3] = {single * e[0], single * e[1], single * e[2]};
    f[0] = fma(s[0], e[0], iso);
    f[1] = s[0] * e[1];
    f[2] = s[0] * e[2];
    f[3] = fma(s[1], e[1], iso);
    f[4] = s[1] * e[2];
    f[5] = fma(s[2], e[2], iso);
  }
}

/// Computes position, and tangents' cross product times weight, from shape functions and nodes.
template <int nodes, class Node>
inline void surface(const Pack* value, const Pack* d_xi, const Pack* d_eta, Pack w, Node node, Pack* y, Pack* n,
                    Pack* area) {
  Pack u[3], v[3];
  for (int j = 0; j < 3; ++j) {
    const Pack first = node(j, 0);
    y[j] = value[0] * first;
    u[j] = d_xi[0] * first;
    v[j] = d_eta[0] * first;
  }
  for (int k = 1; k < nodes; ++k)
    for (int j = 0; j < 3; ++j) {
      const Pack a = node(j, k);
      y[j] = fma(value[k], a, y[j]);
      u[j] = fma(d_xi[k], a, u[j]);
      v[j] = fma(d_eta[k], a, v[j]);
    }
  for (int j = 0; j < 3; ++j) {
    const int a = (j + 1) % 3, b = (j + 2) % 3;
    n[j] = u[a] * v[b] - u[b] * v[a];
  }
  *area = w * root(fma(n[0], n[0], fma(n[1], n[1], n[2] * n[2])));
  for (int j = 0; j < 3; ++j) n[j] = w * n[j];
}

template <int nodes>
void place_points(const RuleTable& rule, const double (*node)[max_element_nodes], FarPoints& points) {
  for (int q = 0; q < rule.n; q += lanes) {
    Pack value[nodes], u[nodes], v[nodes], y[3], n[3], area;
    for (int k = 0; k < nodes; ++k) {
      value[k] = load(rule.value + k * rule.padded + q);
      u[k] = load(rule.d_xi + k * rule.padded + q);
      v[k] = load(rule.d_eta + k * rule.padded + q);
    }
    surface<nodes>(
        value, u, v, load(rule.w + q), [node](int j, int k) { return splat(node[j][k]); }, y, n, &area);
    for (int j = 0; j < 3; ++j) {
      store(points.y[j] + q, y[j]);
      store(points.n[j] + q, n[j]);
    }
    store(points.w + q, area);
  }
}

void place(const RuleTable& rule, int nodes, const double (*node)[max_element_nodes], FarPoints& points) {
  for_nodes(nodes, [&]<int n>() { place_points<n>(rule, node, points); });
}

/// Sets how many quadrature points have kernel values staged between the kernel and the product with the shape
/// functions: all of it together would not fit the registers.
constexpr int block = 16;

/// Lists the places that an entry of U goes to: two, but one on the diagonal.
constexpr int u_entry[6][2] = {{0, 0}, {1, 3}, {2, 6}, {4, 4}, {5, 7}, {8, 8}};

/// Cuts products with the shape functions so that their sums stay in registers.
template <int nodes>
struct Tile {
  static constexpr int entries = 3;
  static constexpr int height = lanes == 8 || nodes <= 4 ? nodes : nodes == 8 ? 4 : 3;
};

/// Adds the sum over q of f[q][entry] value[k][q] to block[k][entry] for a tile of nodes from k0 on and of entries of T
/// or U from i0 on. All but q is known to the compiler: rules have few points, and addresses worked out at run time
/// would cost as much as the sums.
template <int nodes, int terms, bool of_u, int k0, int i0>
inline void add_tile(const Pack (*f)[15], int n, const double* value, int padded, double* const* target) {
  constexpr int height = Tile<nodes>::height, entries = Tile<nodes>::entries;
  constexpr int first = i0 + (of_u ? 9 * (terms & double_layer) : 0);
  Pack total[height][entries];
  for (int k = 0; k < height; ++k)
    for (int j = 0; j < entries; ++j) {
      const int to = of_u ? u_entry[i0 + j][0] : i0 + j;
      total[k][j] = load(target[k0 + k] + to * pack_points);
    }
  const double* v = value + k0 * padded;
  for (int q = 0; q < n; ++q) {
    Pack e[entries];
    for (int j = 0; j < entries; ++j) e[j] = f[q][first + j];
    for (int k = 0; k < height; ++k) {
      const Pack s = splat(v[k * padded + q]);
      for (int j = 0; j < entries; ++j) total[k][j] = fma(e[j], s, total[k][j]);
    }
  }
  for (int k = 0; k < height; ++k)
    for (int j = 0; j < entries; ++j) {
      double* to = target[k0 + k];
      if constexpr (of_u) {
        store(to + u_entry[i0 + j][0] * pack_points, total[k][j]);
        if (u_entry[i0 + j][1] != u_entry[i0 + j][0]) store(to + u_entry[i0 + j][1] * pack_points, total[k][j]);
      } else {
        store(to + (i0 + j) * pack_points, total[k][j]);
      }
    }
}

template <int nodes, int terms, bool of_u, int k0 = 0, int i0 = 0>
inline void add_tiles(const Pack (*f)[15], int n, const double* value, int padded, double* const* target) {
  add_tile<nodes, terms, of_u, k0, i0>(f, n, value, padded, target);
  if constexpr (k0 + Tile<nodes>::height < nodes)
    add_tiles<nodes, terms, of_u, k0 + Tile<nodes>::height, i0>(f, n, value, padded, target);
  else if constexpr (i0 + Tile<nodes>::entries < (of_u ? 6 : 9))
    add_tiles<nodes, terms, of_u, 0, i0 + Tile<nodes>::entries>(f, n, value, padded, target);
}

template <int nodes, int terms>
void far_points(const FarPoints& points, const RuleTable& rule, const PointPack& pack, const KelvinConstants& constants,
                double* const* h, double* const* g) {
  for (int part = 0; part < pack_points; part += lanes) {
    const Pack x[3] = {load(pack.x[0] + part), load(pack.x[1] + part), load(pack.x[2] + part)};
    const Pack mask = load(pack.mask + part);
    double *hp[nodes] = {}, *gp[nodes] = {};
    for (int k = 0; k < nodes; ++k) {
      if constexpr ((terms & double_layer) != 0) hp[k] = h[k] + part;
      if constexpr ((terms & single_layer) != 0) gp[k] = g[k] + part;
    }
    for (int start = 0; start < rule.n; start += block) {
      const int n = rule.n - start < block ? rule.n - start : block;
      Pack f[block][15];
      for (int q = 0; q < n; ++q) {
        const int at = start + q;
        const Pack r[3] = {splat(points.y[0][at]) - x[0], splat(points.y[1][at]) - x[1], splat(points.y[2][at]) - x[2]};
        const Pack normal[3] = {splat(points.n[0][at]), splat(points.n[1][at]), splat(points.n[2][at])};
        kelvin<terms>(r, normal, splat(points.w[at]), mask, constants, f[q]);
      }
      const double* value = rule.value + start;
      if constexpr ((terms & double_layer) != 0) add_tiles<nodes, terms, false>(f, n, value, rule.padded, hp);
      if constexpr ((terms & single_layer) != 0) add_tiles<nodes, terms, true>(f, n, value, rule.padded, gp);
    }
  }
}

template <class Run>
void for_layers(int terms, Run run) {
  for_number<double_layer, single_layer, both_layers>(terms, run);
}

void far(const FarPoints& points, const RuleTable& rule, int nodes, const PointPack& pack,
         const KelvinConstants& constants, int terms, double* const* h, double* const* g) {
  for_nodes(nodes, [&]<int n>() {
    for_layers(terms, [&]<int t>() { far_points<n, t>(points, rule, pack, constants, h, g); });
  });
}

/// Computes rows x nodes dot products over packs of quadrature points, three rows at once.
template <int nodes>
inline void products(const Pack (*f)[near_capacity / lanes], int rows, const Pack (*value)[near_capacity / lanes],
                     int packs, double (*sums)[max_element_nodes]) {
  for (int i = 0; i < rows; i += 3)
    for (int k = 0; k < nodes; ++k) {
      Pack a = splat(0), b = a, c = a;
      for (int q = 0; q < packs; ++q) {
        a = fma(f[i][q], value[k][q], a);
        b = fma(f[i + 1][q], value[k][q], b);
        c = fma(f[i + 2][q], value[k][q], c);
      }
      sums[i][k] += sum(a);
      sums[i + 1][k] += sum(b);
      sums[i + 2][k] += sum(c);
    }
}

template <ElementType type, int terms>
void near_points(const NearElement& element, const NearPoints& points, const KelvinConstants& constants,
                 NearIntegrals& integrals) {
  constexpr int nodes = rollcon::node_count(type), count = kernel_count(terms);
  Pack f[count][near_capacity / lanes], shape[nodes][near_capacity / lanes];
  int packs = 0;
  for (int q = 0; q < points.n; q += lanes, ++packs) {
    Pack value[nodes], u[nodes], v[nodes], r[3], n[3], area, entry[count];
    PackShape<type>::evaluate(load(points.xi + q), load(points.eta + q), value, u, v);
    surface<nodes>(
        value, u, v, load(points.w + q), [&element](int j, int k) { return splat(element.node[j][k]); }, r, n, &area);
    kelvin<terms>(r, n, area, splat(1), constants, entry);
    for (int i = 0; i < count; ++i) f[i][packs] = entry[i];
    for (int k = 0; k < nodes; ++k) shape[k][packs] = value[k];
  }
  if constexpr ((terms & double_layer) != 0) products<nodes>(f, 9, shape, packs, integrals.t);
  if constexpr ((terms & single_layer) != 0) products<nodes>(f + 9 * (terms & 1), 6, shape, packs, integrals.u);
}

void near(const NearElement& element, NearPoints& points, const KelvinConstants& constants, int terms,
          NearIntegrals& integrals) {
  pad(points);
  for_type(element.type, [&]<ElementType type>() {
    for_layers(terms, [&]<int t>() { near_points<type, t>(element, points, constants, integrals); });
  });
}

}  // namespace

namespace rollcon::bem {

extern const Kernels ROLLCON_COMPILED(kelvin);
const Kernels ROLLCON_COMPILED(kelvin) = {ROLLCON_SET_NAME, place, far, near};

}  // namespace rollcon::bem
