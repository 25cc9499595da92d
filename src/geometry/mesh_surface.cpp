#include "geometry/mesh_surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "mesh/shape.hpp"
#include "mesh/surface_geometry.hpp"
#include "support/index.hpp"

namespace rollcon {

Vec3 MeshSurface::smooth_normal(const SurfacePoint& point) const {
  const std::size_t e = at(point.element), first = at(mesh_.offset[e]);
  Shape shape;
  evaluate_shape(mesh_.type[e], point.xi, point.eta, shape);
  Vec3 n{0, 0, 0};
  for (std::size_t a = 0; a < mesh_.element(point.element).size(); ++a)
    n = n + shape.value[a] * fans_.normal[at(fans_.of[first + a])];
  return (1 / length(n)) * n;
}

/// Returns how far the smooth surface lies beyond the facet in that direction.
double MeshSurface::height_over_facet(const SurfacePoint& p, const Vec3& along) const {
  constexpr double steepest = 0.1;
  const std::size_t e = at(p.element), first = at(mesh_.offset[e]);
  if (is_quadratic(mesh_.type[e])) return 0;
  const auto nodes = mesh_.element(p.element);
  Shape shape;
  evaluate_shape(mesh_.type[e], p.xi, p.eta, shape);
  double sum = 0;
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    const Vec3& n = fans_.normal[at(fans_.of[first + a])];
    const double cosine = dot(along, n);
    if (std::abs(cosine) < steepest) return 0;
    sum += 0.5 * shape.value[a] * dot(mesh_.node[at(nodes[a])] - p.x, n) / cosine;
  }
  return sum;
}

std::array<double, 2> MeshSurface::extent(const Vec3& direction) const {
  std::array<double, 2> range{INFINITY, -INFINITY};
  for (const Vec3& x : mesh_.node) {
    const double along = dot(x, direction);
    range = {std::min(range[0], along), std::max(range[1], along)};
  }
  return range;
}

std::optional<double> MeshSurface::distance(const Vec3& from, const Vec3& direction, const Vec3& facing) const {
  const auto hit = search_.along(from, direction, facing);
  if (!hit) return std::nullopt;
  return hit->distance + height_over_facet(*hit, direction);
}

std::optional<Vec3> MeshSurface::normal(const Vec3& from, const Vec3& direction, const Vec3& facing) const {
  const auto hit = search_.along(from, direction, facing);
  if (!hit) return std::nullopt;
  const Vec3 n = smooth_normal(*hit);
  const std::vector<std::int64_t>& start = fans_.start;
  const auto nodes = mesh_.element(hit->element);
  const bool at_edge =
      std::any_of(nodes.begin(), nodes.end(), [&](std::int32_t k) { return start[at(k) + 1] - start[at(k)] > 1; });
  if (!at_edge) return n;
  // The faces around are probed a little off the line; a face at the same edge is no further along it.
  constexpr double aside = 1e-6, same = 1e-4;  // fraction of the element's size; 1 - cosine
  const double off = aside * element_diameter(mesh_, hit->element);
  const Vec3 u = normalized(cross(direction, std::abs(direction[0]) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
  const Vec3 v = cross(direction, u);
  std::vector<Vec3> met{n};
  Vec3 sum = n;
  for (int i = 0; i < 8; ++i) {
    const double angle = (i + 0.5) * std::numbers::pi / 4;
    const auto near = search_.along(from + off * (std::cos(angle) * u + std::sin(angle) * v), direction, facing);
    if (!near || std::abs(near->distance - hit->distance) > 10 * off) continue;
    const Vec3 m = smooth_normal(*near);
    if (std::any_of(met.begin(), met.end(), [&](const Vec3& k) { return dot(k, m) > 1 - same; })) continue;
    met.push_back(m);
    sum = sum + m;
  }
  return normalized(sum);
}

}  // namespace rollcon
