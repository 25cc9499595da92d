#include "wheelrail/patch_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "bodies/pair.hpp"
#include "contact/solver.hpp"
#include "framing/hertz.hpp"
#include "framing/makers.hpp"
#include "support/index.hpp"
#include "wheelrail/hertzian_patch.hpp"
#include "wheelrail/patch_snapshot.hpp"

namespace rollcon {
namespace {

/// Factor on a frame each time that it was too small.
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
    : wheel_(std::move(wheel)),
      rail_(std::move(rail)),
      contact_(std::make_shared<Contact>(std::move(context), wheel_, rail_)) {}

PatchContact::PatchContact(PatchContact&& other) noexcept = default;
PatchContact::~PatchContact() = default;

Status PatchContact::solve(const OverlapPatch& patch, const WheelMotion& motion, const PatchFriction& friction,
                           const LatticeSize& size, double give_way) {
  now_.solves = ++solves_;
  now_.patch = patch;
  now_.motion = motion;
  lay_axes();
  take_creepages();
  now_.by_table = now_.hertzian = false;
  now_.give_way = give_way;
  if (friction.table && friction.hertzian && take_hertzian_results(friction, give_way)) return now_.status;
  stand(motion);
  if (friction.table) {
    prescribe(give_way, {});
    solve_on_frame(size);
    if (take_table_results(friction)) return now_.status;
  }
  prescribe(give_way, friction);
  solve_on_frame(size);
  const Loads loads = contact_->solver->loads();
  take_results(loads.force, loads.moment);
  return now_.status;
}

void PatchContact::solve_on_frame(const LatticeSize& size) {
  for (int growths = 0;; ++growths) {
    lay_frame(size);
    contact_->solver->forget_all_but_tractions();
    now_.status = contact_->solver->solve();
    if (now_.status != Status::ok && now_.status != Status::coarse) break;
    // Nothing touches beyond the overlap of the undeformed bodies.
    const int rim = rim_reached(size);
    if (rim == 0 || now_.whole[static_cast<std::size_t>(rim - 1)]) break;
    if (growths == most_growths) {
      now_.status = Status::rim_contact;
      break;
    }
    now_.margin[static_cast<std::size_t>(rim - 1)] *= growth;
    ++now_.grown;
  }
}

namespace {

/// Returns the frictional power over speed. What pressure strains one body more than the other is slip, too.
double power_of(const Vec3& own, const EquivalentEllipse& e) {
  const double longitudinal = e.creepage[0] + strain_creepage(e.strained, e.load, e.a, e.b);
  return -(own[0] * longitudinal + own[1] * e.creepage[1] + own[2] * e.creepage[2]);
}

}  // namespace

// Takes results from the table; returns false where it does not have this patch.
bool PatchContact::take_table_results(const PatchFriction& friction) {
  Vec3 own{};
  const auto [force, moment] = contact_->solver->loads();
  if (now_.status != Status::ok && now_.status != Status::coarse && now_.status != Status::rim_contact) {
    if (now_.status != Status::no_contact) return false;
    now_.by_table = true;
    now_.table_power = 0;
    take_results(force, moment);
    return true;
  }
  try {
    EquivalentEllipse e = contact_->equivalent_ellipse();
    e.friction = friction.mu;
    friction.table->evaluate(e, own.data());
    now_.table_power = contact_->stat("rolling_speed") * power_of(own, e);
    own[2] += e.centre[0] * own[1] - e.centre[1] * own[0];
  } catch (const Error& e) {
    if (e.status() != Status::err_argument && e.status() != Status::err_state) throw;
    return false;
  }
  now_.by_table = true;
  take_results({own[0], own[1], force[2]}, {moment[0], moment[1], own[2]});
  return true;
}

// Takes results for Hertz's ellipse from the table; returns false where it does not have this patch.
bool PatchContact::take_hertzian_results(const PatchFriction& friction, double give_way) {
  const CommonElasticity common = common_elasticity(*wheel_, *rail_);
  const HertzianPatch h = hertzian_patch(now_.patch, common.shear / (1 - common.poisson), give_way);
  const WheelMotion& motion = now_.motion;
  const Axes& axes = now_.axes;
  Vec3 own{};
  now_.table_power = 0;
  if (h.load > 0) {
    // Creepages fit the slip over Hertz's pressure, whose second moments are a^2 / 5 and b^2 / 5.
    const Vec3 wheel = motion.velocity.at(h.centre), rail = motion.rail.at(h.centre), slip = wheel - rail;
    const Vec3 turning = motion.velocity.angular - motion.rail.angular;
    const double speed = std::abs(motion.speed - 0.5 * (wheel[0] + rail[0]));
    const double side = dot(axes.t2, now_.patch.lateral);
    const double sheared = -side * dot(cross(turning, h.lean), axes.t1), turned = dot(turning, axes.n);
    const double spin = (h.a * h.a * turned + h.b * h.b * sheared) / (h.a * h.a + h.b * h.b);
    EquivalentEllipse e;
    e.shear = common.shear;
    e.poisson = common.poisson;
    e.strained = common.strained;
    e.friction = friction.mu;
    e.a = h.a;
    e.b = h.b;
    e.load = h.load;
    e.creepage = {dot(slip, axes.t1) / speed, dot(slip, axes.t2) / speed, spin / speed};
    try {
      friction.table->evaluate(e, own.data());
    } catch (const Error& e) {
      if (e.status() != Status::err_argument && e.status() != Status::err_state) throw;
      return false;
    }
    now_.table_power = speed * power_of(own, e);
  }
  now_.status = h.load > 0 ? Status::ok : Status::no_contact;
  if (h.max_pressure > modulus()) now_.status = Status::too_deep;
  now_.by_table = now_.hertzian = true;
  now_.hertzian_pressure = h.max_pressure;
  now_.hertzian_area = std::numbers::pi * h.a * h.b;
  const Vec3 off = h.load > 0 ? h.centre - now_.patch.reference : Vec3{0, 0, 0};
  const Vec3 arm = Vec3{off[0], 0, 0} + dot(off, now_.patch.lateral) * now_.patch.lateral;
  now_.force = from_axes(axes, {own[0], own[1], -h.load});
  now_.moment = own[2] * axes.n + cross(arm, now_.force);
  contact_->reset();
  return true;
}

double PatchContact::modulus() const {
  return contact_modulus(contact_->solver->pair());
}

double PatchContact::max_pressure() const {
  return now_.hertzian ? now_.hertzian_pressure : contact_->stat("max_pressure");
}

double PatchContact::area() const {
  return now_.hertzian ? now_.hertzian_area : contact_->stat("contact_area");
}

double PatchContact::friction_power() const {
  return now_.by_table ? now_.table_power : contact_->stat("friction_power");
}

// Resets the patch so that nothing of it depends on what was solved before.
void PatchContact::reset() {
  now_.margin = {usual_margin, usual_margin};
  now_.shape = {};
  now_.shaped = now_.hold = false;
  now_.solves = ++solves_;
  contact_->reset();
}

void PatchContact::keep(Kept& kept) const {
  kept.state = now_;
  kept.state.owner = this;
  kept.solution = contact_->solver->solution();
}

void PatchContact::return_to(const Kept& kept) {
  if (kept.state.owner == this && kept.state.solves == now_.solves) return;
  const LatticeSize before = now_.size;
  now_ = kept.state;
  now_.solves = ++solves_;
  if (!kept.solution.solved) {
    now_.size = before;
    contact_->reset();
    return;
  }
  now_.size = before;
  stand(now_.motion);
  prescribe(now_.give_way, now_.friction);
  put_frame(kept.state.size, kept.state.place);
  contact_->solver->return_to(kept.solution);
}

// Prescribes approach and friction; points across count from the middle of the frame, along t2.
void PatchContact::prescribe(double give_way, const PatchFriction& friction) {
  now_.give_way = give_way;
  now_.friction = friction;
  now_.friction.table = nullptr;  // the contact alone is solved here
  contact_->scene.prescribe(static_cast<std::int32_t>(Direction::normal), static_cast<std::int32_t>(How::by_motion),
                            -give_way);
  contact_->scene.set_friction("coulomb", 1, &friction.mu);
  const std::size_t n = friction.points;
  std::array<double, 2 * PatchFriction::most> point{};
  const bool along = dot(now_.axes.t2, now_.patch.lateral) > 0;
  const double middle = 0.5 * (now_.patch.low + now_.patch.high);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t from = along ? i : n - 1 - i;
    point[2 * i] = (along ? 1 : -1) * (friction.lateral[from] - middle);
    point[2 * i + 1] = friction.at[from];
  }
  contact_->scene.set_friction_across(static_cast<std::int64_t>(n), point.data());
}

// Lays the axes, which are the contact's space: they never change there, and what belongs to the frame stays.
void PatchContact::lay_axes() {
  now_.axes = axes_of(now_.patch);
}

Axes PatchContact::axes_of(const OverlapPatch& patch) const {
  Axes axes;
  axes.n = -1.0 * patch.normal;
  axes.t1 = {now_.motion.speed > 0 ? 1.0 : -1.0, 0, 0};
  axes.t2 = cross(axes.n, axes.t1);
  const double x = 0.5 * (patch.back + patch.front), y = 0.5 * (patch.low + patch.high);
  axes.origin = patch.reference + Vec3{x, 0, 0} + y * patch.lateral;
  return axes;
}

void PatchContact::stand(const WheelMotion& motion) {
  now_.motion = motion;
  lay_axes();
  Scene& scene = contact_->scene;
  set_pose(scene, 1, now_.axes, motion.pose);
  set_pose(scene, 2, now_.axes, Pose{});
  set_velocity(scene, 0, now_.axes, {{motion.speed, 0, 0}, {0, 0, 0}, {0, 0, 0}});
  set_velocity(scene, 1, now_.axes, motion.velocity);
  set_velocity(scene, 2, now_.axes, motion.rail);
}

void PatchContact::lay_frame(const LatticeSize& size) {
  put_frame(size, place());
}

void PatchContact::put_frame(const LatticeSize& size, const FramePlace& place) {
  Scene& scene = contact_->scene;
  now_.place = place;
  if (!(size == now_.size)) {
    scene.options.set_int("conformal", size.conformal ? 1 : 0);
    const bool in_steps = true;
    scene.set_placed_frame(rectangle_mesh({}, ElementType::quad4, size.along, size.across, {-1, 1, -1, 1}), place,
                           in_steps);
    now_.size = size;
  } else if (!(place == scene.place())) {
    scene.place_frame(place);
  }
}

// Places Hertz's ellipse of the paraboloid with the overlap's depth, width and the curvatures along the rail. The
// contact lies within the overlap.
FramePlace PatchContact::place() {
  const double half = 0.5 * (now_.patch.high - now_.patch.low), depth = now_.patch.overlap;
  const double a = 0.5 * now_.patch.curvature.along, c = now_.patch.curvature.twist;
  const HertzContact hertz = hertz_by_approach({a, depth / (half * half) + c * c / (4 * a), c}, 1, depth);
  const FramePlace ellipse = place_of_disc(hertz.larger, hertz.smaller, hertz.angle);
  const double left = std::sqrt(std::max(1 - now_.give_way / depth, 0.01));
  const std::array<double, 2> wanted{left * now_.margin[0] * ellipse.length, left * now_.margin[1] * ellipse.width},
      most{std::sqrt(depth / a), half};
  for (std::size_t i = 0; i < 2; ++i) now_.whole[i] = wanted[i] >= most[i];
  const double length = std::min(wanted[0], most[0]), width = std::min(wanted[1], most[1]);
  // Operators belong to a shape: it changes in steps, and late. The frame is the least of its shape that holds all.
  constexpr double step = 0.1, late = 0.65;
  const bool hold = now_.hold && now_.shaped;
  now_.shaped = true;
  const auto follow = [hold](double value, std::int64_t& at) {
    if (!hold && std::abs(value - static_cast<double>(at)) > late) at = to_index(std::round(value));
    return static_cast<double>(at);
  };
  const double longer = length / width, ratio = std::exp(step * follow(std::log(longer) / step, now_.shape[0])),
               shear = step * follow(ellipse.shear / ellipse.length / step, now_.shape[1]);
  const double w = std::max(width, length / ratio);
  return {ratio * w, w, shear * ratio * w};
}

// Returns 0: within, 1: across the ends along the rolling direction, 2: at the sides.
int PatchContact::rim_reached(const LatticeSize& size) {
  constexpr double overlap = 0.02;
  const std::int64_t lines = size.across + 1, points = size.along + 1;
  gap_.resize(static_cast<std::size_t>(lines * points));
  derive_gap(contact_->solver->solution(), gap_.data());
  double ends = 0, sides = 0;
  const auto at = [&](std::int64_t i, std::int64_t j) { return gap_[static_cast<std::size_t>(j * points + i)]; };
  for (std::int64_t i = 0; i < points; ++i) sides = std::min({sides, at(i, 0), at(i, lines - 1)});
  for (std::int64_t j = 0; j < lines; ++j) ends = std::min({ends, at(0, j), at(points - 1, j)});
  if (std::min(ends, sides) > -overlap * now_.patch.overlap) return 0;
  return ends < sides ? 1 : 2;
}

// Takes force and moment on the wheel, in and about the axes of the contact.
void PatchContact::take_results(const Vec3& force, const Vec3& moment) {
  now_.force = from_axes(now_.axes, force);
  now_.moment = from_axes(now_.axes, moment) + cross(now_.axes.origin - now_.patch.reference, now_.force);
}

void PatchContact::take_creepages() {
  const WheelMotion& motion = now_.motion;
  // The wheel's surface is as far inside the rail as both overlap, which belongs to its rolling radius.
  const Vec3 wheel = motion.velocity.at(now_.patch.reference + now_.patch.overlap * now_.axes.n),
             rail = motion.rail.at(now_.patch.reference), slip = wheel - rail;
  const Vec3 turning = motion.velocity.angular - motion.rail.angular;
  // Speed at which both surfaces run through the contact, on average.
  const double through = motion.speed - 0.5 * (wheel[0] + rail[0]), speed = std::abs(through);
  if (!(through * motion.speed > 0))
    fail(Status::err_argument,
         "the pitch rate, entry 5 of velocity, is %g: with the forward speed, entry 0, of %g surfaces run backwards "
         "through the contact; a wheel that rolls has about %g",
         motion.velocity.angular[1], motion.speed, -motion.speed / now_.patch.rolling_radius);
  now_.creepages = {slip[0] / speed, dot(slip, now_.patch.lateral) / speed, -dot(turning, now_.patch.normal) / speed};
}

}  // namespace rollcon
