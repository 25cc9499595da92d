// Symmetric rules with few points where such are known with positive weights and inner points, collapsed products of
// Gauss-Jacobi rules beyond. Tetrahedra: the orbits' parameters solve the moment equations of their degree (4 and 14
// points: see Keast 1986 and Walkington 2000). Triangles: Strang and Fix (6 points).

#include <cmath>

#include "mesh/quadrature.hpp"
#include "mesh/volume_shape.hpp"

namespace rollcon {
namespace {

constexpr double volume = 1.0 / 6, area = 1.0 / 2;

using Bary4 = std::array<double, 4>;

/// Adds points by barycentric coordinates; weights are fractions of the volume.
void add(VolumeRule& rule, double part, const Bary4& l) {
  rule.point.push_back({l[1], l[2], l[3]});
  rule.w.push_back(part * volume);
}

/// Adds the points a, a, a, 1 - 3a in every order.
void add_31(VolumeRule& rule, double part, double a) {
  for (std::size_t i = 0; i < 4; ++i) {
    Bary4 l{a, a, a, a};
    l[i] = 1 - 3 * a;
    add(rule, part, l);
  }
}

/// Adds the points a, a, 1/2 - a, 1/2 - a in every order.
void add_22(VolumeRule& rule, double part, double a) {
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      Bary4 l{0.5 - a, 0.5 - a, 0.5 - a, 0.5 - a};
      l[i] = l[j] = a;
      add(rule, part, l);
    }
}

VolumeRule tetrahedron_rule(int degree) {
  VolumeRule rule;
  if (degree <= 1) {
    add(rule, 1, {0.25, 0.25, 0.25, 0.25});
  } else if (degree == 2) {
    add_31(rule, 0.25, (5 - std::sqrt(5.0)) / 20);
  } else if (degree == 3) {
    add_31(rule, 0.125, 0.32886164993020291040);
    add_31(rule, 0.125, 0.11295679451251102870);
  } else if (degree <= 5) {
    add_31(rule, 0.11268792571801585080, 0.31088591926330060980);
    add_31(rule, 0.07349304311636194954, 0.09273525031089122640);
    add_22(rule, 0.04254602077708146644, 0.04550370412564964949);
  } else {
    const int n = degree / 2 + 1;
    const LineRule a = gauss_jacobi(n, 2), b = gauss_jacobi(n, 1), c = gauss_legendre(n);
    for (std::size_t i = 0; i < a.x.size(); ++i)
      for (std::size_t j = 0; j < b.x.size(); ++j)
        for (std::size_t k = 0; k < c.x.size(); ++k) {
          // The Jacobian (1 - u)^2 (1 - v) / 64 is the rules' weight with x = (1 + u)/2, y = (1 - x)(1 + v)/2, z = (1 -
          // x - y)(1 + w)/2.
          const double x = 0.5 * (1 + a.x[i]), y = 0.25 * (1 - a.x[i]) * (1 + b.x[j]);
          const double z = 0.125 * (1 - a.x[i]) * (1 - b.x[j]) * (1 + c.x[k]);
          rule.point.push_back({x, y, z});
          rule.w.push_back(a.w[i] * b.w[j] * c.w[k] / 64);
        }
  }
  return rule;
}

/// Adds the points a, a, 1 - 2a in every order.
void add_21(PlaneRule& rule, double part, double a) {
  for (int i = 0; i < 3; ++i) {
    rule.xi.push_back(i == 1 ? 1 - 2 * a : a);
    rule.eta.push_back(i == 2 ? 1 - 2 * a : a);
    rule.w.push_back(part * area);
  }
}

PlaneRule symmetric_triangle_rule(int degree) {
  PlaneRule rule;
  const double third = 1.0 / 3;
  if (degree <= 1) {
    rule = {{third}, {third}, {area}};
  } else if (degree == 2) {
    add_21(rule, third, 1.0 / 6);
  } else if (degree <= 4) {
    const double r = std::sqrt(10.0), s = std::sqrt(38 - 44 * std::sqrt(0.4));
    const double w = std::sqrt(213125 - 53320 * r);
    add_21(rule, (620 + w) / 3720, (8 - r + s) / 18);
    add_21(rule, (620 - w) / 3720, (8 - r - s) / 18);
  } else {
    rule = triangle_rule(degree);
  }
  return rule;
}

VolumeRule product(const PlaneRule& plane, const LineRule& line) {
  VolumeRule rule;
  for (std::size_t k = 0; k < line.x.size(); ++k)
    for (std::size_t i = 0; i < plane.size(); ++i) {
      rule.point.push_back({plane.xi[i], plane.eta[i], line.x[k]});
      rule.w.push_back(plane.w[i] * line.w[k]);
    }
  return rule;
}

}  // namespace

VolumeRule volume_rule(VolumeType type, int degree) {
  switch (corner_count(type)) {
    case 4:
      return tetrahedron_rule(degree);
    case 6:
      return product(symmetric_triangle_rule(degree), gauss_legendre(degree / 2 + 1));
    default:
      return product(square_rule(degree), gauss_legendre(degree / 2 + 1));
  }
}

}  // namespace rollcon
