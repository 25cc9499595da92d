#include "contact/prepare/rigid_slip.hpp"

#include "contact/prepare/between_surfaces.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

// Moves a creep field, given at the nodes, to where the characteristic scheme takes slip, d = delta/2 upstream: c(x + d
// e) = c - d (v . grad c), exact for linear fields such as spin.
void shift_field(Preparation& preparation) {
  Problem& p = preparation.made->problem;
  SparseRows& d = preparation.field_rows;
  if (d.start.empty()) d = least_squares(preparation.made->frame, 1, 0);
  for (std::vector<double>* field : {&p.slip1, &p.slip2}) {
    std::vector<double>& given = preparation.field_given;
    given = *field;
    for (std::size_t i = 0; i < given.size(); ++i) {
      double derivative = 0;
      for (auto k = at(d.start[i]); k < at(d.start[i + 1]); ++k) derivative += d.value[k] * given[at(d.column[k])];
      (*field)[i] -= (p.convection.slip_x[i] - preparation.made->frame.x[i]) * derivative;
    }
  }
}

void add_creep_field(Preparation& preparation, const Scene& scene) {
  const double speed = preparation.made->speed;
  Problem& p = preparation.made->problem;
  const auto& field = scene.creep_field();
  const std::size_t n = field.size() / 2;
  p.slip1.resize(n);
  p.slip2.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    p.slip1[k] = field[2 * k] / speed;
    p.slip2[k] = field[2 * k + 1] / speed;
  }
  if (n > 0 && (!p.convection.ahead.empty() || preparation.made->distance != 0)) shift_field(preparation);
}

// Adds the relative velocity of the bodies at each point, over the speed, beyond creepages and spin, which are what it
// is over the axes' origin.
void add_velocities(Preparation& preparation, const Scene& scene) {
  Problem& p = preparation.made->problem;
  const Velocity of = scene.relative_velocity();
  const Vec3& turning = of.angular;
  const double speed = preparation.made->speed;
  const Vec3 at_origin = of.at(preparation.origin_between);
  const double per_motion = speed * p.motion_scale;
  preparation.creepage = {at_origin[0] / per_motion, at_origin[1] / per_motion, 0, turning[2] / per_motion};
  const std::size_t n = preparation.point_between.size();
  if (n == 0) return;
  p.slip1.resize(n);
  p.slip2.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    const Vec3 x = preparation.point_between[k];
    const Vec3 off = x - preparation.origin_between - Vec3{p.convection.slip_x[k], p.convection.slip_y[k], 0};
    Vec3 rest = cross(turning, off);
    if (!p.turn.empty()) rest[2] = of.at(x)[2];
    const auto along = [&](std::size_t c) {
      return p.turn.empty() ? rest[c] : dot({p.turn[k][c][0], p.turn[k][c][1], p.turn[k][c][2]}, rest);
    };
    p.slip1[k] += along(0) / speed;
    p.slip2[k] += along(1) / speed;
  }
}

// Takes what a time step makes of speed and motions. The particle that is at a node now came along a path whose middle
// is half the distance upstream, where the rigid slip equals its mean over the path.
void take_step(Preparation& preparation, const Scene& scene) {
  Prepared& on = *preparation.made;
  Problem& p = on.problem;
  on.step = scene.step_kind();
  on.distance = 0;
  p.motion_scale = 1;
  if (on.step == StepKind::steady) {
    on.speed = scene.speed(preparation.origin_between);
    return;
  }
  on.speed = 1 / scene.step_time();
  if (on.step == StepKind::rolling) {
    const double speed = scene.speed(preparation.origin_between), dt = scene.step_time();
    p.motion_scale = on.distance = speed * dt;
    if (constexpr double most = 1e12; !(on.distance <= most * p.length))
      fail(Status::err_argument,
           "a step rolls by V dt = %g (V %g, dt %g), %g times the frame's size; allowed: up to %g (units?)",
           on.distance, speed, dt, on.distance / p.length, most);
  }
  if (!preparation.points.enter(preparation.convection.version(), preparation.place.version(), on.distance)) return;
  for (std::size_t k = 0; k < on.frame.x.size(); ++k) {
    p.convection.slip_x[k] = on.frame.x[k] + upstream(on, k) / 2;
    p.convection.slip_y[k] = on.frame.y[k];
  }
}

// Adds displacements given elsewhere, which move with the particles, too.
void add_carried_offset(Preparation& preparation) {
  Prepared& on = *preparation.made;
  const std::size_t n = on.offset_depth.size();
  if (n == 0) return;
  std::vector<double> x = on.frame.x, here(3 * n), before(3 * n);
  on.compliance->offset({x, on.frame.y}, here.data());
  for (std::size_t k = 0; k < n; ++k) x[k] += upstream(on, k);
  on.compliance->offset({x, on.frame.y}, before.data());
  for (std::size_t c = 0; c < 2; ++c) {
    on.offset_slip[c].resize(n);
    for (std::size_t k = 0; k < n; ++k) on.offset_slip[c][k] = here[3 * k + c] - before[3 * k + c];
  }
}

void add_offset(Preparation& preparation) {
  const Prepared& on = *preparation.made;
  Problem& p = preparation.made->problem;
  if (on.offset_depth.empty()) return;
  p.slip1.resize(on.offset_depth.size());
  p.slip2.resize(p.slip1.size());
  for (std::size_t k = 0; k < p.slip1.size(); ++k) {
    p.slip1[k] += on.offset_slip[0][k];
    p.slip2[k] += on.offset_slip[1][k];
  }
}

}  // namespace

void read_slip(Preparation& preparation, const Scene& scene, const Preparation::Poses& poses) {
  const bool stepping = scene.step_kind() != StepKind::steady;
  if (scene.step_kind() == StepKind::rolling && scene.velocities_given() && preparation.between.version() == 0)
    find_points_between(preparation);  // finds the speed
  take_step(preparation, scene);
  if (scene.velocities_given() && preparation.between.enter(preparation.convection.version(), preparation.gap.version(),
                                                            preparation.points.version(), poses)) {
    find_points_between(preparation);
    take_step(preparation, scene);
  }
  if (!preparation.slip.enter(preparation.convection.version(), preparation.between.version(),
                              preparation.points.version(), preparation.offset_change, scene.revision.kinematics))
    return;
  ++preparation.builds.slips;
  add_creep_field(preparation, scene);
  if (scene.velocities_given()) add_velocities(preparation, scene);
  if (stepping) add_carried_offset(preparation);
  add_offset(preparation);
  Problem& p = preparation.made->problem;
  if (!stepping) return;
  preparation.rigid[0] = p.slip1;
  preparation.rigid[1] = p.slip2;
}

}  // namespace rollcon
