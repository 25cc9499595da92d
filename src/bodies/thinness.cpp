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

/// The middle of an element, its area as if the Jacobian were constant, and where a line inwards from there leaves the
/// body.
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
  // Of two walls that face each other across a gap, the body is behind.
  if (result.opposite && result.opposite->distance <= 0) result.opposite.reset();
  return result;
}

}  // namespace

Thinness thinness(const BodyMesh& mesh, double linear, double quadratic) {
  const SurfaceMesh& surface = mesh.surface;
  const SurfaceSearch all(surface, {});
  const std::vector<std::uint8_t> held = held_elements(mesh);
  double free = 0, thin = 0, ratios = 0;
  for (std::int64_t e = 0; e < surface.elements(); ++e) {
    const auto i = static_cast<std::size_t>(e);
    if (held[i] != 0) continue;
    const auto [area, opposite] = look_through(surface, all, e);
    free += area;
    if (!opposite || held[static_cast<std::size_t>(opposite->element)] != 0) continue;
    const double ratio = element_diameter(surface, e) / std::numbers::sqrt2 / opposite->distance;
    if (ratio <= (is_quadratic(surface.type[i]) ? quadratic : linear)) continue;
    thin += area;
    ratios += area * ratio;
  }
  if (thin == 0) return {};
  return {thin / free, ratios / thin};
}

double mean_depth(const SurfaceMesh& surface, std::span<const std::int64_t> element) {
  constexpr double most = 10;
  const SurfaceSearch all(surface, {});
  double sum = 0, areas = 0;
  for (const std::int64_t e : element) {
    const auto [area, opposite] = look_through(surface, all, e);
    const double depth = opposite ? std::min(most, opposite->distance / std::sqrt(area)) : most;
    sum += area * depth;
    areas += area;
  }
  return areas > 0 ? sum / areas : most;
}

}  // namespace rollcon
