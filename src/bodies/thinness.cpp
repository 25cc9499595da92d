#include "bodies/thinness.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "geometry/surface_search.hpp"
#include "mesh/shape.hpp"
#include "mesh/surface_geometry.hpp"

namespace rollcon {
namespace {

/// Holds an element's area, as if the Jacobian were constant, and where a line inwards from its middle leaves the body.
struct Through {
  double area = 0;
  std::optional<SurfacePoint> opposite;
};

Through look_through(const SurfaceMesh& surface, const SurfaceSearch& all, std::int64_t e) {
  const bool triangle = corner_count(surface.type[static_cast<std::size_t>(e)]) == 3;
  const double at = triangle ? 1.0 / 3 : 0;
  const SurfaceFrame middle = evaluate_surface(surface, e, at, at);
  const Vec3 inward = -1.0 * normalized(middle.normal);
  Through result{(triangle ? 0.5 : 4) * length(middle.normal), all.along(middle.x, inward, inward)};
  // The body is behind two walls that face each other across a gap.
  if (result.opposite && result.opposite->distance <= 0) result.opposite.reset();
  return result;
}

}  // namespace

Thinness thinness(BodyMesh& mesh, double linear, double quadratic) {
  const SurfaceMesh& surface = mesh.surface;
  const SurfaceSearch all(surface, {});
  const std::vector<std::uint8_t> held = held_elements(mesh);
  double free = 0, thin = 0, ratios = 0;
  mesh.thickness.assign(held.size(), 0.0);
  for (std::int64_t e = 0; e < surface.elements(); ++e) {
    const auto i = static_cast<std::size_t>(e);
    if (held[i] != 0) continue;
    const auto [area, opposite] = look_through(surface, all, e);
    free += area;
    if (!opposite || held[static_cast<std::size_t>(opposite->element)] != 0) continue;
    mesh.thickness[i] = opposite->distance;
    const double ratio = element_diameter(surface, e) / std::numbers::sqrt2 / opposite->distance;
    if (ratio <= (is_quadratic(surface.type[i]) ? quadratic : linear)) continue;
    thin += area;
    ratios += area * ratio;
  }
  if (thin == 0) return {};
  return {thin / free, ratios / thin};
}

MeshOnFrame look_under(const BodyMesh& mesh, std::span<const std::int64_t> element) {
  constexpr double most = 10, third = 1.0 / 3, few_layers = 4;
  const SurfaceMesh& surface = mesh.surface;
  const SurfaceSearch all(surface, {});
  const std::vector<std::uint8_t> held = held_elements(mesh);
  MeshOnFrame found;
  double sum = 0, areas = 0;
  for (const std::int64_t e : element) {
    const auto i = static_cast<std::size_t>(e);
    const auto [area, opposite] = look_through(surface, all, e);
    sum += area * (opposite ? std::min(most, opposite->distance / std::sqrt(area)) : most);
    areas += area;
    if (opposite && held[static_cast<std::size_t>(opposite->element)] != 0)
      found.glued = std::min(found.glued, opposite->distance);
    if (mesh.origin.empty() || !opposite) continue;
    const SurfaceFrame face = evaluate_surface(surface, e, third, third);
    double deepest = 0;
    for (const std::int32_t k : mesh.volume.element(mesh.origin[i].element))
      deepest = std::max(deepest, dot(face.x - surface.node[static_cast<std::size_t>(k)], normalized(face.normal)));
    const double depth = is_quadratic(surface.type[i]) ? 0.5 * deepest : deepest;
    if (opposite->distance < few_layers * depth) found.element = std::min(found.element, depth);
  }
  found.under_faces = areas > 0 ? sum / areas : most;
  return found;
}

}  // namespace rollcon
