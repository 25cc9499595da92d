// The kernels are written once and compiled for each instruction set (cmake/RollconKernels.cmake). Linkage is internal
// throughout; only the table of functions leaves the file.
#pragma once

#include "bodies/halfspace/kernels.hpp"
#include "quadrature/pack.hpp"
#include "quadrature/pack_shape.hpp"

namespace {

using namespace rollcon::halfspace;

/// Fills the first 1 + 2 (shear) + 2 (coupling) entries of f with weighted kernel values of integrals 0 to 4 at a pack
/// of sources; dx, dy from source to observer.
template <int terms>
inline void kernel_values(Pack dx, Pack dy, Pack w, Pack* f) {
  const Pack inverse = splat(1) / root(fma(dx, dx, dy * dy));
  const Pack c = dx * inverse, s = dy * inverse;
  f[0] = w * inverse;
  int k = 1;
  if constexpr ((terms & with_shear) != 0) {
    f[k++] = f[0] * c * c;
    f[k++] = f[0] * c * s;
  }
  if constexpr ((terms & with_coupling) != 0) {
    f[k++] = f[0] * c;
    f[k++] = f[0] * s;
  }
}

constexpr int wanted(int terms) {
  return 1 + 2 * (terms & 1) + (terms & 2);
}

/// Computes integrals of the shape functions in `packs` packs: kernel values first, then their product with the table
/// of shape functions, whose rows are the same for all elements.
template <int terms, int packs>
void far_rule(const FarSources& rule, std::int64_t element, double px, double py, double* integral) {
  constexpr int count = wanted(terms);
  alignas(64) double value[count][far_capacity];
  const Pack ox = splat(px), oy = splat(py);
  const double* x = rule.x + element * rule.padded;
  const double* y = rule.y + element * rule.padded;
  const double* w = rule.w + element * rule.padded;
  for (int q = 0; q < rule.n; q += lanes) {
    Pack f[count];
    kernel_values<terms>(ox - load(x + q), oy - load(y + q), load(w + q), f);
    for (int k = 0; k < count; ++k) store(value[k] + q, f[k]);
  }
  Pack total[count][packs];
  for (auto& row : total)
    for (Pack& t : row) t = splat(0);
  for (int q = 0; q < rule.n; ++q) {
    const double* shape = rule.shape + q * rule.stride;
    Pack n[packs];
    for (int i = 0; i < packs; ++i) n[i] = load(shape + i * lanes);
    for (int k = 0; k < count; ++k) {
      const Pack f = splat(value[k][q]);
      for (int i = 0; i < packs; ++i) total[k][i] = fma(f, n[i], total[k][i]);
    }
  }
  for (int k = 0; k < count; ++k)
    for (int i = 0; i < packs; ++i) store(integral + k * max_shape_stride + i * lanes, total[k][i]);
}

template <class Run>
void for_terms(int terms, Run run) {
  for_number<normal_only, with_shear, with_coupling, all_terms>(terms, run);
}

void far(const FarSources& rule, std::int64_t element, double px, double py, int terms, double* integral) {
  for_nodes(rule.nodes, [&]<int nodes>() {
    constexpr int packs = (nodes + lanes - 1) / lanes;
    for_terms(terms, [&]<int t>() { far_rule<t, packs>(rule, element, px, py, integral); });
  });
}

template <int terms>
void push_forces(const FarForces& rule, std::int64_t element, double px, double py, const double* constants,
                 double* u) {
  const Pack ox = splat(px), oy = splat(py);
  const Pack cn = splat(constants[0]), cv = splat(constants[1]), ck = splat(constants[2]);
  const std::int64_t first = element * rule.padded;
  Pack ux = splat(0), uy = splat(0), un = splat(0);
  for (int q = 0; q < rule.n; q += lanes) {
    const Pack dx = ox - load(rule.x + first + q), dy = oy - load(rule.y + first + q);
    const Pack fx = load(rule.force[0] + first + q), fy = load(rule.force[1] + first + q),
               fn = load(rule.force[2] + first + q);
    const Pack inverse = splat(1) / root(fma(dx, dx, dy * dy));
    const Pack c = dx * inverse, s = dy * inverse;
    const Pack along = fma(c, fx, s * fy);
    Pack radial = splat(0), down = cn * fn;
    if constexpr ((terms & with_shear) != 0) radial = cv * along;
    if constexpr ((terms & with_coupling) != 0) {
      radial = fma(ck, fn, radial);
      down = down - ck * along;
    }
    ux = fma(inverse, fma(cn, fx, radial * c), ux);
    uy = fma(inverse, fma(cn, fy, radial * s), uy);
    un = fma(inverse, down, un);
  }
  u[0] += sum(ux);
  u[1] += sum(uy);
  u[2] += sum(un);
}

void push(const FarForces& rule, std::int64_t element, double px, double py, const double* constants, int terms,
          double* u) {
  for_terms(terms, [&]<int t>() { push_forces<t>(rule, element, px, py, constants, u); });
}

template <ElementType type, int terms>
void near_rule(const NearElement& element, const NearPoints& points, double* integral) {
  constexpr int nodes = rollcon::node_count(type), count = wanted(terms);
  Pack total[count][nodes];
  for (auto& row : total)
    for (Pack& t : row) t = splat(0);
  for (int q = 0; q < points.n; q += lanes) {
    Pack n[nodes], u[nodes], v[nodes];
    PackShape<type>::evaluate(load(points.xi + q), load(points.eta + q), n, u, v);
    Pack x = splat(0), y = x, xu = x, xv = x, yu = x, yv = x;
    for (int i = 0; i < nodes; ++i) {
      const Pack a = splat(element.x[i]), b = splat(element.y[i]);
      x = fma(n[i], a, x);
      y = fma(n[i], b, y);
      xu = fma(u[i], a, xu);
      xv = fma(v[i], a, xv);
      yu = fma(u[i], b, yu);
      yv = fma(v[i], b, yv);
    }
    const Pack jacobian = xu * yv - xv * yu;
    Pack f[count];
    kernel_values<terms>(splat(0) - x, splat(0) - y, load(points.w + q) * jacobian, f);
    for (int k = 0; k < count; ++k)
      for (int i = 0; i < nodes; ++i) total[k][i] = fma(f[k], n[i], total[k][i]);
  }
  for (int k = 0; k < count; ++k)
    for (int i = 0; i < nodes; ++i) integral[k * max_shape_stride + i] += sum(total[k][i]);
}

void near(const NearElement& element, NearPoints& points, int terms, double* integral) {
  pad(points);
  for_type(element.type, [&]<ElementType type>() {
    for_terms(terms, [&]<int t>() { near_rule<type, t>(element, points, integral); });
  });
}

}  // namespace

namespace rollcon::halfspace {

extern const Kernels ROLLCON_COMPILED(kernels);
const Kernels ROLLCON_COMPILED(kernels) = {ROLLCON_SET_NAME, far, push, near};

}  // namespace rollcon::halfspace
