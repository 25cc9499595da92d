#include "wheelrail/patch_calibration.hpp"

#include <cmath>
#include <numbers>

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

/// Returns the middle of both surfaces at the reference.
Vec3 middle_of(const OverlapPatch& patch) {
  return patch.reference + 0.5 * dot(patch.wheel - patch.reference, patch.normal) * patch.normal;
}

Motions motions_of(const OverlapPatch& patch, const WheelMotion& motion, const Axes& axes) {
  const Vec3 at = middle_of(patch);
  const Vec3 wheel = motion.velocity.at(at), rail = motion.rail.at(at), slip = wheel - rail;
  const Vec3 turning = motion.velocity.angular - motion.rail.angular;
  Motions m;
  m.speed = std::abs(motion.speed - 0.5 * (wheel[0] + rail[0]));
  m.creepage = {dot(slip, axes.t1) / m.speed, dot(slip, axes.t2) / m.speed, dot(turning, axes.n) / m.speed};
  m.height = dot(turning, axes.t2) / m.speed;
  return m;
}

}  // namespace

std::optional<PatchCalibration> PatchContact::calibration(const OverlapPatch& patch, WheelMotion motion,
                                                          const ForceTable& table) {
  const BlasThreads blas(1);
  reset();
  // The wheel turns so fast that there is no slip along x at the middle of the patch.
  const double turning = (motion.velocity.at(middle_of(patch)) - motion.velocity.linear)[0];
  motion.velocity.angular = (-motion.velocity.linear[0] / turning) * motion.velocity.angular;
  const auto coulomb = std::make_shared<FrictionGiven>();
  coulomb->set_law("coulomb", 1, &calibration_friction);
  PatchFriction friction;
  friction.law = coulomb;
  friction.mu = calibration_friction;
  solve(patch, motion, friction, {{12, 12}, {12, 20}, {12, 22}}, 0);
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
  strips::StripSolution on_ellipse;
  const double hertz =
      strips::adhere_on_ellipse(ellipse, scene.bodies, e.a, e.b, found.strips.layout.counts, on_ellipse, other);
  if (hertz == 0 || !strips_->adhesion(own)) return std::nullopt;
  // The strips' own errors cancel in areas, too: the ellipse is as much smaller as strips make one too large.
  const double smaller = std::sqrt(std::numbers::pi * e.a * e.b / strips::area(on_ellipse.strips));
  e.a *= smaller;
  e.b *= smaller;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 3; ++i) other.force[k][i] *= std::pow(smaller, 2 + (i == 2) + (k == 2));
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
  c.pressure = max_pressure() / h.max_pressure * hertz / strips::largest_pressure(on_ellipse.strips).pressure;
  c.filled = e.filled;
  e.friction = calibration_friction;
  c.spin = m.creepage[2];
  c.height = m.height;
  if (!find_missing(table, e, c)) return std::nullopt;
  return c;
}

namespace {

/// Looks forces up, without what is missing.
CalibratedForces forces_of_ellipse(const PatchCalibration& c, const ForceTable& table, EquivalentEllipse e,
                                   const std::array<double, 3>& creepage, double height) {
  CalibratedForces found;
  const std::array<double, 3> there = moved(creepage, c.centre[0], c.centre[1]);
  std::array<double, 3> linear = product(c.stretch, there);
  for (std::size_t i = 0; i < 3; ++i) {
    linear[i] += c.lifted[i] * height;
    found.sliding[i] = there[i] + c.sliding[i] * height;
  }
  const double size = std::sqrt(e.a * e.b);
  const std::array<double, 3> force = product(c.linear, {linear[0], linear[1], size * linear[2]});
  const double r = e.shear * e.a * e.b * std::hypot(force[0], force[1], force[2]) / (e.friction * e.load);
  const double slides = std::isfinite(r) ? (r / (1 + r)) * (r / (1 + r)) : 1;
  for (std::size_t i = 0; i < 3; ++i) e.creepage[i] = (1 - slides) * linear[i] + slides * found.sliding[i];
  table.evaluate(e, found.force.data());
  return found;
}

}  // namespace

