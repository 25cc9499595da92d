/// Tells the results of a wheel on its rail after a solve. What was solved in a mirror is turned back.

#include <algorithm>
#include <cmath>

#include "geometry/sliced_surface.hpp"
#include "support/error.hpp"
#include "wheelrail/wheel_rail.hpp"

namespace rollcon {

struct WheelRail::Stat {
  StatisticInfo info;
  double (*value)(const WheelRail& w);
};

const WheelRail::Stat WheelRail::stats[] = {
    {{"z", "z of the wheelset, found or given"}, [](const WheelRail& w) { return w.solved_->z; }},
    {{"vertical_force", "force on the rail, of all patches"}, [](const WheelRail& w) { return w.vertical_force(); }},
    {{"friction_power", "power of friction, of all patches"},
     [](const WheelRail& w) {
       double power = 0;
       for (const Slot* slot : w.active_) power += slot->contact.overlap().share * slot->contact.friction_power();
       return power;
     }},
    {{"solves", "heights tried since the handle was made"},
     [](const WheelRail& w) { return static_cast<double>(w.solves_); }},
    {{"pitch_rate", "pitch rate of the wheelset, found or given"},
     [](const WheelRail& w) { return w.solved_->velocity.pitch; }},
    {{"step_time", "time of all steps since the start"},
     [](const WheelRail& w) { return w.past_ ? w.past_->time : 0; }},
    {{"steps", "steps in time since the start"},
     [](const WheelRail& w) { return w.past_ ? static_cast<double>(w.past_->steps) : 0; }},
    {{"rail_deflection_y", "way of the rail on its springs, along y"},
     [](const WheelRail& w) { return w.side_ * w.solved_->deflection[0]; }},
    {{"rail_deflection_z", "way of the rail on its springs, along z"},
     [](const WheelRail& w) { return w.solved_->deflection[1]; }},
};

struct WheelRail::PatchStat {
  StatisticInfo info;
  double (*value)(const WheelRail& w, const PatchContact& p);
};

const WheelRail::PatchStat WheelRail::patch_stats[] = {
    {{"x", "x of the reference of the patch in the track"},
     [](const WheelRail& w, const PatchContact& p) {
       return w.solved_->position.x + w.rail_pose(w.solved_->deviation).place(p.overlap().reference)[0];
     }},
    {{"y", "y of the reference in the track"},
     [](const WheelRail& w, const PatchContact& p) {
       return w.side_ * w.rail_pose(w.solved_->deviation).place(p.overlap().reference)[1];
     }},
    {{"z", "z of the reference in the track"},
     [](const WheelRail& w, const PatchContact& p) {
       return w.rail_pose(w.solved_->deviation).place(p.overlap().reference)[2];
     }},
    {{"angle", "contact angle, atan dz/dy in the track"},
     [](const WheelRail& w, const PatchContact& p) {
       return w.side_ * (p.overlap().angle + w.solved_->deviation.roll);
     }},
    {{"wheel_y", "y of the reference on the wheel's profile"},
     [](const WheelRail&, const PatchContact& p) { return p.overlap().wheel_y; }},
    {{"rolling_radius", "distance of the wheel's surface at the reference from the axle"},
     [](const WheelRail&, const PatchContact& p) { return p.overlap().rolling_radius; }},
    {{"longitudinal_creepage", "creepage of the wheel relative to the rail, along"},
     [](const WheelRail&, const PatchContact& p) { return p.creepages()[0]; }},
    {{"lateral_creepage", "creepage of the wheel relative to the rail, across"},
     [](const WheelRail& w, const PatchContact& p) { return w.side_ * p.creepages()[1]; }},
    {{"spin", "spin of the wheel relative to the rail"},
     [](const WheelRail& w, const PatchContact& p) { return w.side_ * p.creepages()[2]; }},
    {{"normal_force", "normal force on the wheel"},
     [](const WheelRail&, const PatchContact& p) { return dot(p.force(), p.overlap().normal); }},
    {{"longitudinal_force", "force on the wheel, along"},
     [](const WheelRail&, const PatchContact& p) { return p.force()[0]; }},
    {{"lateral_force", "force on the wheel, across"},
     [](const WheelRail& w, const PatchContact& p) { return w.side_ * dot(p.force(), p.overlap().lateral); }},
    {{"spin_moment", "moment on the wheel about the normal at the reference"},
     [](const WheelRail& w, const PatchContact& p) { return -w.side_ * dot(p.moment(), p.overlap().normal); }},
    {{"overlap", "depth of the overlap of the undeformed surfaces along the normal"},
     [](const WheelRail&, const PatchContact& p) { return p.overlap().overlap; }},
    {{"cut", "1: the overlap ends where a profile does"},
     [](const WheelRail&, const PatchContact& p) { return p.overlap().cut ? 1.0 : 0.0; }},
    {{"share", "weight of the patch in the sums while patches merge"},
     [](const WheelRail&, const PatchContact& p) { return p.overlap().share; }},
    {{"max_pressure", "largest pressure"}, [](const WheelRail&, const PatchContact& p) { return p.max_pressure(); }},
    {{"area", "area in contact"}, [](const WheelRail&, const PatchContact& p) { return p.area(); }},
    {{"friction_power", "power of friction"},
     [](const WheelRail&, const PatchContact& p) { return p.friction_power(); }},
    {{"by_table", "1: tangential forces came from a table"},
     [](const WheelRail&, const PatchContact& p) { return p.by_table() ? 1.0 : 0.0; }},
    {{"hertzian", "1: pressures are those of an ellipse of the overlap"},
     [](const WheelRail&, const PatchContact& p) { return p.hertzian() ? 1.0 : 0.0; }},
    {{"status", "status of its contact"},
     [](const WheelRail&, const PatchContact& p) { return static_cast<double>(p.status()); }},
};

double WheelRail::stat(const char* name) const {
  require_solved();
  return statistic_row(stats, name).value(*this);
}

const StatisticInfo* WheelRail::stat_info(std::int64_t i) {
  return statistic_info(stats, i);
}

double WheelRail::patch_stat(std::int64_t i, const char* name) const {
  return statistic_row(patch_stats, name).value(*this, active(i).contact);
}

const StatisticInfo* WheelRail::patch_stat_info(std::int64_t i) {
  return statistic_info(patch_stats, i);
}

// Sums the totals in the track, as they were solved: in the mirror for a left wheel.
WheelRail::Totals WheelRail::totals(const WheelsetState& position, double z, const RailDeviation& deviation) const {
  const Pose rail = rail_pose(deviation);
  const Vec3 centre = centre_at(position.y, z);
  Totals sum;
  for (const Slot* slot : active_) {
    const PatchContact& p = slot->contact;
    const Vec3 own = p.overlap().share * rail.turn(p.force());
    sum.force = sum.force + own;
    sum.moment =
        sum.moment + p.overlap().share * rail.turn(p.moment()) + cross(rail.place(p.overlap().reference) - centre, own);
  }
  sum.vertical = vertical_force();
  sum.pull = dot(sum.force, attitude_of(position).turn({1, 0, 0}));
  return sum;
}

void WheelRail::resultant(bool of_wheelset, double* force, double* moment) const {
  require_solved();
  const Totals all = totals(solved_->position, solved_->z, solved_->deviation);
  Vec3 f = all.force, m = all.moment;
  if (of_wheelset) {
    const Pose set = attitude_of(solved_->position);
    f = set.turn_back(f);
    m = set.turn_back(m);
  }
  const Vec3 polar{f[0], side_ * f[1], f[2]}, axial{side_ * m[0], m[1], side_ * m[2]};
  if (force) std::copy(polar.begin(), polar.end(), force);
  if (moment) std::copy(axial.begin(), axial.end(), moment);
}

Axes WheelRail::patch_axes(std::int64_t patch) const {
  const Axes& own = active(patch).contact.axes();
  const Pose rail = rail_pose(solved_->deviation);
  const auto back = [&](const Vec3& v) { return Vec3{v[0], side_ * v[1], v[2]}; };
  Axes axes;
  axes.origin = back(rail.place(own.origin) + Vec3{solved_->position.x, 0, 0});
  axes.t1 = back(rail.turn(own.t1));
  axes.t2 = back(rail.turn(own.t2));
  axes.n = back(rail.turn(own.n));
  return axes;
}

std::array<double, 2> WheelRail::profile_point(std::int32_t body, double share) const {
  require_solved();
  require_finite(share, "share");
  if (body != 1 && body != 2) fail(Status::err_argument, "which is %d; allowed: 1 (wheel), 2 (rail)", body);
  if (!(share >= 0 && share <= 1)) fail(Status::err_argument, "share is %g; allowed: 0 to 1", share);
  const RailShape& r = rail_shape_;
  const WheelsetState& here = solved_->position;
  const ProfileSlices* slices = body == 2 ? r.slices.get() : search_ ? search_->wheel_slices() : nullptr;
  const double turned = body == 1 && slices ? here.pitch + solved_->bend.pitch : 0;
  const ProfileCurve& curve = *(body == 1 ? given_wheel_ : given_rail_)->nominal_profile();
  const Vec2 at =
      slices ? section_of(*slices, body == 1 ? -turned : here.x, share) : curve.at(share * curve.length()).x;
  const double out = radius_ + at[1];  // a wheel that varies has turned with its pose
  const Vec3 x = body == 1
                     ? wheel_pose(here, solved_->z, solved_->bend)
                           .place({-out * std::sin(turned), at[0], out * std::cos(turned) - radius_})
                     : rail_pose(solved_->deviation).place(r.origin + at[0] * cross(r.down, r.along) + at[1] * r.down);
  return {side_ * x[1], x[2]};
}

}  // namespace rollcon
