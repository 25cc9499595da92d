#include "wheelrail/patch_calibration.hpp"

#include <cmath>

#include "bodies/pair.hpp"
#include "contact/solver.hpp"
#include "linalg/blas_threads.hpp"
#include "support/error.hpp"
#include "support/small_system.hpp"
#include "wheelrail/hertzian_patch.hpp"
#include "wheelrail/patch_contact.hpp"

namespace rollcon {
namespace {

/// Brings creepages to a point that lies at (x, y).
std::array<double, 3> moved(const std::array<double, 3>& v, double x, double y) {
  return {v[0] - v[2] * y, v[1] + v[2] * x, v[2]};
}

std::array<double, 3> product(const Matrix3& m, const std::array<double, 3>& v) {
  std::array<double, 3> p{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) p[i] += m[i][k] * v[k];
  return p;
}

/// Holds motions over the speed.
struct Motions {
  std::array<double, 3> creepage{};  ///< at the middle of both surfaces at the patch's reference
  double height = 0, speed = 0;
};

Motions motions_of(const OverlapPatch& patch, const WheelMotion& motion, const Axes& axes) {
  const Vec3 at = patch.reference + 0.5 * dot(patch.wheel - patch.reference, axes.n) * axes.n;
  const Vec3 wheel = motion.velocity.at(at), rail = motion.rail.at(at), slip = wheel - rail;
  const Vec3 turning = motion.velocity.angular - motion.rail.angular;
  Motions m;
  m.speed = std::abs(motion.speed - 0.5 * (wheel[0] + rail[0]));
  m.creepage = {dot(slip, axes.t1) / m.speed, dot(slip, axes.t2) / m.speed, dot(turning, axes.n) / m.speed};
  m.height = dot(turning, axes.t2) / m.speed;
  return m;
}

}  // namespace

std::optional<PatchCalibration> PatchContact::calibration(const OverlapPatch& patch, const WheelMotion& motion) {
  const BlasThreads blas(1);
  constexpr double sticks = 10;  // friction under which nearly all of the patch sticks
  reset();
  solve(patch, motion, {.mu = sticks}, {{getenv("NA") ? atoi(getenv("NA")) : 12, getenv("NC") ? atoi(getenv("NC")) : 12}, {12, 20}, {12, 22}}, 0);
  const HertzianPatch h = hertzian_patch(patch, modulus(), 0);
  const strips::StripSolution& found = strips_->solution();
  if (!now_.on_strips || now_.status == Status::no_contact || found.share < 1 || found.strips.layout.parts > 1 ||
      patch.cut || !(h.load > 0))
    return std::nullopt;
  EquivalentEllipse e;
  try {
    e = strips_->equivalent_ellipse(contact_->solver->bodies());
  } catch (const Error& error) {
    if (error.status() != Status::err_state) throw;
    return std::nullopt;
  }
  strips::StripContact ellipse;
  strips::Adhesion own, other;
  const strips::StripScene& scene = strips_->scene();
  if (!strips_->adhesion(own) ||
      !strips::adhere_on_ellipse(ellipse, scene.bodies, e.a, e.b, found.strips.layout.counts, other))
    return std::nullopt;
  // Forces about the ellipse's centre by creepages there, and by slip along x that heights cause: height (h - h0).
  const Motions m = motions_of(patch, motion, now_.axes);
  const auto [x, y] = e.centre;
  std::array<std::array<double, 7>, 3> system{};
  for (std::size_t k = 0; k < 4; ++k) {
    std::array<double, 3> f = own.force[k];
    if (k == 2)
      for (std::size_t i = 0; i < 3; ++i) f[i] += y * own.force[0][i] - x * own.force[1][i];
    if (k == 3)
      for (double& v : f) v /= m.height;
    f[2] += y * f[0] - x * f[1];
    for (std::size_t i = 0; i < 3; ++i) system[i][3 + k] = f[i];
  }
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) system[i][k] = other.force[k][i];
  if (!solve_small(3, system)) return std::nullopt;
  PatchCalibration c;
  for (std::size_t i = 0; i < 3; ++i) {
    std::copy_n(&system[i][3], 3, c.stretch[i].begin());
    c.lifted[i] = system[i][6];
  }
  // Height h0 is that at the origin, off the middle at the reference.
  const Vec3 off = patch.reference - now_.axes.origin;
  c.centre = {x - dot(off, now_.axes.t1), y - dot(off, now_.axes.t2)};
  const std::array<double, 3> at_centre = moved(m.creepage, c.centre[0], c.centre[1]),
                              of_scene = moved(scene.motion, x, y);
  const double origin_height = (of_scene[0] - at_centre[0]) / m.height;
  for (std::size_t i = 0; i < 3; ++i) {
    c.lifted[i] += c.stretch[i][0] * origin_height;
    c.sliding[i] = (e.creepage[i] - at_centre[i]) / m.height;
  }
  const double side = std::sqrt(e.a * e.b);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      c.linear[i][k] = other.force[k][i] / (e.shear * side * side * (i == 2 ? side : 1) * (k == 2 ? side : 1));
  c.a = e.a / h.a;
  c.b = e.b / h.b;
  c.load = e.load / h.load;
  c.pressure = max_pressure() / h.max_pressure;
  c.filled = e.filled;
  return c;
}

