#include "bodies/contact_surface.hpp"

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

NormalField::NormalField(const Axes& axes, const Body& body, const Pose& pose, int which)
    : axes_(axes), body_(body), pose_(pose), sign_(which == 0 ? 1 : -1) {}

Vec3 NormalField::at(double x, double y) const {
  const Vec3 from = pose_.to_body(plane_point(axes_, x, y));
  const Vec3 direction = pose_.turn_back(axes_.n);
  const auto hit = body_.search().along(from, direction, sign_ * direction);
  const SurfacePoint point = hit ? *hit : body_.search().nearest(from);
  return sign_ * pose_.turn(smooth_normal(body_, point));
}

}  // namespace rollcon
