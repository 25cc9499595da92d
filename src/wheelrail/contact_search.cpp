#include "wheelrail/contact_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/error.hpp"
#include "wheelrail/gap_scan.hpp"

namespace rollcon {
namespace {

ProfilePlane in_track(const RailShape& rail) {
  constexpr double skew = 1e-9;
  const Vec3 across = cross(rail.down, rail.along);
  if (!(std::abs(std::abs(rail.along[0]) - 1) <= skew && std::abs(rail.down[0]) <= skew))
    fail(Status::err_argument, "the rail runs along (%g, %g, %g); allowed: along x", rail.along[0], rail.along[1],
         rail.along[2]);
  return {{rail.origin[1], rail.origin[2]}, {across[1], across[2]}, {rail.down[1], rail.down[2]}};
}

/// Refuses waves that the stations of VaryingPair would miss.
void require_long_waves(const ProfileSlices& slices, double radius, const char* body) {
  constexpr double shortest = 0.01;
  for (const ProfileWave& w : slices.waves())
    if (!(w.length >= shortest * radius))
      fail(Status::err_argument, "the %s has a wave of length %g; allowed: from %g on", body, w.length,
           shortest * radius);
}

}  // namespace

ContactSearch::ContactSearch(const WheelShape& wheel, const RailShape& rail)
    : shape_(wheel),
      side_(wheel.axis[1] < 0 ? -1 : 1),
      roller_(rail.roller),
      wheel_(wheel.curve, {{0, 0}, {side_, 0}, {0, 1}}, VisibleProfile::Seen::from_greater_z),
      rail_(rail.curve, in_track(rail), VisibleProfile::Seen::from_lesser_z) {
  double least = wheel_.cells().back().z[1];
  for (const VisibleCell& cell : wheel_.cells()) least = std::min(least, cell.z[0]);
  least += wheel.radius;
  if (!(least > 0))
    fail(Status::err_argument, "the wheel's radius is %g, and its profile reaches its axis; allowed: a greater one",
         wheel.radius);
  if (wheel.slices) require_long_waves(*wheel.slices, 1, "wheel");
  if (rail.slices) require_long_waves(*rail.slices, wheel.radius, "rail");
  if (wheel.slices)
    wheel_heights_.emplace(wheel.slices, ProfilePlane{{0, 0}, {side_, 0}, {0, 1}},
                           VisibleProfile::Seen::from_greater_z);
  if (rail.slices) rail_heights_.emplace(rail.slices, in_track(rail), VisibleProfile::Seen::from_lesser_z);
}

template <class Use>
auto ContactSearch::with_gap(const Pose& wheel, double along, Use use) const {
  const WheelLocus locus(wheel.place(shape_.centre), side_ * wheel.turn(shape_.axis), shape_.radius);
  if (!wheel_heights_ && !rail_heights_ && !roller_) return use(ProfileGap(wheel_, rail_, locus, nullptr));
  const Vec3 down = wheel.turn({0, 0, 1});
  const WheelAxes& axes = locus.axes();
  const VaryingPair varying(wheel_heights_ ? &*wheel_heights_ : nullptr, rail_heights_ ? &*rail_heights_ : nullptr,
                            rail_, roller_, along, std::atan2(dot(down, axes.ahead), dot(down, axes.down)),
                            shape_.radius);
  return use(ProfileGap(wheel_, rail_, locus, &varying));
}

double ContactSearch::first_touch(const Pose& wheel, double along) const {
  const auto nearest = with_gap(wheel, along, [](const ProfileGap& gap) { return least_gap(gap); });
  return nearest ? nearest->gap : std::numeric_limits<double>::infinity();
}

std::optional<TouchPoint> ContactSearch::touch(const Pose& wheel, double along) const {
  const auto nearest = with_gap(wheel, along, [](const ProfileGap& gap) { return least_gap(gap); });
  if (!nearest) return std::nullopt;
  const VisiblePoint p = wheel_.at(nearest->s);
  return TouchPoint{nearest->gap, nearest->wheel + Vec3{0, 0, nearest->gap}, std::atan(nearest->rail_slope),
                    side_ * p.y, shape_.radius + p.z};
}

void ContactSearch::find(const Pose& wheel, std::vector<OverlapPatch>& patch, const MergeRule& rule, double along) {
  with_gap(wheel, along, [&](const ProfileGap& gap) {
    find_overlaps(gap, overlap_);
    for (Overlap& o : overlap_) measure(gap, o);
    gather(gap, overlap_, rule, side_, shape_.radius, patch);
  });
}

double ContactSearch::rail_angle(double y) const {
  return std::atan(rail_.at_y(std::clamp(y, rail_.low(), rail_.high())).slope);
}

}  // namespace rollcon
