#include "bodies/contact_surface.hpp"

#include <cmath>

#include "mesh/shape.hpp"

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
  auto hit = body_->search().along(from, direction, sign_ * direction);
  // Beyond the surface's edge: as at the edge, where a wall of the body is as near as the face.
  if (!hit)
    hit = body_->search().along(body_->search().nearest(from).x, direction, sign_ * direction);
  return hit ? sign_ * pose_.turn(smooth_normal(*body_, *hit)) : axes_.n;
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
