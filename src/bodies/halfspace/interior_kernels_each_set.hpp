// The kernels are written once and compiled for each instruction set (cmake/RollconKernels.cmake). Linkage is internal
// throughout; only the table of functions leaves the file.
#pragma once

#include "bodies/halfspace/interior_kernels.hpp"
#include "quadrature/pack.hpp"
#include "quadrature/pack_shape.hpp"

namespace {

using namespace rollcon::halfspace;

/// Computes the nine sums of interior_kernels.hpp.
struct Sums {
  Pack total[interior_count];
  Pack kappa;

  explicit Sums(double k) : kappa(splat(k)) {
    for (Pack& t : total) t = splat(0);
  }

  inline void add(Pack dx, Pack dy, Pack dz, Pack fx, Pack fy, Pack fz) {
    const Pack one = splat(1), two = splat(2);
    const Pack inverse = one / root(fma(dx, dx, fma(dy, dy, dz * dz)));
    const Pack a = dx * inverse, b = dy * inverse, c = dz * inverse, k = one / (one + c);
    const Pack s = fma(a, fx, b * fy), t = fma(c, fz, s);
    const Pack aa = a * a, bb = b * b, ab = a * b, square = inverse * inverse, kk = k * k;
    const Pack main = splat(-3) * t * square, extra = kappa * square;
    const Pack w = kk * fma(fz, two + c, s * fma(two, k, one));
    const Pack h = fma(fz, c - k, s * (one - kk));
    total[0] = fma(main, aa, fma(extra, fma(aa, w, h) - two * kk * a * fx, total[0]));
    total[1] = fma(main, bb, fma(extra, fma(bb, w, h) - two * kk * b * fy, total[1]));
    total[2] = fma(main, c * c, total[2]);
    total[3] = fma(main, ab, fma(extra, fma(ab, w, splat(0) - kk * fma(b, fx, a * fy)), total[3]));
    total[4] = fma(main, a * c, total[4]);
    total[5] = fma(main, b * c, total[5]);
    const Pack down = fma(k, s, fz), weight = kappa * inverse, across = k * weight;
    total[6] = fma(inverse, fma(t, a, fx), fma(across, fx - a * down, total[6]));
    total[7] = fma(inverse, fma(t, b, fy), fma(across, fy - b * down, total[7]));
    total[8] = fma(inverse, fma(t, c, fz), fma(weight, down, total[8]));
  }

  void add_to(double* sums) const {
    for (int i = 0; i < interior_count; ++i) sums[i] += sum(total[i]);
  }
};

void push(const InteriorForces& forces, const InteriorPoint& at, double kappa, double* sum) {
  const Pack ox = splat(at.x), oy = splat(at.y), oz = splat(at.z);
  Sums sums(kappa);
  for (int q = 0; q < forces.n; q += lanes)
    sums.add(ox - load(forces.x + q), oy - load(forces.y + q), oz, load(forces.force[0] + q), load(forces.force[1] + q),
             load(forces.force[2] + q));
  sums.add_to(sum);
}

template <ElementType type>
void element_rule(const InteriorElement& element, const NearPoints& points, const InteriorPoint& at, double kappa,
                  double* sum) {
  constexpr int nodes = rollcon::node_count(type);
  // Nodes relative to the observer lose no digits of what is close to it, those relative to the first node no digits of
  // the element's area, however far it is.
  Pack node_x[nodes], node_y[nodes], side_x[nodes], side_y[nodes];
  for (int i = 0; i < nodes; ++i) {
    node_x[i] = splat(element.x[i] - at.x), node_y[i] = splat(element.y[i] - at.y);
    side_x[i] = splat(element.x[i] - element.x[0]), side_y[i] = splat(element.y[i] - element.y[0]);
  }
  const Pack oz = splat(at.z);
  Sums sums(kappa);
  for (int q = 0; q < points.n; q += lanes) {
    Pack n[nodes], u[nodes], v[nodes];
    PackShape<type>::evaluate(load(points.xi + q), load(points.eta + q), n, u, v);
    Pack x = splat(0), y = x, xu = x, xv = x, yu = x, yv = x, fx = x, fy = x, fz = x;
    for (int i = 0; i < nodes; ++i) {
      x = fma(n[i], node_x[i], x);
      y = fma(n[i], node_y[i], y);
      xu = fma(u[i], side_x[i], xu);
      xv = fma(v[i], side_x[i], xv);
      yu = fma(u[i], side_y[i], yu);
      yv = fma(v[i], side_y[i], yv);
      fx = fma(n[i], splat(element.traction[0][i]), fx);
      fy = fma(n[i], splat(element.traction[1][i]), fy);
      fz = fma(n[i], splat(element.traction[2][i]), fz);
    }
    const Pack w = load(points.w + q) * (xu * yv - xv * yu);
    sums.add(splat(0) - x, splat(0) - y, oz, w * fx, w * fy, w * fz);
  }
  sums.add_to(sum);
}

void element(const InteriorElement& element, const NearPoints& points, const InteriorPoint& at, double kappa,
             double* sum) {
  for_type(element.type, [&]<ElementType type>() { element_rule<type>(element, points, at, kappa, sum); });
}

}  // namespace

namespace rollcon::halfspace {

extern const InteriorKernels ROLLCON_COMPILED(interior_kernels);
const InteriorKernels ROLLCON_COMPILED(interior_kernels) = {ROLLCON_SET_NAME, push, element};

}  // namespace rollcon::halfspace
