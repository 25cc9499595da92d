/// Holds what a scene takes from its bodies: where they stand, how they move, and frames made of their faces.

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/scene/scene.hpp"
#include "mesh/turned_over.hpp"
#include "support/input_checks.hpp"

namespace rollcon {
namespace {

double determinant(const std::array<Vec3, 3>& r) {
  return dot(r[0], cross(r[1], r[2]));
}

/// Returns the rotation next to a matrix that is one but for rounding, by Newton's iteration for the polar
/// decomposition, R <- (R + R^-T) / 2.
std::array<Vec3, 3> nearest_rotation(std::array<Vec3, 3> r) {
  for (int i = 0; i < 3; ++i) {
    const double scale = 1 / determinant(r);
    const std::array<Vec3, 3> cofactor{cross(r[1], r[2]), cross(r[2], r[0]), cross(r[0], r[1])};
    for (std::size_t k = 0; k < 3; ++k) r[k] = 0.5 * (r[k] + scale * cofactor[k]);
  }
  return r;
}

}  // namespace

void Scene::set_pose(std::int32_t which, const double* rotation, const double* translation) {
  if (which != 1 && which != 2) fail(Status::err_argument, "which is %d; allowed: 1, 2", which);
  require_pointer(rotation, "rotation");
  for (int i = 0; i < 9; ++i)
    if (!std::isfinite(rotation[i]))
      fail(Status::err_nonfinite, "entry (%d, %d) of rotation (counting from 0) is %g", i / 3, i % 3, rotation[i]);
  require_finite_vector(translation, "translation");
  Pose pose;
  for (std::size_t i = 0; i < 3; ++i) pose.rotation[i] = {rotation[3 * i], rotation[3 * i + 1], rotation[3 * i + 2]};
  pose.translation = {translation[0], translation[1], translation[2]};
  constexpr double tolerance = 1e-6;
  double off = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j <= i; ++j)
      off = std::max(off, std::abs(dot(pose.rotation[i], pose.rotation[j]) - (i == j ? 1 : 0)));
  if (!(off <= tolerance))
    fail(Status::err_argument, "rotation is not orthonormal: its rows' products are off by %.3g; allowed: %g", off,
         tolerance);
  const double sign = determinant(pose.rotation);
  if (!(std::abs(sign - 1) <= tolerance))
    fail(Status::err_argument, "rotation has determinant %.7g; allowed: 1 (no reflection)", sign);
  pose.rotation = nearest_rotation(pose.rotation);

  const int body = which - 1;
  Pose& held = pose_[static_cast<std::size_t>(body)];
  if (held == pose) return;
  held = pose;
  ++revision.pose[static_cast<std::size_t>(body)];
  if (frame_source_.body != body) return;
  for (std::size_t k = 0; k < mesh_.node.size(); ++k) mesh_.node[k] = pose.place(frame_source_.place[k]);
}

void Scene::set_velocity(std::int32_t which, const double* velocity, const double* angular_velocity,
                         const double* point) {
  if (which < 0 || which > 2) fail(Status::err_argument, "which is %d; allowed: 0 (the contact), 1, 2", which);
  require_finite_vector(velocity, "velocity");
  require_finite_vector(angular_velocity, "angular_velocity");
  require_finite_vector(point, "point");
  const auto vector = [](const double* v) { return Vec3{v[0], v[1], v[2]}; };
  const Velocity now{vector(velocity), vector(angular_velocity), vector(point)};
  Velocity& held = rolling_.velocity[static_cast<std::size_t>(which)];
  bool changed = !(held == now) || !rolling_.velocities_given;
  held = now;
  rolling_.velocities_given = true;
  if (which == 0) changed |= !std::exchange(rolling_.travel_given, true);
  if (changed) ++revision.kinematics;
  changed = false;
  for (const Direction d : {Direction::longitudinal, Direction::lateral, Direction::spin}) {
    Load& load = load_[motion_of(d)];
    changed |= load.how != How::by_velocity;
    load = {How::by_velocity, 0};
  }
  if (changed) ++revision.load;
}

Velocity Scene::relative_velocity() const {
  const Vec3 linear = rolling_.velocity[1].at(axes_.origin) - rolling_.velocity[2].at(axes_.origin);
  const Vec3 angular = rolling_.velocity[1].angular - rolling_.velocity[2].angular;
  const auto in_axes = [this](const Vec3& v) { return Vec3{dot(v, axes_.t1), dot(v, axes_.t2), dot(v, axes_.n)}; };
  return {in_axes(linear), in_axes(angular), {0, 0, 0}};
}

double Scene::speed(const Vec3& point) const {
  if (!rolling_.travel_given) return rolling_.speed;
  const Vec3 x = axes_.origin + point[0] * axes_.t1 + point[1] * axes_.t2 + point[2] * axes_.n;
  const double speed =
      dot(rolling_.velocity[0].at(x) - 0.5 * (rolling_.velocity[1].at(x) + rolling_.velocity[2].at(x)), axes_.t1);
  if (!(speed > 0) || !std::isfinite(speed))
    fail(
        Status::err_argument,
        "the velocity of the contact along the rolling direction, less the mean of both bodies', is %g "
        "(rollcon_contact_set_velocity); allowed: > 0; the rolling direction is that in which the contact travels over "
        "the bodies",
        speed);
  return speed;
}

void Scene::set_frame_from(int which, const SurfaceMesh& body, std::int32_t tag) {
  FrameSource source;
  source.body = which;
  source.tag = tag;
  SurfaceMesh mesh;
  mesh.index_base = body.index_base;
  mesh.offset.push_back(0);
  std::vector<std::int32_t> number(static_cast<std::size_t>(body.nodes()), -1);
  for (std::int64_t e = 0; e < body.elements(); ++e) {
    if (body.tag[static_cast<std::size_t>(e)] != tag) continue;
    source.element.push_back(e);
    for (const std::int32_t k : body.element(e)) number[static_cast<std::size_t>(k)] = 0;
  }
  if (source.element.empty()) fail(Status::err_argument, "tag is %d, which no face of body %d has", tag, which + 1);
  for (std::size_t k = 0; k < number.size(); ++k) {
    if (number[k] < 0) continue;
    number[k] = static_cast<std::int32_t>(source.node.size());
    source.node.push_back(static_cast<std::int32_t>(k));
    source.place.push_back(body.node[k]);
    mesh.node.push_back(pose_[static_cast<std::size_t>(which)].place(body.node[k]));
  }
  for (const std::int64_t e : source.element) {
    const ElementType type = body.type[static_cast<std::size_t>(e)];
    const auto nodes = body.element(e);
    mesh.type.push_back(type);
    mesh.tag.push_back(tag);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const int k = static_cast<int>(i), from = which == 0 ? k : turned_over(type, k);
      mesh.connectivity.push_back(number[static_cast<std::size_t>(nodes[static_cast<std::size_t>(from)])]);
    }
    mesh.offset.push_back(static_cast<std::int64_t>(mesh.connectivity.size()));
  }
  replace_frame(std::move(mesh), std::move(source));
}

}  // namespace rollcon
