#pragma once
/// Quadrature over a curved surface mesh.

#include <cstddef>
#include <cstdint>

#include "mesh/quadrature.hpp"
#include "mesh/shape.hpp"
#include "mesh/surface_mesh.hpp"

namespace rollcon {

/// Calls f(shape, point, area) at the points of a rule on an element; area: weight times the
/// surface Jacobian. That is the root of a polynomial and exact on flat elements only; on quadratic
/// ones that span 22 degrees of a sphere both ways integrals of N_i are right to 1e-11, with 45
/// degrees to 6e-9.
template <class F>
void integrate_element(const SurfaceMesh& mesh, std::int64_t element, F f) {
  constexpr int degree = 11;
  static const PlaneRule triangle = triangle_rule(degree), square = square_rule(degree);
  const ElementType type = mesh.type[static_cast<std::size_t>(element)];
  const auto nodes = mesh.element(element);
  const PlaneRule& rule = corner_count(type) == 3 ? triangle : square;
  const Vec3 origin = mesh.node[static_cast<std::size_t>(nodes[0])];
  Shape shape;
  for (std::size_t q = 0; q < rule.size(); ++q) {
    evaluate_shape(type, rule.xi[q], rule.eta[q], shape);
    Vec3 x{}, u{}, v{};  // relative to a node: elements far from the origin lose no digits
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const Vec3 r = mesh.node[static_cast<std::size_t>(nodes[i])] - origin;
      x = x + shape.value[i] * r;
      u = u + shape.d_xi[i] * r;
      v = v + shape.d_eta[i] * r;
    }
    f(shape, origin + x, rule.w[q] * length(cross(u, v)));
  }
}

/// Calls f(element, shape, point, area) likewise on every element.
template <class F>
void integrate_surface(const SurfaceMesh& mesh, F f) {
  for (std::int64_t e = 0; e < mesh.elements(); ++e)
    integrate_element(
        mesh, e, [&](const Shape& shape, const Vec3& x, double area) { f(e, shape, x, area); });
}

}  // namespace rollcon
