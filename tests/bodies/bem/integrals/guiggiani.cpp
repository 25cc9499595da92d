#include "bodies/bem/integrals/guiggiani.hpp"

#include <cmath>
#include <vector>

#include "mesh/quadrature.hpp"
#include "mesh/shape.hpp"

namespace rollcon::guiggiani {
namespace {

using element_reference::Integrals;
using element_reference::Reference;

struct Point {
  Vec3 x{}, u{}, v{};
  Shape shape;
};

Point evaluate(const SurfaceMesh& mesh, double xi, double eta) {
  Point p;
  evaluate_shape(mesh.type[0], xi, eta, p.shape);
  for (std::size_t k = 0; k < mesh.node.size(); ++k) {
    p.x = p.x + p.shape.value[k] * mesh.node[k];
    p.u = p.u + p.shape.d_xi[k] * mesh.node[k];
    p.v = p.v + p.shape.d_eta[k] * mesh.node[k];
  }
  return p;
}

}  // namespace

Integrals finite_part(const SurfaceMesh& mesh, Reference at, double poisson) {
  Integrals result;
  const bool triangle = corner_count(mesh.type[0]) == 3;
  const std::vector<Reference> corner = triangle ? std::vector<Reference>{{0, 0}, {1, 0}, {0, 1}}
                                                 : std::vector<Reference>{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const Point centre = evaluate(mesh, at.xi, at.eta);
  const Vec3 normal0 = cross(centre.u, centre.v);
  const LineRule angle = gauss_legendre(40), radius = gauss_legendre(24);
  for (std::size_t e = 0; e < corner.size(); ++e) {
    const Reference a = corner[e], b = corner[(e + 1) % corner.size()];
    const double ax = a.xi - at.xi, ay = a.eta - at.eta, bx = b.xi - at.xi, by = b.eta - at.eta;
    const double area = ax * by - ay * bx;
    if (area < 1e-12) continue;
    const double begin = std::atan2(ay, ax), turn = std::atan2(area, ax * bx + ay * by);
    for (std::size_t j = 0; j < angle.x.size(); ++j) {
      const double theta = begin + 0.5 * turn * (1 + angle.x[j]), weight = 0.5 * turn * angle.w[j];
      const double c = std::cos(theta), s = std::sin(theta);
      const double end = area / ((bx - ax) * -s + (by - ay) * c);  // distance of the edge
      const Vec3 tangent = c * centre.u + s * centre.v;
      const double stretch = length(tangent);
      // The leading term is T J rho^2 to first order: on the tangent plane dr/dn = 0.
      const auto leading = element_reference::kelvin((1 / stretch) * tangent, normal0, poisson);
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k)
          for (std::size_t n = 0; n < mesh.node.size(); ++n)
            result.t[3 * k + i][n] +=
                weight * leading[3 * i + k] / (stretch * stretch) * centre.shape.value[n] * std::log(end * stretch);
      for (std::size_t r = 0; r < radius.x.size(); ++r) {
        const double rho = 0.5 * end * (1 + radius.x[r]), w = weight * 0.5 * end * radius.w[r];
        const Point p = evaluate(mesh, at.xi + rho * c, at.eta + rho * s);
        const auto f = element_reference::kelvin(p.x - centre.x, cross(p.u, p.v), poisson);
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t n = 0; n < mesh.node.size(); ++n)
              result.t[3 * k + i][n] += w * (f[3 * i + k] * rho * p.shape.value[n] -
                                             leading[3 * i + k] / (stretch * stretch) * centre.shape.value[n] / rho);
      }
    }
  }
  return result;
}

}  // namespace rollcon::guiggiani
