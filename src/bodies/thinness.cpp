#include "bodies/thinness.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
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

// Returns the greatest depth of the layers of nodes below a face, where these are fewer than `few`; else 0.
double deepest_of_few_layers(const SurfaceMesh& surface, std::int64_t e, const SurfaceFrame& face, double thickness,
                             std::size_t few) {
  constexpr double beside = 0.5, apart = 0.01;  // fractions of the face, and of the deepest layer
  const Vec3 corner = surface.node[static_cast<std::size_t>(surface.element(e)[0])], n = normalized(face.normal);
  const double near = beside * element_diameter(surface, e) / std::numbers::sqrt2;
  std::vector<double> depth{0};
  for (const Vec3& node : surface.node) {
    const Vec3 d = node - corner;
    const double below = -dot(d, n);
    if (below > 0 && below < thickness + near && length(d + below * n) < near) depth.push_back(below);
  }
  std::sort(depth.begin(), depth.end());
  std::adjacent_difference(depth.begin(), depth.end(), depth.begin());
  const double deepest = *std::max_element(depth.begin(), depth.end());
  const auto layers = std::count_if(depth.begin(), depth.end(), [&](double d) { return d > apart * deepest; });
  return static_cast<std::size_t>(layers) < few ? deepest : 0;
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
  constexpr double most = 10, third = 1.0 / 3;
  constexpr std::size_t few_layers = 4, looked_at = 16;  // layers, and faces whose layers are counted
  const SurfaceMesh& surface = mesh.surface;
  const SurfaceSearch all(surface, {});
  const std::vector<std::uint8_t> held = held_elements(mesh);
  MeshOnFrame found;
  double sum = 0, areas = 0, layered = INFINITY;
  std::size_t seen = 0;
  for (const std::int64_t e : element) {
    const auto i = static_cast<std::size_t>(e);
    const auto [area, opposite] = look_through(surface, all, e);
    sum += area * (opposite ? std::min(most, opposite->distance / std::sqrt(area)) : most);
    areas += area;
    found.spacing +=
        std::sqrt(area) / (is_quadratic(surface.type[i]) ? 2.0 : 1.0) / static_cast<double>(element.size());
    if (opposite && held[static_cast<std::size_t>(opposite->element)] != 0)
      found.glued = std::min(found.glued, opposite->distance);
    if (mesh.origin.empty() || !opposite) continue;
    const SurfaceFrame face = evaluate_surface(surface, e, third, third);
    double deepest = 0;
    for (const std::int32_t k : mesh.volume.element(mesh.origin[i].element))
      deepest = std::max(deepest, dot(face.x - surface.node[static_cast<std::size_t>(k)], normalized(face.normal)));
    // In rings whose contact has the first half width pressures are off by 1 to 5 %, and where it has the second
    // creepages are off by 5 to 10 %.
    const bool quadratic = is_quadratic(surface.type[i]);
    found.pressed = std::min(found.pressed, quadratic ? 0.5 * deepest : deepest);
    found.rolled = std::min(found.rolled, quadratic ? 0.4 * deepest : 2 * deepest);
    if (++seen % (1 + element.size() / looked_at) != 0) continue;
    const std::size_t few = quadratic ? 2 * few_layers : few_layers;
    const double layer = deepest_of_few_layers(surface, e, face, opposite->distance, few);
    if (layer > 0) layered = std::min(layered, layer);
  }
  if (std::isfinite(layered))
    for (double* const shown : {&found.pressed, &found.rolled}) *shown = std::max(*shown, layered);
  found.under_faces = areas > 0 ? sum / areas : most;
  return found;
}

}  // namespace rollcon
