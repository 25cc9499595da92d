#include "bodies/contact_surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "mesh/shape.hpp"
#include "mesh/surface_geometry.hpp"

namespace rollcon {

Vec3 smooth_normal(const Body& body, const SurfacePoint& point) {
  const SurfaceMesh& mesh = body.mesh().surface;
  const auto e = static_cast<std::size_t>(point.element);
  const auto first = static_cast<std::size_t>(mesh.offset[e]);
  Shape shape;
  evaluate_shape(mesh.type[e], point.xi, point.eta, shape);
  Vec3 n{0, 0, 0};
  for (std::size_t a = 0; a < mesh.element(point.element).size(); ++a) {
    const auto fan = static_cast<std::size_t>(body.smooth_fans().of[first + a]);
    n = n + shape.value[a] * body.smooth_fans().normal[fan];
  }
  return (1 / length(n)) * n;
}

std::optional<Vec3> normal_along(const Body& body, const Vec3& from, const Vec3& direction, const Vec3& facing) {
  const auto hit = body.search().along(from, direction, facing);
  if (!hit) return std::nullopt;
  const Vec3 n = smooth_normal(body, *hit);
  const SurfaceMesh& mesh = body.mesh().surface;
  const std::vector<std::int64_t>& start = body.smooth_fans().start;
  const auto nodes = mesh.element(hit->element);
  const bool at_edge = std::any_of(nodes.begin(), nodes.end(), [&](std::int32_t k) {
    return start[static_cast<std::size_t>(k) + 1] - start[static_cast<std::size_t>(k)] > 1;
  });
  if (!at_edge) return n;
  // The faces around, a little off the line; those at the same edge are no further along it.
  constexpr double aside = 1e-6, same = 1e-4;  // part of the element's size; 1 - cosine
  const double off = aside * element_diameter(mesh, hit->element);
  const Vec3 u = normalized(cross(direction, std::abs(direction[0]) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
  const Vec3 v = cross(direction, u);
  std::vector<Vec3> met{n};
  Vec3 sum = n;
  for (int i = 0; i < 8; ++i) {
    const double angle = (i + 0.5) * std::numbers::pi / 4;
    const auto near = body.search().along(from + off * (std::cos(angle) * u + std::sin(angle) * v), direction, facing);
    if (!near || std::abs(near->distance - hit->distance) > 10 * off) continue;
    const Vec3 m = smooth_normal(body, *near);
    if (std::any_of(met.begin(), met.end(), [&](const Vec3& k) { return dot(k, m) > 1 - same; })) continue;
    met.push_back(m);
    sum = sum + m;
  }
  return normalized(sum);
}

Vec3 plane_point(const Axes& axes, double x, double y) {
  return axes.origin + x * axes.t1 + y * axes.t2;
}

NormalField::NormalField(const Axes& axes, const PairOfBodies& pair) : axes_(axes) {
  const std::size_t which = pair.body[0]->meshed() ? 0 : 1;
  body_ = pair.body[which];
  pose_ = pair.pose[which];
  sign_ = which == 0 ? 1 : -1;
  const Vec3 n = surface_normal(0, 0);
  const double n1 = dot(n, axes.t1), n3 = dot(n, axes.n), across = std::hypot(n1, n3);
  if (!(n3 > 0)) return;  // the origin is off the surface; the frame's own check says more
  sine_ = n1 / across;
  cosine_ = n3 / across;
}

Vec3 NormalField::surface_normal(double x, double y) const {
  const Vec3 from = pose_.to_body(plane_point(axes_, x, y));
  const Vec3 direction = pose_.turn_back(axes_.n);
  auto n = normal_along(*body_, from, direction, sign_ * direction);
  // Beyond the surface's edge: as at the edge, where a wall of the body is as near as the face.
  if (!n) n = normal_along(*body_, body_->search().nearest(from).x, direction, sign_ * direction);
  return n ? sign_ * pose_.turn(*n) : axes_.n;
}

Vec3 NormalField::level(const Vec3& normal) const {
  const double n1 = dot(normal, axes_.t1), n2 = dot(normal, axes_.t2), n3 = dot(normal, axes_.n);
  if (!(n3 > 0)) return normal;
  const double across = std::hypot(n1, n3);
  return across * sine_ * axes_.t1 + n2 * axes_.t2 + across * cosine_ * axes_.n;
}

Vec3 NormalField::at(double x, double y) const {
  return level(surface_normal(x, y));
}

}  // namespace rollcon
