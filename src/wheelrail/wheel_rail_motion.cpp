/// Places wheel and rail in the track, and gives the wheel its velocity.

#include <cmath>

#include "support/error.hpp"
#include "wheelrail/wheel_rail.hpp"

namespace rollcon {
namespace {

/// Returns the pose with the roll about x inside the yaw about z, or outside of it.
Pose attitude(double roll, double yaw, bool roll_outside = false) {
  const double cr = std::cos(roll), sr = std::sin(roll), cy = std::cos(yaw), sy = std::sin(yaw);
  if (roll_outside) return {.rotation = {{{cy, -sy, 0}, {cr * sy, cr * cy, -sr}, {sr * sy, sr * cy, cr}}}};
  return {.rotation = {{{cy, -sy * cr, sy * sr}, {sy, cy * cr, -cy * sr}, {0, sr, cr}}}};
}

Velocity seen_from(const Pose& pose, const Velocity& v) {
  return {pose.turn_back(v.linear), pose.turn_back(v.angular), pose.to_body(v.point)};
}

}  // namespace

Pose WheelRail::attitude_of(const WheelsetState& position) {
  return attitude(position.roll, position.yaw, position.roll_outside);
}

// Returns the point of the track that the gauge is measured to, at the height of the rail's top, or the rail's origin.
Vec3 WheelRail::rail_pivot(const RailDeviation& deviation) const {
  return deviation.about_origin || track_->by_origin ? rail_shape_.origin : Vec3{0, 0.5 * track_->gauge, 0};
}

Pose WheelRail::rail_pose(const RailDeviation& deviation) const {
  const Vec3 pivot = rail_pivot(deviation);
  Pose rail = attitude(deviation.roll, 0);
  rail.translation = pivot + Vec3{0, deviation.y, deviation.z} - rail.turn(pivot);
  return rail;
}

Pose WheelRail::wheel_pose(const WheelsetState& position, double z, const WheelsetState& bend) const {
  Pose wheel = attitude_of(position);
  wheel.translation =
      centre_at(position.y, z) + wheel.turn({bend.x, 0.5 * back_to_back_ - flange_back_ + bend.y, radius_ + bend.z});
  if (bend.roll != 0 || bend.yaw != 0) wheel = composed(wheel, attitude_of(bend));
  if (wheel_varies_ == 0) return wheel;
  const double angle = position.pitch + bend.pitch, c = std::cos(angle), s = std::sin(angle);
  const Vec3 middle{0, 0, -radius_}, stays = wheel.place(middle);
  wheel = composed(wheel, {.rotation = {{{c, 0, s}, {0, 1, 0}, {-s, 0, c}}}});
  wheel.translation = stays - wheel.turn(middle);
  return wheel;
}

WheelMotion WheelRail::motion_at(double z, const Inputs& in) const {
  const Pose set = attitude_of(in.position), wheel = wheel_pose(in.position, z, in.bend);
  Vec3 centre = centre_at(in.position.y, z), linear{in.velocity.x, in.velocity.y, in.velocity.z};
  const Pose rail = rail_pose(in.deviation);
  // The outer turn keeps its own axis and turns that of the inner one.
  const Pose outer = in.position.roll_outside ? attitude(in.position.roll, 0) : attitude(0, in.position.yaw);
  Vec3 turning = outer.turn({in.velocity.roll, 0, in.velocity.yaw});
  if (in.bent) {
    const WheelsetState& rate = in.bend_rate;
    const Vec3 middle = wheel.place({0, 0, -radius_});
    linear = linear + cross(turning, middle - centre) + set.turn({rate.x, rate.y, rate.z});
    turning = turning + set.turn({rate.roll, rate.pitch, rate.yaw}) + wheel.turn({0, in.velocity.pitch, 0});
    centre = middle;
  } else {
    turning = turning + set.turn({0, in.velocity.pitch, 0});
  }
  // Axes that follow the track turn with it.
  const Vec3 along_curve{0, 0, side_ * in.options.curvature * in.velocity.x};
  linear = linear + cross(along_curve, centre);
  turning = turning + along_curve;
  WheelMotion motion;
  motion.pose = relative(rail, wheel);
  motion.velocity = seen_from(rail, {linear, turning, centre});
  motion.rail =
      seen_from(rail, {{0, in.rate.y, in.rate.z}, {in.rate.roll, 0, 0}, rail.place(rail_pivot(in.deviation))});
  motion.speed = motion.onward = in.velocity.x;
  motion.by_creepages = in.options.slip_by_creepages != 0;
  if (rail_varies_ != 0 || roller_ > 0) motion.along = in.position.x;
  if (roller_ == 0) return motion;
  // The contact lies between both axes.
  const Vec3 rate{0, in.roller_rate, 0}, axis{-motion.along, 0, *rail_shape_.roller};
  motion.onward = onward(in);
  motion.speed *= roller_ / (roller_ + radius_);
  motion.rail.linear = motion.rail.linear + cross(rate, motion.rail.point - axis);
  motion.rail.angular = motion.rail.angular + rate;
  return motion;
}

// Names the entry of the velocity that does most harm, beside a wheel that rolls. The speed is linear in each.
void WheelRail::require_onward(const OverlapPatch& patch, const WheelMotion& motion) const {
  constexpr double least = 0.01;  // part of the speed of the contact
  const auto part = [&](const WheelMotion& m) { return speed_through(patch, m) / m.onward; };
  const double now = part(motion);
  if (in_.step == StepKind::shift || now > least) return;
  struct Entry {
    const char* name;
    int number;
    double WheelsetState::*rate;
    double sign, rolling;
  };
  const Entry entries[] = {{"pitch rate", 5, &WheelsetState::pitch, 1, -motion.onward / patch.rolling_radius},
                           {"rate of y", 1, &WheelsetState::y, side_, 0},
                           {"rate of z", 2, &WheelsetState::z, 1, 0},
                           {"roll rate", 3, &WheelsetState::roll, side_, 0},
                           {"yaw rate", 4, &WheelsetState::yaw, side_, 0}};
  const Entry* worst = entries;
  double gain = 0;
  for (const Entry& e : entries) {
    Inputs rolling = in_;
    rolling.velocity.*e.rate = e.rolling;
    if (const double more = part(motion_at(z_, rolling)) - now; more > gain) worst = &e, gain = more;
  }
  if (!(gain > 0))
    fail(Status::err_argument,
         "surfaces run backwards through the contact at y = %g of the wheel's profile, at %g of the speed %g along the "
         "rail; allowed: above %g; check the rates of roller, rail and flexible wheel (rollcon_wheelrail_set_roller, "
         "rollcon_wheelrail_set_rail_deviation, rollcon_wheelrail_set_flexibility)",
         patch.wheel_y, now, motion.onward, least);
  const double is = in_.velocity.*worst->rate, most = is + (worst->rolling - is) * (least - now) / gain;
  fail(Status::err_argument,
       "the %s, entry %d of velocity, is %g: with the speed %g along the rail surfaces run backwards through the "
       "contact at y = %g of the wheel's profile; allowed: %s %g; a wheel that rolls has about %g "
       "(rollcon_wheelrail_set_velocity)",
       worst->name, worst->number, worst->sign * is, motion.onward, patch.wheel_y,
       worst->sign * (most - is) < 0 ? "below" : "above", worst->sign * most, worst->sign * worst->rolling);
}

}  // namespace rollcon
