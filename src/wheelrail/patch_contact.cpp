#include "wheelrail/patch_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "framing/hertz.hpp"
#include "framing/makers.hpp"

namespace rollcon {
namespace {

/// Each time that the frame was too small.
constexpr double growth = 1.25;
constexpr int most_growths = 6;

Vec3 in_axes(const Axes& axes, const Vec3& v) {
  return {dot(v, axes.t1), dot(v, axes.t2), dot(v, axes.n)};
}

Vec3 from_axes(const Axes& axes, const Vec3& v) {
  return v[0] * axes.t1 + v[1] * axes.t2 + v[2] * axes.n;
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

PatchContact::PatchContact(std::shared_ptr<Context> context, std::shared_ptr<Body> wheel, std::shared_ptr<Body> rail)
    : contact_(std::make_shared<Contact>(std::move(context), std::move(wheel), std::move(rail))) {}

Status PatchContact::solve(const OverlapPatch& patch, const WheelMotion& motion, double friction,
                           const LatticeSize& size, double give_way) {
  patch_ = patch;
  give_way_ = give_way;
  stand(motion);
  contact_->scene.prescribe(static_cast<std::int32_t>(Direction::normal), static_cast<std::int32_t>(How::by_motion),
                            -give_way);
  contact_->scene.set_friction("coulomb", 1, &friction);
  for (int growths = 0;; ++growths) {
    lay_frame(size);
    status_ = contact_->solve_on_frame();
    if (status_ != Status::ok && status_ != Status::coarse) break;
    // Nothing touches beyond the overlap of the undeformed bodies.
    const int rim = rim_reached(size);
    if (rim == 0 || whole_[static_cast<std::size_t>(rim - 1)]) break;
    if (growths == most_growths) {
      status_ = Status::rim_contact;
      break;
    }
    margin_[static_cast<std::size_t>(rim - 1)] *= growth;
    ++grown_;
  }
  take_results(motion);
  return status_;
}

void PatchContact::reset() {
  margin_ = {usual_margin, usual_margin};
  contact_->reset();
}

// Space of the contact is that of its axes: they never change, and what belongs to the frame stays.
void PatchContact::stand(const WheelMotion& motion) {
  axes_.n = -1.0 * patch_.normal;
  axes_.t1 = {motion.speed > 0 ? 1.0 : -1.0, 0, 0};
  axes_.t2 = cross(axes_.n, axes_.t1);
  const double x = 0.5 * (patch_.back + patch_.front), y = 0.5 * (patch_.low + patch_.high);
  axes_.origin = patch_.reference + Vec3{x, 0, 0} + y * patch_.lateral;
  Scene& scene = contact_->scene;
  set_pose(scene, 1, axes_, motion.pose);
  set_pose(scene, 2, axes_, Pose{});
  set_velocity(scene, 0, axes_, {{motion.speed, 0, 0}, {0, 0, 0}, {0, 0, 0}});
  set_velocity(scene, 1, axes_, motion.velocity);
  set_velocity(scene, 2, axes_, motion.rail);
}

void PatchContact::lay_frame(const LatticeSize& size) {
  Scene& scene = contact_->scene;
  if (!(size == size_)) {
    scene.set_placed_frame(rectangle_mesh({}, ElementType::quad4, size.along, size.across, {-1, 1, -1, 1}), place());
    size_ = size;
  } else if (const FramePlace now = place(); !(now == scene.place())) {
    scene.place_frame(now);
  }
}

// Hertz's ellipse of the paraboloid with the overlap's depth, width and the curvatures along the rail. What is in
// contact lies within the overlap.
FramePlace PatchContact::place() {
  const double half = 0.5 * (patch_.high - patch_.low), depth = patch_.overlap;
  const double a = 0.5 * patch_.curvature.along, c = patch_.curvature.twist;
  const HertzContact hertz = hertz_by_approach({a, depth / (half * half) + c * c / (4 * a), c}, 1, depth);
  const FramePlace ellipse = place_of_disc(hertz.larger, hertz.smaller, hertz.angle);
  const double left = std::sqrt(std::max(1 - give_way_ / depth, 0.01));
  const std::array<double, 2> wanted{left * margin_[0] * ellipse.length, left * margin_[1] * ellipse.width},
      most{std::sqrt(depth / a), half};
  for (std::size_t i = 0; i < 2; ++i) whole_[i] = wanted[i] >= most[i];
  const double length = std::min(wanted[0], most[0]), width = std::min(wanted[1], most[1]);
  // Operators belong to a shape: it changes in steps, and late. The frame is the least of its shape that holds all.
  constexpr double step = 0.1, late = 0.65;
  const bool hold = hold_ && size_.along > 0;
  const auto follow = [hold](double value, std::int64_t& at) {
    if (!hold && std::abs(value - static_cast<double>(at)) > late) at = std::llround(value);
    return static_cast<double>(at);
  };
  const double longer = length / width, ratio = std::exp(step * follow(std::log(longer) / step, shape_[0])),
               shear = step * follow(ellipse.shear / ellipse.length / step, shape_[1]);
  const double w = std::max(width, length / ratio);
  return {ratio * w, w, shear * ratio * w};
}

// 0: within, 1: across the ends along the rolling direction, 2: at the sides.
int PatchContact::rim_reached(const LatticeSize& size) {
  constexpr double overlap = 0.02;
  const std::int64_t lines = size.across + 1, points = size.along + 1;
  gap_.resize(static_cast<std::size_t>(lines * points));
  contact_->field(Field::gap, InAxes::local, static_cast<std::int64_t>(gap_.size()), gap_.data());
  double ends = 0, sides = 0;
  const auto at = [&](std::int64_t i, std::int64_t j) { return gap_[static_cast<std::size_t>(j * points + i)]; };
  for (std::int64_t i = 0; i < points; ++i) sides = std::min({sides, at(i, 0), at(i, lines - 1)});
  for (std::int64_t j = 0; j < lines; ++j) ends = std::min({ends, at(0, j), at(points - 1, j)});
  if (std::min(ends, sides) > -overlap * patch_.overlap) return 0;
  return ends < sides ? 1 : 2;
}

void PatchContact::take_results(const WheelMotion& motion) {
  Vec3 force{}, moment{};
  contact_->resultant(InAxes::local, force.data(), moment.data());
  force_ = from_axes(axes_, force);
  moment_ = from_axes(axes_, moment) + cross(axes_.origin - patch_.reference, force_);
  // The wheel's surface is as far inside the rail as both overlap, which belongs to its rolling radius.
  const Vec3 wheel = motion.velocity.at(patch_.reference + patch_.overlap * axes_.n),
             rail = motion.rail.at(patch_.reference), slip = wheel - rail;
  const Vec3 turning = motion.velocity.angular - motion.rail.angular;
  // At which both surfaces run through the contact, on average.
  const double speed = std::abs(motion.speed - 0.5 * (wheel[0] + rail[0]));
  creepages_ = {slip[0] / speed, dot(slip, patch_.lateral) / speed, -dot(turning, patch_.normal) / speed};
}

}  // namespace rollcon
