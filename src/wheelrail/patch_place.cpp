/// Lays the axes and frames of a patch and puts the bodies in place, with their velocities.

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/solver.hpp"
#include "framing/makers.hpp"
#include "wheelrail/patch_contact.hpp"

namespace rollcon {
namespace {

Vec3 in_axes(const Axes& axes, const Vec3& v) {
  return {dot(v, axes.t1), dot(v, axes.t2), dot(v, axes.n)};
}

void set_pose(Scene& scene, std::int32_t which, const Axes& axes, const Pose& pose) {
  std::array<double, 9> rotation{};
  for (std::size_t j = 0; j < 3; ++j) {
    Vec3 unit{0, 0, 0};
    unit[j] = 1;
    const Vec3 column = in_axes(axes, pose.turn(unit));
    for (std::size_t i = 0; i < 3; ++i) rotation[3 * i + j] = column[i];
  }
  const Vec3 translation = in_axes(axes, pose.translation - axes.origin);
  scene.set_pose(which, rotation.data(), translation.data());
}

void set_velocity(Scene& scene, std::int32_t which, const Axes& axes, const Velocity& velocity) {
  const Vec3 linear = in_axes(axes, velocity.linear), angular = in_axes(axes, velocity.angular),
             point = in_axes(axes, velocity.point - axes.origin);
  scene.set_velocity(which, linear.data(), angular.data(), point.data());
}

}  // namespace

// Lays the axes, which are the contact's space: they never change there, and what belongs to the frame stays.
void PatchContact::lay_axes() {
  now_.axes = axes_of(now_.patch);
  if (now_.step.kind != StepKind::steady) now_.axes.origin = origin_from(*now_.step.past, now_.axes, box());
}

Axes PatchContact::axes_of(const OverlapPatch& patch) const {
  Axes axes;
  axes.n = -1.0 * patch.normal;
  axes.t1 = (now_.motion.onward < 0 ? -1.0 : 1.0) * patch.along;
  axes.t2 = cross(axes.n, axes.t1);
  axes.origin = middle();
  return axes;
}

// Returns the middle of the overlap's box.
Vec3 PatchContact::middle() const {
  const OverlapPatch& p = now_.patch;
  return p.reference + 0.5 * (p.back + p.front) * p.along + 0.5 * (p.low + p.high) * p.lateral;
}

void PatchContact::stand(const WheelMotion& motion) {
  now_.motion = motion;
  lay_axes();
  contact_->scene.set_step(static_cast<std::int32_t>(now_.step.kind), now_.step.dt);
  place_bodies(contact_->scene, {});
}

void PatchContact::place_bodies(Scene& scene, const std::array<Pose, 2>& place) const {
  const WheelMotion& motion = now_.motion;
  set_pose(scene, 1, now_.axes, composed(motion.pose, place[0]));
  set_pose(scene, 2, now_.axes, composed({.translation = {-motion.along, 0, 0}}, place[1]));
  set_velocity(scene, 0, now_.axes, {{motion.speed, 0, 0}, {0, 0, 0}, {0, 0, 0}});
  set_velocity(scene, 1, now_.axes, motion.by_creepages ? flat_velocity() : motion.velocity);
  set_velocity(scene, 2, now_.axes, motion.rail);
}

// Returns the wheel's velocity with the rail's turning but for that about the normal: relative to the rail it is that
// of the creepages at the reference, everywhere.
Velocity PatchContact::flat_velocity() const {
  const Velocity &wheel = now_.motion.velocity, &rail = now_.motion.rail;
  const Vec3 &reference = now_.patch.reference, &n = now_.axes.n;
  const Vec3 surface = wheel.at(reference + now_.patch.overlap * n);
  return {surface, rail.angular + dot(wheel.angular - rail.angular, n) * n, reference};
}

void PatchContact::put_frame(Scene& scene, const LatticeSize& size, const FramePlace& place, bool given) {
  scene.options.set_int("conformal", size.conformal ? 1 : 0);
  scene.set_made_frame(rectangle_mesh({}, ElementType::quad4, size.along, size.across,
                                      {-place.length, place.length, -place.width, place.width}),
                       true, given);
}

// Returns the box of the overlap in the axes, whose origin is its middle but in steps in time.
Rectangle PatchContact::box() const {
  const double along = 0.5 * (now_.patch.front - now_.patch.back), across = 0.5 * (now_.patch.high - now_.patch.low);
  const Vec3 off = middle() - now_.axes.origin;
  const double x = dot(off, now_.axes.t1), y = dot(off, now_.axes.t2);
  return {x - along, x + along, y - across, y + across};
}

// Lays a lattice over the whole box of the overlap, or one as much smaller as what the surfaces give way makes the
// contact.
FramePlace PatchContact::place(bool whole) const {
  const Rectangle all = box();
  const double left = whole ? 1 : std::sqrt(std::max(1 - now_.give_way / now_.patch.overlap, 0.01));
  // Rounding must not decide whether the last nodes are beyond the end of a profile.
  constexpr double inside = 1 - 1e-6;
  return {left * all.x_greatest, (now_.patch.cut ? inside : 1) * left * all.y_greatest, 0};
}

}  // namespace rollcon
