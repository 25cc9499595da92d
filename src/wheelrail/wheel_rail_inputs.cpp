/// Takes what a wheel on its rail is given. Everything of a left one is held as it is in the mirror.

#include <cmath>
#include <utility>

#include "support/input_checks.hpp"
#include "wheelrail/wheel_rail.hpp"

namespace rollcon {
namespace {

constexpr double most_cant = 0.5, most_turn = 0.5;

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
  for (Body* body : {given_wheel_.get(), given_rail_.get()}) {
    if (body->traits().section) body->prepare();
    body->profile();
  }
  for (const auto& [body, name] : {std::pair{&given_wheel_, "wheel"}, {&given_rail_, "rail"}})
    if ((*body)->creeps())
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
  if (!(std::abs(cant) <= most_cant)) fail(Status::err_argument, "cant is %g; allowed: -0.5 to 0.5 (radian)", cant);
  set_place({gauge, gauge_height, cant});
}

void WheelRail::place_by_origin(double y, double z, double cant) {
  require_finite(y, "y");
  require_finite(z, "z");
  require_finite(cant, "cant");
  if (!(std::abs(cant) <= most_cant)) fail(Status::err_argument, "cant is %g; allowed: -0.5 to 0.5 (radian)", cant);
  set_place({0, 0, cant, true, y, z});
}

void WheelRail::set_place(const TrackGauge& track) {
  RailShape shape = place_rail(given_rail_->nominal_profile(), track);
  if (roller_ > 0) revolve(shape, track, roller_);
  rail_shape_ = std::move(shape);
  track_ = track;
  search_.reset();
  solved_.reset();
  ++dimensions_;
}

void WheelRail::set_roller(double radius, double rate) {
  require_finite(radius, "radius");
  require_finite(rate, "rate");
  if (!(radius >= 0)) fail(Status::err_argument, "radius is %g; allowed: > 0, or 0: a rail", radius);
  if (radius != roller_) {
    const double before = std::exchange(roller_, radius);
    try {
      if (track_) set_place(*track_);
    } catch (...) {
      roller_ = before;
      throw;
    }
  }
  in_.roller_rate = radius > 0 ? rate : 0;
}

void WheelRail::set_wheelset(double back_to_back, double flange_back, double radius) {
  require_finite(back_to_back, "back_to_back");
  require_finite(flange_back, "flange_back");
  require_finite(radius, "radius");
  if (!(back_to_back > 0)) fail(Status::err_argument, "back_to_back is %g; allowed: > 0", back_to_back);
  if (!(radius > 0)) fail(Status::err_argument, "radius is %g; allowed: > 0", radius);
  take_wheel_profile(given_wheel_->nominal_profile(), radius, std::nullopt);
  back_to_back_ = back_to_back;
  flange_back_ = flange_back;
  wheelset_given_ = true;
}

// Measures the radius at the profile's z = 0 from that of the tape circle.
void WheelRail::take_wheel_profile(std::shared_ptr<const ProfileCurve> curve, double nominal,
                                   const std::optional<double>& tape) {
  double depth = 0;
  if (tape) {
    const std::vector<double> there = curve->at_y(*tape);
    if (there.empty())
      fail(Status::err_argument, "y of the tape circle is %g; allowed: %g to %g, where the wheel's profile is", *tape,
           curve->at(0).x[0], curve->at(curve->length()).x[0]);
    depth = curve->at(there.back()).x[1];
  }
  require_wheel_profile(*curve, nominal - depth);
  wheel_curve_ = std::move(curve);
  nominal_radius_ = nominal;
  radius_ = nominal - depth;
  tape_ = tape;
  search_.reset();
  solved_.reset();
  ++dimensions_;
}

void WheelRail::set_tape_circle(double y) {
  require_finite(y, "y");
  if (!wheelset_given_)
    fail(Status::err_state, "the wheelset has no radius yet: call rollcon_wheelrail_set_wheelset first");
  take_wheel_profile(given_wheel_->nominal_profile(), nominal_radius_, y);
}

void WheelRail::set_flexibility(const double* displacement, const double* rate) {
  const WheelsetState bend = state_of(displacement, "displacement", side_), bend_rate = state_of(rate, "rate", side_);
  if (!(std::abs(bend.roll) <= most_turn && std::abs(bend.yaw) <= most_turn))
    fail(Status::err_argument, "roll of the displacement is %g and yaw is %g; allowed: -0.5 to 0.5 (radian)",
         displacement[3], displacement[4]);
  in_.bend = bend;
  in_.bend_rate = bend_rate;
  in_.bend.roll_outside = in_.position.roll_outside;
  const auto none = [](const WheelsetState& s) {
    return s.x == 0 && s.y == 0 && s.z == 0 && s.roll == 0 && s.yaw == 0 && s.pitch == 0;
  };
  in_.bent = !none(bend) || !none(bend_rate);
}

void WheelRail::set_rail_springs(const double* stiffness, const double* force) {
  require_pointer(stiffness, "stiffness");
  require_pointer(force, "force");
  require_finite(2, 1, stiffness, "stiffness", 0);
  require_finite(2, 1, force, "force", 0);
  for (int i = 0; i < 2; ++i)
    if (stiffness[i] < 0)
      fail(Status::err_argument, "entry %d of stiffness (counting from 0) is %g; allowed: > 0, or 0: rigid", i,
           stiffness[i]);
  in_.stiffness = {stiffness[0], stiffness[1]};
  in_.rail_force = {side_ * force[0], force[1]};
}

void WheelRail::prescribe_longitudinal(std::int32_t how, double force) {
  if (how != static_cast<std::int32_t>(How::by_motion) && how != static_cast<std::int32_t>(How::by_force))
    fail(Status::err_argument, "how is %d; allowed: 1 (by motion), 2 (by force)", how);
  const bool by_pull = how == static_cast<std::int32_t>(How::by_force);
  if (by_pull) {
    require_finite(force, "force");
    in_.pull = force;
  }
  in_.by_pull = by_pull;
}

void WheelRail::set_rail_deviation(const double* deviation, const double* rate) {
  require_finite_vector(deviation, "deviation");
  require_finite_vector(rate, "rate");
  if (!(std::abs(deviation[2]) <= 0.5))
    fail(Status::err_argument, "roll of the rail's deviation is %g; allowed: -0.5 to 0.5 (radian)", deviation[2]);
  in_.deviation = {side_ * deviation[0], deviation[1], side_ * deviation[2], in_.deviation.about_origin};
  in_.rate = {side_ * rate[0], rate[1], side_ * rate[2]};
}

void WheelRail::set_position(const double* position) {
  WheelsetState now = state_of(position, "position", side_);
  now.roll_outside = in_.position.roll_outside;
  if (!(std::abs(now.roll) <= most_turn && std::abs(now.yaw) <= most_turn))
    fail(Status::err_argument, "roll is %g and yaw is %g; allowed: -0.5 to 0.5 (radian)", position[3], position[4]);
  in_.position = now;
  in_.position_given = true;
}

void WheelRail::set_velocity(const double* velocity) {
  const WheelsetState now = state_of(velocity, "velocity", side_);
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
  in_.position.roll_outside = in_.bend.roll_outside = in_.options.roll_outside != 0;
  in_.deviation.about_origin = in_.options.roll_about_origin != 0;
}

void WheelRail::follow_bodies() {
  const bool same_bodies = !wheel_ || (given_wheel_->same_elastic(*wheel_) && given_rail_->same_elastic(*rail_));
  auto wheel = given_wheel_->nominal_profile(), rail = given_rail_->nominal_profile();
  const std::size_t wheel_varies = given_wheel_->variations(), rail_varies = given_rail_->variations();
  if (same_bodies && wheel == wheel_curve_ && rail == rail_shape_.curve && wheel_varies == wheel_varies_ &&
      rail_varies == rail_varies_)
    return;
  wheel_varies_ = wheel_varies;
  rail_varies_ = rail_varies;
  take_wheel_profile(std::move(wheel), nominal_radius_, tape_);
  rail_shape_ = place_rail(std::move(rail), *track_);
  if (roller_ > 0) revolve(rail_shape_, *track_, roller_);
  wheel_.reset();
  rail_.reset();
}

}  // namespace rollcon