CalibratedForces calibrated_forces(const PatchCalibration& c, const ForceTable& table, EquivalentEllipse e,
                                   const std::array<double, 3>& creepage, double height) {
  CalibratedForces found = forces_of_ellipse(c, table, e, creepage, height);
  // What is missing grows with the square of the motions at first, and fades where bodies slide.
  const double turn = height / c.height, natural = 2 * turn * turn / (1 + turn * turn * turn * turn);
  const std::array<double, 3> beside{creepage[0], creepage[1], creepage[2] - c.spin};
  const double size = std::sqrt(e.a * e.b);
  const std::array<double, 3> by = product(c.linear, {beside[0], beside[1], size * beside[2]});
  const double r = e.shear * e.a * e.b * std::hypot(by[0], by[1], by[2]) / (e.friction * e.load);
  const double fade = natural / (1 + r * r);
  if (!(fade > 0)) return found;
  const double share = fade * e.load * calibration_friction / e.friction;
  const std::array<double, 3> change = product(c.missing_by, beside);
  for (std::size_t i = 0; i < 3; ++i) found.force[i] += share * (c.missing[i] + change[i]);
  const double limit = e.friction * e.load, length = std::hypot(found.force[0], found.force[1]);
  double slope = 0;
  if (length > 0)
    for (std::size_t i = 0; i < 2; ++i) found.force[i] *= limit * bend(length / limit, &slope) / length;
  return found;
}

// Compares the solution under natural rolling, and its derivatives, with what the ellipse has.
bool PatchContact::find_missing(const ForceTable& table, EquivalentEllipse e, PatchCalibration& c) {
  const strips::StripTotals& all = strips_->totals();
  strips::Adhesion rate;
  if (!strips_->creep_rates(rate)) return false;
  const Vec3 off = now_.patch.reference - now_.axes.origin;
  const double x = dot(off, now_.axes.t1), y = dot(off, now_.axes.t2);  // the reference
  const auto about_centre = [&](std::array<double, 3> f) {
    f[2] += (y + c.centre[1]) * f[0] - (x + c.centre[0]) * f[1];
    return f;
  };
  for (std::size_t i = 0; i < 3; ++i) rate.force[2][i] += y * rate.force[0][i] - x * rate.force[1][i];
  const Motions m = motions_of(now_.patch, now_.motion, now_.axes);
  const double size = std::sqrt(e.a * e.b), small = 1e-3 * e.friction * e.load / (e.shear * e.a * e.b);
  try {
    const auto force = [&](const std::array<double, 3>& v) {
      return forces_of_ellipse(c, table, e, v, m.height).force;
    };
    const std::array<double, 3> solved = about_centre(all.force), of_ellipse = force(m.creepage);
    for (std::size_t i = 0; i < 3; ++i) c.missing[i] = (solved[i] - of_ellipse[i]) / e.load;
    for (std::size_t k = 0; k < 3; ++k) {
      std::array<double, 3> before = m.creepage, behind = m.creepage;
      const double step = k == 2 ? small / size : small;
      before[k] -= step;
      behind[k] += step;
      const std::array<double, 3> at_before = force(before), at_behind = force(behind),
                                  own = about_centre(rate.force[k]);
      for (std::size_t i = 0; i < 3; ++i)
        c.missing_by[i][k] = (own[i] - (at_behind[i] - at_before[i]) / (2 * step)) / e.load;
    }
  } catch (const Error& error) {
    // Tables of unlike bodies have no equal ones.
    if (error.status() != Status::err_argument && error.status() != Status::err_state) throw;
    c.missing = {};
    c.missing_by = {};
  }
  return true;
}

// The map is that of a wheel that rolls forward: backwards it is mirrored.
bool PatchContact::take_table_forces(const PatchFriction& friction, const HertzianPatch& h, double load) {
  const PatchCalibration& c = friction.calibration;
  const CommonElasticity common = common_elasticity(*wheel_, *rail_);
  const Axes& axes = now_.axes;
  const Motions m = motions_of(now_.patch, now_.motion, axes);
  const double side = dot(axes.t2, now_.patch.lateral) > 0 ? 1 : -1;
  EquivalentEllipse e;
  e.shear = common.shear;
  e.poisson = common.poisson;
  e.strained = common.strained;
  e.friction = friction.mu;
  e.load = load;
  e.a = c.a * h.a;
  e.b = c.b * h.b;
  CalibratedForces f;
  try {
    f = calibrated_forces(c, *friction.table, e, {m.creepage[0], side * m.creepage[1], side * m.creepage[2]}, m.height);
  } catch (const Error& error) {
    if (error.status() != Status::err_argument && error.status() != Status::err_state) throw;
    return false;
  }
  // What pressure strains one body more than the other is slip, too.
  double power = -f.force[0] * strain_creepage(e.strained, e.load, e.a, e.b);
  for (std::size_t i = 0; i < 3; ++i) power -= f.force[i] * f.sliding[i];
  now_.table_power = m.speed * power;
  now_.force = f.force[0] * axes.t1 + side * f.force[1] * axes.t2;
  now_.arm = c.centre[0] * axes.t1 + c.centre[1] * now_.patch.lateral;
  now_.moment = side * f.force[2] * axes.n + cross(now_.arm, now_.force);
  return true;
}

}  // namespace rollcon
