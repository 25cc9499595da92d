#include "support/independent_surface.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/quadrature.hpp"
#include "mesh/shape.hpp"

namespace rollcon::laws {
namespace {

Vec3 unit(const Vec3& v) {
  return (1 / length(v)) * v;
}

const Vec3& position(const SurfaceMesh& mesh, std::int32_t k) {
  return mesh.node[static_cast<std::size_t>(k)];
}

/// Holds derivatives of the position in an element.
struct Tangents {
  Vec3 xi{0, 0, 0}, eta{0, 0, 0};
};

Tangents tangents(const SurfaceMesh& mesh, std::int64_t e, const Shape& shape) {
  Tangents t;
  const auto n = mesh.element(e);
  for (std::size_t a = 0; a < n.size(); ++a) {
    t.xi = t.xi + shape.d_xi[a] * position(mesh, n[a]);
    t.eta = t.eta + shape.d_eta[a] * position(mesh, n[a]);
  }
  return t;
}

/// Returns the parameters of an element's nodes: corners, midsides, centre.
std::vector<std::array<double, 2>> places(ElementType type) {
  if (corner_count(type) == 3) return {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}};
  return {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, 0}};
}

/// Returns the angle that the element fills at its node i: between the edges at a corner, half a turn along an edge.
double angle_at(const SurfaceMesh& mesh, std::int64_t e, std::size_t i, const Tangents& t) {
  const std::size_t corners = static_cast<std::size_t>(corner_count(mesh.type[static_cast<std::size_t>(e)]));
  if (i >= corners) return i < 2 * corners ? std::acos(-1.0) : 2 * std::acos(-1.0);
  Vec3 a = t.xi, b = t.eta;  // corners 1 and 2 of a triangle look back along an edge
  if (corners == 3 && i == 1) a = -1.0 * t.xi, b = t.eta - t.xi;
  if (corners == 3 && i == 2) a = -1.0 * t.eta, b = t.xi - t.eta;
  if (corners == 4 && (i == 1 || i == 3)) a = -1.0 * a;
  return std::acos(std::clamp(dot(unit(a), unit(b)), -1.0, 1.0));
}

}  // namespace

Axes3 axes_of(const Vec3& rolling, const Vec3& normal) {
  const Vec3 n = unit(normal), t1 = unit(rolling - dot(rolling, n) * n);
  return {t1, cross(n, t1), n};
}

std::vector<Axes3> surface_triads(const SurfaceMesh& mesh, const Axes3& axes) {
  std::vector<Vec3> sum(mesh.node.size(), Vec3{0, 0, 0});
  Shape shape;
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const ElementType type = mesh.type[static_cast<std::size_t>(e)];
    const auto at = places(type);
    const auto n = mesh.element(e);
    for (std::size_t i = 0; i < n.size(); ++i) {
      evaluate_shape(type, at[i][0], at[i][1], shape);
      const Tangents t = tangents(mesh, e, shape);
      Vec3& of = sum[static_cast<std::size_t>(n[i])];
      of = of + angle_at(mesh, e, i, t) * unit(cross(t.xi, t.eta));
    }
  }
  std::vector<Axes3> triad;
  for (const Vec3& normal : sum) {
    // The normal is taken in the axes, level along the rolling direction.
    const double across = std::hypot(dot(normal, axes[0]), dot(normal, axes[2]));
    const Vec3 n = unit(Vec3{0, dot(normal, axes[1]), across});
    triad.push_back({Vec3{1, 0, 0}, cross(n, Vec3{1, 0, 0}), n});
  }
  return triad;
}

std::vector<std::array<double, 3>> surface_integrals(const SurfaceMesh& mesh, const Vec3& origin, const Axes3& axes) {
  constexpr int degree = 15;
  static const PlaneRule triangle = triangle_rule(degree), square = square_rule(degree);
  std::vector<std::array<double, 3>> sum(mesh.node.size());
  Shape shape;
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const ElementType type = mesh.type[static_cast<std::size_t>(e)];
    const auto n = mesh.element(e);
    const PlaneRule& rule = corner_count(type) == 3 ? triangle : square;
    for (std::size_t q = 0; q < rule.size(); ++q) {
      evaluate_shape(type, rule.xi[q], rule.eta[q], shape);
      const Tangents t = tangents(mesh, e, shape);
      Vec3 x = -1.0 * origin;
      for (std::size_t a = 0; a < n.size(); ++a) x = x + shape.value[a] * position(mesh, n[a]);
      const double w = rule.w[q] * length(cross(t.xi, t.eta));
      for (std::size_t a = 0; a < n.size(); ++a) {
        std::array<double, 3>& of = sum[static_cast<std::size_t>(n[a])];
        of[0] += w * shape.value[a];
        of[1] += w * shape.value[a] * dot(x, axes[0]);
        of[2] += w * shape.value[a] * dot(x, axes[1]);
      }
    }
  }
  return sum;
}

}  // namespace rollcon::laws
