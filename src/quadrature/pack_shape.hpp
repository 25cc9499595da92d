// Evaluates shape functions at several reference points at once; mesh/shape.cpp has the scalar ones.
#pragma once

#include "mesh/element_type.hpp"
#include "quadrature/pack.hpp"

namespace {

using rollcon::ElementType;

template <ElementType type>
struct PackShape;

struct Barycentric {
  Pack l[3];
  static constexpr double d_xi[3] = {-1, 1, 0}, d_eta[3] = {-1, 0, 1};
  Barycentric(Pack xi, Pack eta) : l{splat(1) - xi - eta, xi, eta} {}
};

template <>
struct PackShape<ElementType::tri3> {
  static void evaluate(Pack xi, Pack eta, Pack* n, Pack* u, Pack* v) {
    const Barycentric b(xi, eta);
    for (int i = 0; i < 3; ++i) {
      n[i] = b.l[i];
      u[i] = splat(Barycentric::d_xi[i]);
      v[i] = splat(Barycentric::d_eta[i]);
    }
  }
};

template <>
struct PackShape<ElementType::tri6> {
  static void evaluate(Pack xi, Pack eta, Pack* n, Pack* u, Pack* v) {
    const Barycentric b(xi, eta);
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const Pack slope = splat(4) * b.l[i] - splat(1);
      n[i] = b.l[i] * (splat(2) * b.l[i] - splat(1));
      u[i] = slope * splat(Barycentric::d_xi[i]);
      v[i] = slope * splat(Barycentric::d_eta[i]);
      const Pack li = splat(4) * b.l[i], lj = splat(4) * b.l[j];
      n[3 + i] = li * b.l[j];
      u[3 + i] = splat(Barycentric::d_xi[i]) * lj + splat(Barycentric::d_xi[j]) * li;
      v[3 + i] = splat(Barycentric::d_eta[i]) * lj + splat(Barycentric::d_eta[j]) * li;
    }
  }
};

constexpr double square_xi[9] = {-1, 1, 1, -1, 0, 1, 0, -1, 0};
constexpr double square_eta[9] = {-1, -1, 1, 1, -1, 0, 1, 0, 0};

template <>
struct PackShape<ElementType::quad4> {
  static void evaluate(Pack xi, Pack eta, Pack* n, Pack* u, Pack* v) {
    for (int i = 0; i < 4; ++i) {
      const Pack a = splat(square_xi[i]), b = splat(square_eta[i]);
      const Pack f = splat(1) + a * xi, g = splat(0.25) + splat(0.25) * b * eta;
      n[i] = f * g;
      u[i] = a * g;
      v[i] = splat(0.25) * b * f;
    }
  }
};

template <>
struct PackShape<ElementType::quad8> {
  static void evaluate(Pack xi, Pack eta, Pack* n, Pack* u, Pack* v) {
    for (int i = 0; i < 4; ++i) {
      const Pack a = splat(square_xi[i]), b = splat(square_eta[i]);
      const Pack s = a * xi, t = b * eta;
      const Pack f = splat(1) + s, g = splat(0.25) + splat(0.25) * t;
      n[i] = f * g * (s + t - splat(1));
      u[i] = a * g * (s + s + t);
      v[i] = splat(0.25) * b * f * (s + t + t);
    }
    for (int i = 4; i < 8; i += 2) {
      const Pack b = splat(square_eta[i]), f = splat(0.5) + splat(0.5) * b * eta;
      const Pack bubble = splat(1) - xi * xi;
      n[i] = f * bubble;
      u[i] = splat(-2) * xi * f;
      v[i] = splat(0.5) * b * bubble;
    }
    for (int i = 5; i < 8; i += 2) {
      const Pack a = splat(square_xi[i]), f = splat(0.5) + splat(0.5) * a * xi;
      const Pack bubble = splat(1) - eta * eta;
      n[i] = f * bubble;
      u[i] = splat(0.5) * a * bubble;
      v[i] = splat(-2) * eta * f;
    }
  }
};

template <>
struct PackShape<ElementType::quad9> {
  static void evaluate(Pack xi, Pack eta, Pack* n, Pack* u, Pack* v) {
    // The products are of quadratic Lagrange functions of the nodes -1, 0, 1 along each axis.
    const Pack half = splat(0.5), one = splat(1);
    const Pack fx[3] = {half * xi * (xi - one), one - xi * xi, half * xi * (xi + one)};
    const Pack gx[3] = {xi - half, splat(-2) * xi, xi + half};
    const Pack fy[3] = {half * eta * (eta - one), one - eta * eta, half * eta * (eta + one)};
    const Pack gy[3] = {eta - half, splat(-2) * eta, eta + half};
    for (int i = 0; i < 9; ++i) {
      const int a = static_cast<int>(square_xi[i]) + 1, b = static_cast<int>(square_eta[i]) + 1;
      n[i] = fx[a] * fy[b];
      u[i] = gx[a] * fy[b];
      v[i] = fx[a] * gy[b];
    }
  }
};

/// Calls run.operator()<type>() for a type known at run time only.
template <class Run>
inline void for_type(ElementType type, Run run) {
  switch (type) {
    case ElementType::tri3:
      return run.template operator()<ElementType::tri3>();
    case ElementType::tri6:
      return run.template operator()<ElementType::tri6>();
    case ElementType::quad4:
      return run.template operator()<ElementType::quad4>();
    case ElementType::quad8:
      return run.template operator()<ElementType::quad8>();
    case ElementType::quad9:
      return run.template operator()<ElementType::quad9>();
  }
}

/// Calls run.operator()<number>() for one of some numbers, and for the last where `number` is none of the others.
template <int first, int... others, class Run>
inline void for_number(int number, Run run) {
  if constexpr (sizeof...(others) == 0) {
    run.template operator()<first>();
  } else {
    if (number == first) return run.template operator()<first>();
    for_number<others...>(number, run);
  }
}
template <class Run>
inline void for_nodes(int nodes, Run run) {
  for_number<3, 4, 6, 8, 9>(nodes, run);
}

}  // namespace
