/// Tells the results of a wheel on its rail after a solve. What was solved in a mirror is turned back.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "support/error.hpp"
#include "wheelrail/wheel_rail.hpp"

namespace rollcon {
namespace {

template <class Table>
const auto& find_stat(const Table& table, const char* name) {
  const auto* const found =
      std::find_if(std::begin(table), std::end(table), [&](const auto& s) { return std::string(s.name) == name; });
  if (found == std::end(table)) {
    std::string known;
    for (const auto& s : table) known += (known.empty() ? "" : ", ") + std::string(s.name);
    fail(Status::err_option, "unknown statistic '%s'; known: %s", name, known.c_str());
  }
  return *found;
}

}  // namespace

struct WheelRail::Stat {
  const char* name;
  double (*value)(const WheelRail& w);
};

const WheelRail::Stat WheelRail::stats[] = {
    {"z", [](const WheelRail& w) { return w.solved_->z; }},
    {"vertical_force", [](const WheelRail& w) { return w.vertical_force(); }},
    {"friction_power",
     [](const WheelRail& w) {
       double power = 0;
       for (const Slot* slot : w.active_) power += slot->contact.overlap().share * slot->contact.friction_power();
       return power;
     }},
    {"solves", [](const WheelRail& w) { return static_cast<double>(w.solves_); }},
};

struct WheelRail::PatchStat {
  const char* name;
  double (*value)(const WheelRail& w, const PatchContact& p);
};

const WheelRail::PatchStat WheelRail::patch_stats[] = {
    {"x",
     [](const WheelRail& w, const PatchContact& p) {
       return w.solved_->position.x + w.rail_pose(w.solved_->deviation).place(p.overlap().reference)[0];
     }},
    {"y",
     [](const WheelRail& w, const PatchContact& p) {
       return w.side_ * w.rail_pose(w.solved_->deviation).place(p.overlap().reference)[1];
     }},
    {"z", [](const WheelRail& w,
             const PatchContact& p) { return w.rail_pose(w.solved_->deviation).place(p.overlap().reference)[2]; }},
    {"angle", [](const WheelRail& w,
                 const PatchContact& p) { return w.side_ * (p.overlap().angle + w.solved_->deviation.roll); }},
    {"wheel_y", [](const WheelRail&, const PatchContact& p) { return p.overlap().wheel_y; }},
    {"rolling_radius", [](const WheelRail&, const PatchContact& p) { return p.overlap().rolling_radius; }},
    {"longitudinal_creepage", [](const WheelRail&, const PatchContact& p) { return p.creepages()[0]; }},
    {"lateral_creepage", [](const WheelRail& w, const PatchContact& p) { return w.side_ * p.creepages()[1]; }},
    {"spin", [](const WheelRail& w, const PatchContact& p) { return w.side_ * p.creepages()[2]; }},
    {"normal_force", [](const WheelRail&, const PatchContact& p) { return dot(p.force(), p.overlap().normal); }},
    {"longitudinal_force", [](const WheelRail&, const PatchContact& p) { return p.force()[0]; }},
    {"lateral_force",
     [](const WheelRail& w, const PatchContact& p) { return w.side_ * dot(p.force(), p.overlap().lateral); }},
    {"spin_moment",
     [](const WheelRail& w, const PatchContact& p) { return -w.side_ * dot(p.moment(), p.overlap().normal); }},
    {"overlap", [](const WheelRail&, const PatchContact& p) { return p.overlap().overlap; }},
    {"cut", [](const WheelRail&, const PatchContact& p) { return p.overlap().cut ? 1.0 : 0.0; }},
    {"share", [](const WheelRail&, const PatchContact& p) { return p.overlap().share; }},
    {"max_pressure", [](const WheelRail&, const PatchContact& p) { return p.max_pressure(); }},
    {"area", [](const WheelRail&, const PatchContact& p) { return p.area(); }},
    {"friction_power", [](const WheelRail&, const PatchContact& p) { return p.friction_power(); }},
    {"by_table", [](const WheelRail&, const PatchContact& p) { return p.by_table() ? 1.0 : 0.0; }},
    {"hertzian", [](const WheelRail&, const PatchContact& p) { return p.hertzian() ? 1.0 : 0.0; }},
    {"status", [](const WheelRail&, const PatchContact& p) { return static_cast<double>(p.status()); }},
};

double WheelRail::stat(const char* name) const {
  require_solved();
  return find_stat(stats, name).value(*this);
}

std::int64_t WheelRail::stat_count() {
  return std::ssize(stats);
}

const char* WheelRail::stat_name(std::int64_t i) {
  return stats[static_cast<std::size_t>(i)].name;
}

double WheelRail::patch_stat(std::int64_t i, const char* name) const {
  return find_stat(patch_stats, name).value(*this, active(i).contact);
}

std::int64_t WheelRail::patch_stat_count() {
  return std::ssize(patch_stats);
}

const char* WheelRail::patch_stat_name(std::int64_t i) {
  return patch_stats[static_cast<std::size_t>(i)].name;
}

// Sums the totals in the track, as they were solved: in the mirror for a left wheel.
WheelRail::Totals WheelRail::totals(const Vec3& centre) const {
  const Pose rail = rail_pose(solved_ ? solved_->deviation : in_.deviation);
  Totals sum;
  for (const Slot* slot : active_) {
    const PatchContact& p = slot->contact;
    const Vec3 own = p.overlap().share * rail.turn(p.force());
    sum.force = sum.force + own;
    sum.moment =
        sum.moment + p.overlap().share * rail.turn(p.moment()) + cross(rail.place(p.overlap().reference) - centre, own);
  }
  sum.vertical = vertical_force();
  return sum;
}

void WheelRail::resultant(bool of_wheelset, double* force, double* moment) const {
  require_solved();
  auto [f, m, vertical] = totals({0, solved_->position.y, solved_->z - radius_});
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
  const ProfileCurve& curve = *(body == 1 ? given_wheel_ : given_rail_)->profile();
  if (!(share >= 0 && share <= 1)) fail(Status::err_argument, "share is %g; allowed: 0 to 1", share);
  const Vec2 at = curve.at(share * curve.length()).x;
  const RailShape& r = rail_shape_;
  const Vec3 x = body == 1
                     ? wheel_pose(solved_->position, solved_->z).place({0, at[0], at[1]})
                     : rail_pose(solved_->deviation).place(r.origin + at[0] * cross(r.down, r.along) + at[1] * r.down);
  return {side_ * x[1], x[2]};
}

}  // namespace rollcon
