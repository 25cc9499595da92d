/// Takes what a wheel on its rail is given. Everything of a left one is held as it is in the mirror.

#include <cmath>
#include <utility>

#include "support/input_checks.hpp"
#include "wheelrail/wheel_rail.hpp"

namespace rollcon {
namespace {

WheelsetState state_of(const double* v, const char* name, double side) {
  require_pointer(v, name);
  for (int i = 0; i < 6; ++i)
    if (!std::isfinite(v[i])) fail(Status::err_nonfinite, "entry %d of %s (counting from 0) is %g", i, name, v[i]);
  return {v[0], side * v[1], v[2], side * v[3], side * v[4], v[5]};
}

}  // namespace

WheelRail::WheelRail(std::shared_ptr<Context> context, std::shared_ptr<Body> wheel, std::shared_ptr<Body> rail,
                     std::int32_t side)
    : context_(std::move(context)), given_wheel_(std::move(wheel)), given_rail_(std::move(rail)), side_(side) {
  if (side != -1 && side != 1) fail(Status::err_argument, "side is %d; allowed: -1 (left), 1 (right)", side);
  given_wheel_->profile();
  given_rail_->profile();
  for (const auto& [body, name] : {std::pair{&given_wheel_, "wheel"}, {&given_rail_, "rail"}})
    if (!(*body)->relaxation().empty())
      fail(
          Status::err_unsupported,
          "the %s is viscoelastic (rollcon_body_set_viscoelastic); allowed: wheels and rails that are elastic or rigid",
          name);
}

void WheelRail::set_track(double gauge, double gauge_height, double cant) {
  require_finite(gauge, "gauge");
  require_finite(gauge_height, "gauge_height");
  require_finite(cant, "cant");
  if (!(gauge > 0)) fail(Status::err_argument, "gauge is %g; allowed: > 0", gauge);
  if (!(gauge_height >= 0))
    fail(Status::err_argument, "gauge_height is %g; allowed: > 0, or 0: the rail is placed by its profile's origin",
         gauge_height);
  constexpr double most = 0.5;
  if (!(std::abs(cant) <= most)) fail(Status::err_argument, "cant is %g; allowed: -0.5 to 0.5 (radian)", cant);
  const TrackGauge track{gauge, gauge_height, cant};
  rail_shape_ = place_rail(given_rail_->profile(), track);
  track_ = track;
  search_.reset();
  solved_.reset();
  ++dimensions_;
}

void WheelRail::set_wheelset(double back_to_back, double flange_back, double radius) {
  require_finite(back_to_back, "back_to_back");
  require_finite(flange_back, "flange_back");
  require_finite(radius, "radius");
  if (!(back_to_back > 0)) fail(Status::err_argument, "back_to_back is %g; allowed: > 0", back_to_back);
  if (!(radius > 0)) fail(Status::err_argument, "radius is %g; allowed: > 0", radius);
  auto curve = given_wheel_->profile();
  require_wheel_profile(*curve, radius);
  wheel_curve_ = std::move(curve);
  back_to_back_ = back_to_back;
  flange_back_ = flange_back;
  radius_ = radius;
  wheelset_given_ = true;
  search_.reset();
  solved_.reset();
  ++dimensions_;
}

void WheelRail::set_rail_deviation(const double* deviation, const double* rate) {
  require_finite_vector(deviation, "deviation");
  require_finite_vector(rate, "rate");
  if (!(std::abs(deviation[2]) <= 0.5))
    fail(Status::err_argument, "roll of the rail's deviation is %g; allowed: -0.5 to 0.5 (radian)", deviation[2]);
  in_.deviation = {side_ * deviation[0], deviation[1], side_ * deviation[2]};
  in_.rate = {side_ * rate[0], rate[1], side_ * rate[2]};
}

void WheelRail::set_position(const double* position) {
  WheelsetState now = state_of(position, "position", side_);
  now.roll_outside = in_.position.roll_outside;
  constexpr double most = 0.5;
  if (!(std::abs(now.roll) <= most && std::abs(now.yaw) <= most))
    fail(Status::err_argument, "roll is %g and yaw is %g; allowed: -0.5 to 0.5 (radian)", position[3], position[4]);
  in_.position = now;
  in_.position_given = true;
}

void WheelRail::set_velocity(const double* velocity) {
  const WheelsetState now = state_of(velocity, "velocity", side_);
  if (now.x == 0) fail(Status::err_argument, "the forward speed, entry 0 of velocity, is 0; allowed: any other");
  in_.velocity = now;
  in_.velocity_given = true;
}

void WheelRail::prescribe_vertical(std::int32_t how, double force) {
  if (how != static_cast<std::int32_t>(How::by_motion) && how != static_cast<std::int32_t>(How::by_force))
    fail(Status::err_argument, "how is %d; allowed: 1 (by motion), 2 (by force)", how);
  const bool by_force = how == static_cast<std::int32_t>(How::by_force);
  if (by_force) {
    require_finite(force, "force");
    if (!(force >= 0)) fail(Status::err_argument, "force is %g; allowed: >= 0, pressing the wheel on the rail", force);
    in_.load = force;
  }
  in_.by_force = by_force;
}

void WheelRail::set_table(std::shared_ptr<const ForceTable> table) {
  if (table) table->require_made();
  in_.table = std::move(table);
}

void WheelRail::require_solved_friction(const char* wanted) const {
  if (in_.table && !in_.options.conformal)
    fail(Status::err_state,
         "forces along the surfaces come from a table, which has no tractions and no slip: %s needs a solution; call "
         "rollcon_wheelrail_set_table with NULL first",
         wanted);
}

void WheelRail::set_int(const char* name, std::int64_t value) {
  wheel_option_table().set_int(in_.options, name, value);
  in_.position.roll_outside = in_.options.roll_outside != 0;
}

void WheelRail::follow_bodies() {
  const bool same_bodies = !wheel_ || (given_wheel_->same_elastic(*wheel_) && given_rail_->same_elastic(*rail_));
  auto wheel = given_wheel_->profile(), rail = given_rail_->profile();
  if (same_bodies && wheel == wheel_curve_ && rail == rail_shape_.curve) return;
  require_wheel_profile(*wheel, radius_);
  rail_shape_ = place_rail(std::move(rail), *track_);
  wheel_curve_ = std::move(wheel);
  wheel_.reset();
  rail_.reset();
  search_.reset();
  solved_.reset();
  ++dimensions_;
}

}  // namespace rollcon