// The map is that of a wheel that rolls forward: backwards it is mirrored.
bool PatchContact::take_table_forces(const PatchFriction& friction, const HertzianPatch& h, double load) {
  const PatchCalibration& c = friction.calibration;
  const CommonElasticity common = common_elasticity(*wheel_, *rail_);
  const Axes& axes = now_.axes;
  const Motions m = motions_of(now_.patch, now_.motion, axes);
  const double side = dot(axes.t2, now_.patch.lateral) > 0 ? 1 : -1;
  const std::array<double, 3> there =
      moved({m.creepage[0], side * m.creepage[1], side * m.creepage[2]}, c.centre[0], c.centre[1]);
  std::array<double, 3> linear = product(c.stretch, there), sliding = there;
  const double height = side * (side * m.height);
  for (std::size_t i = 0; i < 3; ++i) {
    linear[i] += c.lifted[i] * height;
    sliding[i] += c.sliding[i] * height;
  }
  EquivalentEllipse e;
  e.shear = common.shear;
  e.poisson = common.poisson;
  e.strained = common.strained;
  e.friction = friction.mu;
  e.load = load;
  e.a = c.a * h.a;
  e.b = c.b * h.b;
  const double size = std::sqrt(e.a * e.b);
  const std::array<double, 3> force = product(c.linear, {linear[0], linear[1], size * linear[2]});
  const double r = e.shear * e.a * e.b * std::hypot(force[0], force[1], force[2]) / (friction.mu * load);
  const double slides = std::isfinite(r) ? (r / (1 + r)) * (r / (1 + r)) : 1;
  const auto mirrored = [&](std::size_t i) { return i == 0 ? 1 : side; };
  for (std::size_t i = 0; i < 3; ++i) e.creepage[i] = mirrored(i) * ((1 - slides) * linear[i] + slides * sliding[i]);
  Vec3 own{};
  try {
    friction.table->evaluate(e, own.data());
  } catch (const Error& error) {
    if (error.status() != Status::err_argument && error.status() != Status::err_state) throw;
    return false;
  }
  // What pressure strains one body more than the other is slip, too.
  double power = -own[0] * strain_creepage(e.strained, e.load, e.a, e.b);
  for (std::size_t i = 0; i < 3; ++i) power -= own[i] * mirrored(i) * sliding[i];
  now_.table_power = m.speed * power;
  now_.force = own[0] * axes.t1 + own[1] * axes.t2;
  now_.arm = c.centre[0] * axes.t1 + c.centre[1] * now_.patch.lateral;
  now_.moment = own[2] * axes.n + cross(now_.arm, now_.force);
  return true;
}

}  // namespace rollcon
