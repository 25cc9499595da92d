#include "bodies/contact_surface.hpp"

#include <algorithm>
#include <cmath>

namespace rollcon {

bool PairOfBodies::meshed() const {
  return body[0]->meshed() || body[1]->meshed();
}

bool PairOfBodies::creeps() const {
  return std::any_of(body.begin(), body.end(), [](const Body* b) { return b->creeps(); });
}

bool PairOfBodies::half_spaces() const {
  return std::all_of(body.begin(), body.end(), [](const Body* b) { return b->rigid() || b->traits().half_space; });
}

Vec3 plane_point(const Axes& axes, double x, double y) {
  return axes.origin + x * axes.t1 + y * axes.t2;
}

NormalField::NormalField(const Axes& axes, const PairOfBodies& pair) : axes_(axes) {
  const std::size_t which = pair.body[0]->meshed() ? 0 : 1;
  surface_ = pair.body[which]->surface();
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
  auto n = surface_->normal(from, direction, sign_ * direction);
  // The normal beyond the surface's edge is that of the edge, where a wall of the body is as near as the face.
  if (!n) n = surface_->normal(surface_->nearest(from), direction, sign_ * direction);
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
