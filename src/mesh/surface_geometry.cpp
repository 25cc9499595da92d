#include "mesh/surface_geometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "mesh/quadrature.hpp"
#include "mesh/surface_quadrature.hpp"

namespace rollcon {
namespace {

const Vec3& position(const SurfaceMesh& mesh, std::int32_t node) {
  return mesh.node[static_cast<std::size_t>(node)];
}

}  // namespace

SurfaceFrame combine(const SurfaceMesh& mesh, std::int64_t element, const Shape& s, const Vec3& origin) {
  const auto nodes = mesh.element(element);
  SurfaceFrame f{};
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Vec3 p = position(mesh, nodes[i]) - origin;
    for (std::size_t k = 0; k < 3; ++k) {
      f.x[k] += s.value[i] * p[k];
      f.d_xi[k] += s.d_xi[i] * p[k];
      f.d_eta[k] += s.d_eta[i] * p[k];
    }
  }
  f.normal = cross(f.d_xi, f.d_eta);
  return f;
}

std::vector<TabulatedPoint> tabulate(ElementType type, int degree) {
  const PlaneRule rule = corner_count(type) == 3 ? triangle_rule(degree) : square_rule(degree);
  std::vector<TabulatedPoint> table(rule.size());
  for (std::size_t q = 0; q < rule.size(); ++q) {
    table[q].weight = rule.w[q];
    evaluate_shape(type, rule.xi[q], rule.eta[q], table[q].shape);
  }
  return table;
}

SurfaceFrame evaluate_surface(const SurfaceMesh& mesh, std::int64_t element, double xi, double eta) {
  Shape shape;
  evaluate_shape(mesh.type[static_cast<std::size_t>(element)], xi, eta, shape);
  const Vec3 origin = position(mesh, mesh.element(element)[0]);
  SurfaceFrame frame = combine(mesh, element, shape, origin);
  frame.x = frame.x + origin;
  return frame;
}

Vec3 normalized(const Vec3& v) {
  const double l = std::hypot(v[0], v[1], v[2]);
  if (!(l > 0)) return {0, 0, 0};
  return {v[0] / l, v[1] / l, v[2] / l};
}

Vec3 unit_normal(const SurfaceMesh& mesh, std::int64_t element, double xi, double eta) {
  return normalized(evaluate_surface(mesh, element, xi, eta).normal);
}

double angle_between(const Vec3& a, const Vec3& b) {
  const Vec3 u = normalized(a), v = normalized(b);
  return std::atan2(length(cross(u, v)), dot(u, v));
}

double angle_at_node(const SurfaceMesh& mesh, std::int64_t element, int local) {
  const ElementType type = mesh.type[static_cast<std::size_t>(element)];
  const int corners = corner_count(type);
  if (local >= 2 * corners) return 2 * std::numbers::pi;
  if (local >= corners) return std::numbers::pi;
  const ReferencePoint at = reference_nodes(type)[static_cast<std::size_t>(local)];
  const SurfaceFrame f = evaluate_surface(mesh, element, at.xi, at.eta);
  const Vec3 back_xi = -1.0 * f.d_xi, back_eta = -1.0 * f.d_eta;
  if (corners == 4) return angle_between(at.xi < 0 ? f.d_xi : back_xi, at.eta < 0 ? f.d_eta : back_eta);
  if (local == 0) return angle_between(f.d_xi, f.d_eta);
  return local == 1 ? angle_between(back_xi, f.d_eta - f.d_xi) : angle_between(back_eta, f.d_xi - f.d_eta);
}

double element_area(const SurfaceMesh& mesh, std::int64_t element) {
  double area = 0;
  integrate_element(mesh, element, [&](const Shape&, const Vec3&, double part) { area += part; });
  return area;
}

double cone_volume(const SurfaceMesh& mesh, std::int64_t element, const Vec3& apex) {
  // The integrand x . (d_xi x d_eta) has degree 5 in each variable for quad9, 4 in all for tri6.
  double volume = 0;
  for (const auto& [weight, shape] : tabulated<5>(mesh.type[static_cast<std::size_t>(element)])) {
    const SurfaceFrame f = combine(mesh, element, shape, apex);
    volume += weight * dot(f.x, f.normal);
  }
  return volume / 3;
}

double enclosed_volume(const SurfaceMesh& mesh) {
  if (mesh.elements() == 0) return 0;
  const Vec3 apex = position(mesh, mesh.element(0)[0]);
  double volume = 0;
  for (std::int64_t e = 0; e < mesh.elements(); ++e) volume += cone_volume(mesh, e, apex);
  return volume;
}

double element_diameter(const SurfaceMesh& mesh, std::int64_t element) {
  const auto nodes = mesh.element(element);
  const auto corners = static_cast<std::size_t>(corner_count(mesh.type[static_cast<std::size_t>(element)]));
  double diameter = 0;
  for (std::size_t i = 0; i < corners; ++i)
    for (std::size_t j = 0; j < i; ++j)
      diameter = std::max(diameter, length(position(mesh, nodes[i]) - position(mesh, nodes[j])));
  return diameter;
}

}  // namespace rollcon
