#pragma once
/// Makes rigid surfaces for tests of geometry: caps of spheres that face each other.

#include <cmath>
#include <memory>
#include <vector>

#include "bodies/body.hpp"
#include "support/frames.hpp"
#include "support/surface_meshes.hpp"

namespace rollcon::contact_test {

/// Makes a square of n x n elements, half-width w, on the sphere of this radius that touches z = height at the z axis
/// from below (outward normals up) or from above (down).
inline SurfaceMesh sphere_cap(ElementType type, int n, double w, double radius, double height, bool below) {
  const std::vector<double> lines = frames::uniform_lines(-w, w, n);
  const double sign = below ? -1 : 1;
  SurfaceMesh mesh = frames::transform(frames::rectangle(type, lines, lines), [&](const Vec3& p) {
    const double r2 = p[0] * p[0] + p[1] * p[1];
    // The height R - sqrt(R^2 - r^2) is computed without cancellation.
    return Vec3{p[0], p[1], height + sign * r2 / (radius + std::sqrt(radius * radius - r2))};
  });
  return below ? mesh : surfaces::turn_inside_out(mesh);
}

inline void set_mesh(Body& body, const SurfaceMesh& mesh, std::int32_t index_base = 0) {
  body.set_nodes(mesh.nodes(), mesh.node[0].data(), 3, 1);
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    std::vector<std::int32_t> nodes(mesh.element(e).begin(), mesh.element(e).end());
    for (auto& k : nodes) k += index_base;
    body.add_elements(static_cast<std::int32_t>(mesh.type[static_cast<std::size_t>(e)]), 1, nodes.data(), index_base,
                      mesh.tag[static_cast<std::size_t>(e)]);
  }
}

inline std::shared_ptr<Body> rigid_body(const std::shared_ptr<Context>& context, const SurfaceMesh& mesh) {
  auto body = std::make_shared<Body>(context, 4);
  set_mesh(*body, mesh);
  return body;
}

/// Returns what local axes make of a normal where the surface is level at the origin: its inclination along x is taken
/// out, that across stays.
inline Vec3 leveled(const Vec3& n) {
  return {0, n[1], std::hypot(n[0], n[2])};
}

/// Returns the least |t| for which from + t * direction (unit) lies on the sphere.
inline double to_sphere(const Vec3& from, const Vec3& direction, const Vec3& centre, double radius) {
  const Vec3 q = from - centre;
  const double b = dot(q, direction), c = dot(q, q) - radius * radius;
  const double root = std::sqrt(b * b - c);
  return b < 0 ? c / (-b + root) : -c / (b + root);
}

}  // namespace rollcon::contact_test
